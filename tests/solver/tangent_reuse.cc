// How much a tangent of another place contracts: what was measured, times the strain since; steps that the
// linear solve ended do not count.
#include "check.h"

#include <amontons/solver/tangent_reuse.h>

#include <deal.II/base/mpi.h>

namespace test_tangent_reuse
{
using namespace Amontons;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const auto                               at = [](const double x) {
    LA::Vector u(dealii::complete_index_set(3), MPI_COMM_WORLD);
    u(1) = x;
    u.compress(dealii::VectorOperation::insert);
    return u;
  };
  TangentReuse tangent(0.5);
  tangent.made_at(at(1));
  check::is_close(tangent.strain_since(at(1.01)), 0.02, 1e-12, "strain");
  check::is_close(tangent.expected_contraction(at(1.01)), 2 * 1.25 * 0.02, 1e-12, "nothing is measured");

  tangent.solved(10, 1e-6);
  tangent.measure(at(1.01), 0.6); // 0.6/10 at a strain of 0.02: 3 of it
  tangent.made_at(at(2));
  check::is_close(tangent.expected_contraction(at(2.1)), 2 * 3 * 0.2, 1e-12, "as measured");

  tangent.solved(10, 0.5);
  tangent.measure(at(2.1), 4); // the linear solve left much of it
  check::is_close(tangent.expected_contraction(at(2.1)), 2 * 3 * 0.2, 1e-12, "ended by the linear solve");
  tangent.solved(10, 1e-6);
  tangent.measure(at(2.1), 0.2); // a smaller one
  check::is_close(tangent.expected_contraction(at(2.1)), 2 * 3 * 0.2, 1e-12, "the largest counts");
  return check::result();
}
} // namespace test_tangent_reuse

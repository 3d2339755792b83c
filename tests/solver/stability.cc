// Rates of growth and shapes of unstable modes of a diagonal stiffness, however slow: that of a column on a
// thin hinge is 3e-5 of the slowest that is stable.
#include "check.h"

#include <amontons/solver/stability.h>

#include <deal.II/base/mpi.h>

namespace test_stability
{
using namespace Amontons;

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr unsigned int                   n = 6;
  LA::Vector                               damping(dealii::complete_index_set(n), MPI_COMM_WORLD);
  damping = 1;
  // The first stiffness is as given; the others are 1, 2, ...
  const auto mode = [&](const double first) {
    return find_unstable_mode(
        [&](LA::Vector &y, const LA::Vector &x) {
          for (unsigned int i = 0; i < n; ++i)
            y(i) = x(i) / (i == 0 ? first : i);
          y.compress(dealii::VectorOperation::insert);
          return true;
        },
        damping);
  };
  check::is_true(!mode(0.5), "stable");
  for (const double rate : {2., 0.1, 1e-3, 1e-6})
    {
      const auto found = mode(-rate);
      check::is_true(found.has_value(), "unstable");
      if (found)
        {
          check::is_close(found->rate, rate, 1e-6 * rate, "rate of growth");
          check::is_close(std::abs(found->shape(0)), 1, 1e-6, "shape");
        }
    }
  return check::result();
}
} // namespace test_stability

// The square of the pressure, continued beyond the contact: exact where it is linear, minus its largest value
// far away, zero or less at every open node.
#include "contact/contact_scene.h"

#include <amontons/contact/contact_edge.h>

namespace test_contact_edge
{
// p^2 = end - slope . X where that is positive.
template <int dim>
void
check_edge(const Tensor<1, dim> &slope, const double end, const unsigned int degree)
{
  const std::array<unsigned int, 3> n = {{8, dim == 2 ? 1u : 8u, 1}};
  Scene                             scene;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, dim == 2 ? 0. : 1.}, {{1, 1, 1}}),
                  block("upper",
                        {0, dim == 2 ? 1. : 0., dim == 2 ? 0. : 1.},
                        {1, dim == 2 ? 2. : 1., dim == 2 ? 0. : 2.},
                        n)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<dim> problem(scene, degree);
  const auto        &slave = problem.slave();

  SurfaceFields<dim> fields;
  double             largest = 0;
  for (const auto &node : slave.nodes)
    {
      const double square = end - slope * node.X;
      fields.state.push_back(square > 0 ? ContactStatus::slip : ContactStatus::open);
      fields.pressure.push_back(std::sqrt(std::max(0., square)));
      largest = std::max(largest, square);
    }
  // Of nodes as far as two faces: those whose faces hold a node under pressure see its neighbours, too.
  const auto   result = signed_pressure_square(problem.interfaces[0], fields);
  const double near = 1. / 8, steepest = slope.norm();
  unsigned int n_continued = 0, n_far = 0;
  for (unsigned int i = 0; i < slave.nodes.size(); ++i)
    {
      const double square = end - slope * slave.nodes[i].X;
      if (square > 0 || -square < 0.5 * near * steepest)
        {
          check::is_close(result[i], square, 1e-10, "p^2, in and beside the contact", largest);
          n_continued += square < 0;
        }
      else if (-square > 3 * near * steepest)
        {
          check::is_close(result[i], -largest, 1e-14, "far from the contact");
          ++n_far;
        }
      else
        check::is_true(result[i] <= 0, "open nodes stay open");
    }
  check::is_true(n_continued > 0 && n_far > 0, "there are nodes of both kinds");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_edge<2>(Tensor<1, 2>({2, 0}), 0.97, degree);
      check_edge<3>(Tensor<1, 3>({2, 0, 0}), 0.97, degree);
      check_edge<3>(Tensor<1, 3>({1, 1.1, 0}), 0.8, degree);
    }
  return check::result();
}
} // namespace test_contact_edge

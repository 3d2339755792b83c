// Two bodies face each other across a wide gap, whatever other bodies lie in it.
#include "contact/contact_scene.h"

#include <amontons/contact/surface_search.h>

namespace test_facing
{
template <int dim>
void
test_third_body()
{
  const double depth = dim == 2 ? 0 : 1;
  const auto   layer = [&](const std::string &name, const double from, const double to) {
    Point<3> lower(0, 0, 0), upper(1, depth, 0);
    lower[dim - 1] = from;
    upper[dim - 1] = to;
    return block(name, lower, upper, {{4, dim == 2 ? 1u : 4u, 1}});
  };
  Scene scene;
  scene.bodies = {layer("lower", 0, 1), layer("between", 1.4, 1.6), layer("upper", 2, 3)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<dim> problem(scene, 1);
  check::is_true(!problem.coupling().points.empty(), "the other side is found");
  try
    {
      refuse_hidden_sides(*problem.discretization, problem.interfaces);
    }
  catch (const InputError &error)
    {
      check::is_true(false, std::to_string(dim) + "D: " + error.what());
    }
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_third_body<2>();
  test_third_body<3>();
  return check::result();
}
} // namespace test_facing

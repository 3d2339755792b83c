// The first meshes: cells behind faces that touch first are marked once, those of rigid bodies never.
#include "contact/contact_scene.h"

#include <amontons/adaptivity/first_mesh.h>
#include <amontons/adaptivity/mesh_refinement.h>

namespace test_mesh_refinement
{
// Two rows of ten cells of 0.1 whose gap opens from x = 0 on.
template <int dim>
Scene
opening(const bool rigid_master)
{
  Scene                             scene;
  const std::array<unsigned int, 3> n     = {{10, dim == 2 ? 1u : 6u, 1}};
  const double                      depth = dim == 2 ? 1 : 0.6;
  const std::array<std::string, 2>  names = {{"lower", "upper"}};
  for (const unsigned int b : {0, 1})
    scene.bodies.push_back(dim == 2 ? block(names[b], {0, 1. * b, 0}, {1, 1. + b, 0}, n)
                                    : block(names[b], {0, 0, 1. * b}, {1, depth, 1. + b}, n));
  if (rigid_master)
    {
      scene.bodies[1].rigid       = MotionData();
      scene.bodies[1].rigid->name = "upper";
    }
  scene.pairs                = {pair_of({"lower", "top", {}}, {"upper", "bottom", {}})};
  scene.pairs[0].initial_gap = Expression("x", {});
  return scene;
}

// How many cells of each body are marked, on all ranks.
template <int dim>
std::array<unsigned int, 2>
marked(const Problem<dim> &problem)
{
  std::array<unsigned int, 2> n = {{0, 0}};
  for (const auto &cell : problem.geometry.triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cell->refine_flag_set())
      ++n[cell->material_id()];
  return {{Utilities::MPI::sum(n[0], MPI_COMM_WORLD), Utilities::MPI::sum(n[1], MPI_COMM_WORLD)}};
}

// The points of the faces up to x = 0.2, 12 of them in 3D, have gaps up to 1.2 faces above the smallest.
template <int dim>
void
test_close_cells(const bool rigid_master)
{
  const std::string  what = std::to_string(dim) + "D" + (rigid_master ? ", rigid master: " : ": ");
  const unsigned int n    = dim == 2 ? 2 : 12;
  Problem<dim>       problem(opening<dim>(rigid_master), 1);
  const auto         mark = [&](const double distance) {
    return mark_close_cells(*problem.discretization, problem.interfaces, distance);
  };
  check::is_close(mark(1.2), rigid_master ? n : 2 * n, 0, what + "cells that are said to be marked");
  check::is_close(marked(problem)[0], n, 0, what + "marked cells of the slave");
  check::is_close(marked(problem)[1], rigid_master ? 0 : n, 0, what + "marked cells of the master", 1);
  check::is_close(mark(1.2), 0, 0, what + "cells that were marked already", 1);
  check::is_close(mark(100), 0, 0, what + "all faces are close", 1);
}

// Eight faces that are close are enough, seven are not.
void
test_enough()
{
  const Problem<2> problem(opening<2>(false), 1);
  check::is_close(
      mark_close_cells(*problem.discretization, problem.interfaces, 7.2), 0, 0, "eight faces are close", 1);
  check::is_close(
      mark_close_cells(*problem.discretization, problem.interfaces, 6.2), 14, 0, "seven faces are close");
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool rigid_master : {false, true})
    {
      test_close_cells<2>(rigid_master);
      test_close_cells<3>(rigid_master);
    }
  test_enough();
  return check::result();
}
} // namespace test_mesh_refinement

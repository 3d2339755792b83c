// A ball that presses on one face of a block: the place and the radius of Hertz's contact, and cells that are
// refined to it there alone. No contact is small where the load is large, or the pair is tied.
#include "contact/contact_scene.h"

#include <amontons/adaptivity/small_contacts.h>
#include <amontons/contact/surface_fields.h>

namespace test_small_contacts
{
constexpr double radius = 0.5, young = 1e4, poisson = 0.25;

// The ball below (0.6, 0.4), in the face from (0, 0) to (1, 1).
Scene
block_on_ball(const bool tied)
{
  ObstacleData ball;
  ball.type             = ObstacleData::Type::sphere;
  ball.radius           = radius;
  ball.centre           = {0.6, 0.4, -radius};
  auto body             = block("block", {-2, -2, 0}, {2, 2, 2}, {{4, 4, 2}});
  body.material.young   = young;
  body.material.poisson = poisson;
  auto scene            = scene_with_obstacle(body, "bottom", ball);
  scene.pairs[0].tied   = tied;
  return scene;
}

// A pressure at the corners of that face, and what it comes to.
std::pair<SurfaceFields<3>, double>
pressed(const Problem<3> &problem, const double pressure)
{
  SurfaceFields<3> fields;
  for (const auto &node : problem.slave().nodes)
    fields.pressure.push_back(std::max(std::abs(node.X[0] - 0.5), std::abs(node.X[1] - 0.5)) < 0.6 ? pressure
                                                                                                   : 0.);
  double force = 0;
  for (const auto &p : problem.coupling().points)
    force += p.weight * value_on_face(problem.slave(), fields.pressure, p.slave_face, p.xi_slave);
  return {fields, force};
}

void
test_size_and_place()
{
  Problem<3> problem(block_on_ball(false), 1);
  const auto [fields, force] = pressed(problem, 0.5);
  const auto contacts        = small_contacts(*problem.discretization, problem.interfaces, {fields});
  check::is_true(contacts.size() == 1, "one contact, of the block alone");
  if (contacts.size() != 1)
    return;
  const double size = std::cbrt(0.75 * force * radius / (young / (1 - poisson * poisson)));
  // The fit sees more than the paraboloid of the sphere's apex.
  check::is_close(contacts[0].size, size, 0.2, "Hertz's radius");
  check::is_true(contacts[0].place.distance(Point<3>(0.6, 0.4, 0)) < 0.1, "its place");

  unsigned int n_rounds = 0;
  for (; n_rounds < 10 && mark_cells_at(*problem.discretization, contacts) > 0; ++n_rounds)
    problem.geometry.triangulation.execute_coarsening_and_refinement();
  double at_place = 0;
  for (const auto &cell : problem.geometry.triangulation.active_cell_iterators())
    if (cell->material_id() == 0 && cell->bounding_box().point_inside(contacts[0].place))
      at_place = std::max(at_place, cell->diameter() / std::sqrt(3.));
  check::is_true(at_place > 0 && at_place <= contacts[0].size * (1 + 1e-9), "cells as small as the contact");
  check::is_true(at_place > contacts[0].size / 2, "no smaller");
  check::is_true(problem.geometry.triangulation.n_active_cells() < 100 * n_rounds, "there alone");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_size_and_place();
  {
    Problem<3> problem(block_on_ball(false), 1);
    check::is_true(
        small_contacts(*problem.discretization, problem.interfaces, {pressed(problem, 5e4).first}).empty(),
        "half of a face is not small");
    check::is_true(
        small_contacts(*problem.discretization, problem.interfaces, {pressed(problem, 0).first}).empty(),
        "no force");
  }
  Problem<3> tied(block_on_ball(true), 1);
  check::is_true(small_contacts(*tied.discretization, tied.interfaces, {pressed(tied, 0.5).first}).empty(),
                 "tied");
  return check::result();
}
} // namespace test_small_contacts

// Which bodies may slide along the planes that they touch.
#include "check.h"

#include <amontons/discretization/free_slides.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace test_free_slides
{
using namespace Amontons;

// A block on a plane through its lowest face, loaded onto it.
template <int dim>
Scene
block_on_plane()
{
  Scene scene;
  scene.kind = dim == 2 ? ProblemType::plane_strain : ProblemType::three_dimensional;
  BodyData body;
  body.name                = "block";
  body.upper               = Point<3>(1, 2, 3);
  body.body_force[dim - 1] = Expression(-1);
  scene.bodies             = {body};
  ObstacleData plane;
  plane.name            = "floor";
  plane.motion.name     = "floor";
  plane.normal          = Tensor<1, 3>();
  plane.normal[dim - 1] = 1;
  for (auto &displacement : plane.motion.displacement)
    displacement = Expression(0);
  scene.obstacles = {plane};
  PairData pair;
  pair.name     = "foot";
  pair.first    = {"block", "bottom", {}};
  pair.obstacle = "floor";
  scene.pairs   = {pair};
  return scene;
}

template <int dim>
FullMatrix<double>
motions(const Scene &scene)
{
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  const auto slides = find_free_slides(scene, geometry);
  check::is_true(slides.size() <= 1, "one group of bodies");
  return slides.empty() ? FullMatrix<double>(0, 0) : slides[0].motions;
}

// The largest |v . d| of all motions over some points.
template <int dim>
double
largest_along(const FullMatrix<double> &motions, const Tensor<1, dim> &d)
{
  double largest = 0;
  for (const double x : {0., 1.})
    for (const double y : {-1., 0.7})
      for (unsigned int k = 0; k < motions.n(); ++k)
        {
          Tensor<1, dim> X;
          X[0]        = x;
          X[dim - 1]  = y;
          double flow = 0;
          for (unsigned int i = 0; i < motions.m(); ++i)
            for (unsigned int c = 0; c < dim; ++c)
              flow += motions(i, k) * rigid_motion<dim>(i, X, c) * d[c];
          largest = std::max(largest, std::abs(flow));
        }
  return largest;
}

template <int dim>
void
check_block()
{
  const std::string in    = " in " + std::to_string(dim) + "D";
  const Scene       scene = block_on_plane<dim>();
  Tensor<1, dim>    up;
  up[dim - 1] = 1;

  const auto all = motions<dim>(scene);
  check::is_true(all.n() == (dim == 2 ? 1 : 3), "along the plane and about its normal" + in);
  check::is_true(largest_along<dim>(all, up) < 1e-14, "no motion off the plane" + in);

  Scene with             = scene;
  with.pairs[0].friction = Expression(0.1);
  check::is_true(motions<dim>(with).n() == 0, "friction holds" + in);

  with                         = scene;
  with.bodies[0].body_force[0] = Expression("sin(pi*t)", SourceLocation());
  check::is_true(motions<dim>(with).n() == (dim == 2 ? 0 : 1),
                 "a force along the plane for some time drives" + in);

  with                         = scene;
  with.bodies[0].body_force[0] = Expression(1e-6);
  check::is_true(motions<dim>(with).n() == (dim == 2 ? 0 : 1),
                 "a small force along the plane drives, too" + in);
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(with, geometry);
  check::is_true(find_free_slides(with, geometry, false)[0].motions.n() == all.n(), "without forces" + in);

  with                                                = scene;
  with.obstacles[0].motion.rotation[dim == 2 ? 2 : 0] = Expression("0.1*t", SourceLocation());
  check::is_true(motions<dim>(with).n() == 0, "the plane turns" + in);

  with                   = scene;
  with.obstacles[0].size = 5;
  check::is_true(motions<dim>(with).n() == 0, "the plane has edges" + in);

  with                   = scene;
  with.obstacles[0].type = ObstacleData::Type::sphere;
  check::is_true(motions<dim>(with).n() == 0, "not a plane" + in);

  with = scene;
  with.pairs.clear();
  check::is_true(motions<dim>(with).n() == 0, "touches no plane" + in);

  with = scene;
  ConditionData wall;
  wall.type                     = ConditionData::Type::symmetry;
  wall.boundaries               = {{"block", "left", {}}};
  with.conditions               = {wall};
  with.bodies[0].rotation_angle = 30; // about z: the wall is not along an axis
  if (dim == 3)
    {
      const auto along_wall = motions<dim>(with);
      check::is_true(along_wall.n() == 1, "a plane of symmetry leaves one direction");
      Tensor<1, dim> normal;
      normal[0] = std::cos(dealii::numbers::PI / 6);
      normal[1] = std::sin(dealii::numbers::PI / 6);
      check::is_true(largest_along<dim>(along_wall, normal) < 1e-14, "along the plane of symmetry");
    }

  with            = scene;
  wall.type       = ConditionData::Type::pressure;
  with.conditions = {wall};
  check::is_true(motions<dim>(with).n() == 0, "pressure follows the surface" + in);

  with                       = scene;
  wall.type                  = ConditionData::Type::displacement;
  wall.displacement[dim - 1] = Expression(-0.1);
  with.conditions            = {wall};
  check::is_true(motions<dim>(with).n() == all.n(),
                 "a displacement across the plane holds nothing along it" + in);
  wall.displacement[0] = Expression(0);
  with.conditions      = {wall};
  check::is_true(motions<dim>(with).n() == (dim == 2 ? 0 : 1), "one along it does" + in);

  // A second block on the first: they slide together, whatever the friction between them.
  with = scene;
  with.bodies.push_back(with.bodies[0]);
  with.bodies[1].name = "rider";
  PairData between;
  between.name     = "between";
  between.first    = {"rider", "bottom", {}};
  between.second   = BoundaryName{"block", "top", {}};
  between.friction = Expression(0.5);
  with.pairs.push_back(between);
  check::is_true(motions<dim>(with).n() == all.n(), "two bodies together" + in);
  with.conditions               = {wall};
  with.conditions[0].boundaries = {{"rider", "left", {}}};
  check::is_true(motions<dim>(with).n() == (dim == 2 ? 0 : 1), "what holds one holds both" + in);
}

// How many turns carry a body along all of its own surface.
template <int dim>
unsigned int
n_turns(const BodyData &body)
{
  Scene scene = block_on_plane<dim>();
  scene.pairs.clear();
  scene.bodies = {body};
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  return motions_along_surfaces(geometry, {true})[0].n();
}

// A turn of a slender body about its length moves its surface little, compared with its size, but through
// itself.
void
check_turns()
{
  BodyData body;
  body.name = "body";
  for (const double length : {1., 20., 1000.})
    {
      body.upper = Point<3>(length, 1.2, 1);
      body.cells = {{3, 2, 2}};
      check::is_true(n_turns<3>(body) == 0 && n_turns<2>(body) == 0,
                     "none of a block of length " + std::to_string(length));
    }
  for (const unsigned int refinements : {0, 2})
    {
      body.refinements = refinements;
      body.shape       = "disk";
      check::is_true(n_turns<2>(body) == 1, "one of a disk");
      for (const char *const shape : {"cylinder", "half sphere"})
        for (const double length : {0.1, 1., 100.})
          {
            body.shape  = shape;
            body.length = length;
            check::is_true(n_turns<3>(body) == 1, "one of a " + body.shape);
          }
    }
}

// A ring of 16 arcs through three nodes, that is refined: its new nodes are beside the circle, by as much as
// ellipses are that are next to it; it turns, and those do not.
void
check_arcs()
{
  constexpr unsigned int n = 16;
  for (const double ratio : {1., 0.9995, 0.998, 0.9})
    {
      std::ostringstream nodes, elements;
      for (unsigned int k = 0; k < 2 * n; ++k)
        for (const unsigned int r : {2, 3, 4})
          nodes << 10 * k + r << ", " << 0.5 * r * std::cos(dealii::numbers::PI / n * k) << ", "
                << ratio * 0.5 * r * std::sin(dealii::numbers::PI / n * k) << '\n';
      for (unsigned int k = 0; k < 2 * n; k += 2)
        {
          const unsigned int a = 10 * k, between = a + 10, b = 10 * ((k + 2) % (2 * n));
          elements << k + 1 << ", " << a + 2 << ", " << a + 4 << ", " << b + 4 << ", " << b + 2 << ", "
                   << a + 3 << ", " << between + 4 << ", " << b + 3 << ", " << between + 2 << '\n';
        }
      BodyData body;
      body.name      = "ring";
      body.shape     = "file";
      body.mesh_file = "free_slides_ring.inp";
      std::ofstream(body.mesh_file) << std::setprecision(16) << "*NODE\n"
                                    << nodes.str() << "*ELEMENT, TYPE=CPS8\n"
                                    << elements.str();
      for (body.refinements = 0; body.refinements < 3; ++body.refinements)
        check::is_true(n_turns<2>(body) == (ratio == 1 ? 1 : 0),
                       "turns of a ring of arcs, " + std::to_string(ratio) + ", refined " +
                           std::to_string(body.refinements));
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_block<2>();
  check_block<3>();
  check_turns();
  check_arcs();
  return check::result();
}
} // namespace test_free_slides

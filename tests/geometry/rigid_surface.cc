// Rays meet the analytic obstacles where geometry by hand says, on the side that faces them.
#include "check.h"

#include <amontons/geometry/rigid_surface.h>

namespace test_rigid_surface
{
using namespace Amontons;
using Type = ObstacleData::Type;

template <int dim>
void
check_hit(const ObstacleData       &obstacle,
          const dealii::Point<dim> &x,
          dealii::Tensor<1, dim>    n,
          const dealii::Point<dim> &expected,
          const std::string        &what)
{
  const auto hit = project_to_obstacle<dim>(obstacle, x, n / n.norm());
  check::is_true(hit.has_value(), what + ": there is a point");
  if (hit)
    {
      check::is_close(hit->x.distance(expected), 0, 1e-12, what, 1);
      check::is_close(hit->normal.norm(), 1, 1e-12, what + ": unit normal");
      check::is_true(hit->normal * n < 0, what + ": the normal faces the ray");
    }
}

template <int dim>
void
check_miss(const ObstacleData       &obstacle,
           const dealii::Point<dim> &x,
           dealii::Tensor<1, dim>    n,
           const std::string        &what)
{
  check::is_true(!project_to_obstacle<dim>(obstacle, x, n / n.norm()), what);
}

ObstacleData
make(const Type type)
{
  ObstacleData obstacle;
  obstacle.type = type;
  return obstacle;
}

void
check_in_plane()
{
  using P = Point<2>;
  using V = Tensor<1, 2>;
  const V down({0, -1}), up({0, 1}), oblique({1, -1});

  ObstacleData plane = make(Type::plane);
  plane.centre       = {0, 1, 0};
  check_hit<2>(plane, P(3, 3), down, P(3, 1), "plane");
  check_hit<2>(plane, P(3, 0), down, P(3, 1), "plane, penetrated");
  check_hit<2>(plane, P(3, 3), oblique, P(5, 1), "plane, oblique");
  check_miss<2>(plane, P(3, 3), up, "the plane's back");
  check_miss<2>(plane, P(3, 3), V({1, 0}), "parallel to the plane");
  plane.size = 2;
  check_hit<2>(plane, P(2, 3), down, P(2, 1), "edge of the punch");
  check_miss<2>(plane, P(2.001, 3), down, "beyond the punch");

  ObstacleData circle = make(Type::sphere);
  circle.centre       = {1, 0, 0};
  circle.radius       = 5;
  check_hit<2>(circle, P(4, 7), down, P(4, 4), "circle");
  check_hit<2>(circle, P(4, 3), down, P(4, 4), "circle, penetrated");
  check_miss<2>(circle, P(7, 7), down, "beside the circle");
  circle.hollow = true;
  check_hit<2>(circle, P(4, 3), up, P(4, 4), "hollow circle");
  check_hit<2>(circle, P(4, 3), down, P(4, -4), "hollow circle, below");

  ObstacleData parabola = make(Type::paraboloid);
  parabola.radius       = 2;
  check_hit<2>(parabola, P(2, 3), down, P(2, -1), "parabola along its axis");
  check_hit<2>(parabola, P(2, -3), down, P(2, -1), "parabola, penetrated");
  check_hit<2>(parabola, P(0, 0.75), oblique, P(1, -0.25), "parabola, the facing one of two points");
  check_miss<2>(parabola, P(0, 3), oblique, "past the parabola");
  parabola.size = 1;
  check_miss<2>(parabola, P(2, 3), down, "beyond the limited parabola");

  ObstacleData wedge = make(Type::cone);
  wedge.flank        = 45;
  check_hit<2>(wedge, P(2, 3), down, P(2, -2), "wedge along its axis");
  check_hit<2>(wedge, P(-2, 3), down, P(-2, -2), "wedge, left flank");
  check_hit<2>(wedge, P(0, 1), V({1, -2}), P(1, -1), "wedge, oblique");
  check_hit<2>(wedge, P(3, 1), V({-1, -1}), P(1, -1), "wedge, parallel to the other flank");
  check_miss<2>(wedge, P(1, 3), V({-1, -1}), "past the wedge");
  check_hit<2>(wedge, P(0, 1), down, P(0, 0), "tip of the wedge");
  wedge.size = 1;
  check_miss<2>(wedge, P(2, 3), down, "beyond the limited wedge");
}

void
check_in_space()
{
  using P = Point<3>;
  using V = Tensor<1, 3>;
  const V down({0, 0, -1});

  ObstacleData plane = make(Type::plane);
  plane.normal       = V({0, 1, 1});
  check_hit<3>(plane, P(1, 2, 5), down, P(1, 2, -2), "inclined plane");

  ObstacleData sphere = make(Type::sphere);
  sphere.radius       = 3;
  check_hit<3>(sphere, P(1, 2, 5), down, P(1, 2, 2), "sphere");
  // the nearer point looks away from the ray, which then takes the farther one, where the line leaves the
  // ball
  check_hit<3>(sphere, P(6, 6, 3), V({2, 2, 1}), P(-2, -2, -1), "sphere, behind the ray");

  ObstacleData cylinder = make(Type::cylinder);
  cylinder.radius       = 5;
  cylinder.axis         = V({2, 0, 0});
  check_hit<3>(cylinder, P(7, 3, 10), down, P(7, 3, 4), "cylinder");
  check_miss<3>(cylinder, P(0, 3, 10), V({1, 0, 0}), "along the cylinder");
  cylinder.hollow = true;
  check_hit<3>(cylinder, P(7, 3, 0), down, P(7, 3, -4), "hollow cylinder");

  ObstacleData paraboloid = make(Type::paraboloid);
  paraboloid.normal       = V({0, 0, 1});
  paraboloid.radius       = 2;
  paraboloid.centre       = {0, 0, 1};
  check_hit<3>(paraboloid, P(1, 1, 5), down, P(1, 1, 0.5), "paraboloid");

  ObstacleData cone = make(Type::cone);
  cone.normal       = V({0, 0, 2});
  cone.flank        = 45;
  check_hit<3>(cone, P(3, 4, 9), down, P(3, 4, -5), "cone");
  cone.size = 4.9;
  check_miss<3>(cone, P(3, 4, 9), down, "beyond the cone");
}

int
main(int, char **)
{
  check_in_plane();
  check_in_space();
  return check::result();
}
} // namespace test_rigid_surface

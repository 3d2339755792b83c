// Overlaps: in space the common part of random quadrilaterals, the part of a face that lies opposite of an
// obstacle, and the gaps there, against areas and integrals by hand, and polygons whose edges meet but for
// rounding; in the plane points next to the ends of a face.
#include "contact/contact_scene.h"

#include <amontons/contact/face_overlap.h>
#include <amontons/contact/polygon_clipping.h>

namespace test_face_overlap
{
std::mt19937 generator(1);

double
random_number(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(generator);
}

using Quadrilateral = std::array<Point<2>, 4>; // lexicographic

// A square of side 1 whose corners move by up to `distortion`, at a random place.
Quadrilateral
random_quadrilateral(const double distortion)
{
  const double  x = random_number(-0.5, 0.5), y = random_number(-0.5, 0.5), angle = random_number(-0.5, 0.5);
  Quadrilateral corners;
  for (unsigned int v = 0; v < 4; ++v)
    {
      const double a = v % 2 + random_number(-distortion, distortion),
                   b = v / 2 + random_number(-distortion, distortion);
      corners[v]     = {x + a * std::cos(angle) - b * std::sin(angle),
                        y + a * std::sin(angle) + b * std::cos(angle)};
    }
  return corners;
}

double
cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// Area and first moment of the common part: its corners are the corners of one that lie in the other and
// where edges meet, in the order of their angles.
std::pair<double, Tensor<1, 2>>
intersect(const Quadrilateral &a, const Quadrilateral &b)
{
  const std::array<unsigned int, 4> around = {{0, 1, 3, 2}};
  const auto                        is_in  = [&](const Point<2> &p, const Quadrilateral &q) {
    bool inside = true;
    for (unsigned int i = 0; i < 4; ++i)
      inside = inside && cross(q[around[(i + 1) % 4]] - q[around[i]], p - q[around[i]]) > 0;
    return inside;
  };
  std::vector<Point<2>> corners;
  for (unsigned int v = 0; v < 4; ++v)
    {
      if (is_in(a[v], b))
        corners.push_back(a[v]);
      if (is_in(b[v], a))
        corners.push_back(b[v]);
      for (unsigned int w = 0; w < 4; ++w)
        {
          const Point<2>    &p = a[around[v]], &q = b[around[w]];
          const Tensor<1, 2> s = a[around[(v + 1) % 4]] - p, t = b[around[(w + 1) % 4]] - q;
          const double       alpha = cross(q - p, t) / cross(s, t), beta = cross(q - p, s) / cross(s, t);
          if (alpha > 0 && alpha < 1 && beta > 0 && beta < 1)
            corners.push_back(p + alpha * s);
        }
    }
  double       area = 0;
  Tensor<1, 2> moment, middle;
  for (const auto &p : corners)
    middle += 1. / corners.size() * Tensor<1, 2>(p);
  std::sort(corners.begin(), corners.end(), [&](const Point<2> &p, const Point<2> &q) {
    return std::atan2(p[1] - middle[1], p[0] - middle[0]) < std::atan2(q[1] - middle[1], q[0] - middle[0]);
  });
  for (unsigned int i = 0; i < corners.size(); ++i)
    {
      const Tensor<1, 2> p = corners[i], q = corners[(i + 1) % corners.size()];
      area += 0.5 * cross(p - middle, q - middle);
      moment += 0.5 * cross(p - middle, q - middle) * (p + q + middle) / 3;
    }
  return {area, moment};
}

// Puts the only face of the surface of a block into the plane z = height.
void
reshape(ContactSurface<3> &surface, const Quadrilateral &corners, const double height)
{
  const auto at = [&](const Point<2> &xi) {
    Point<3> p(0, 0, height);
    for (unsigned int v = 0; v < 4; ++v)
      for (unsigned int d = 0; d < 2; ++d)
        p[d] += (v % 2 == 1 ? xi[0] : 1 - xi[0]) * (v / 2 == 1 ? xi[1] : 1 - xi[1]) * corners[v][d];
    return p;
  };
  auto              &face = surface.faces[0];
  const unsigned int g = ContactSurface<3>::geometry_degree, p = surface.degree;
  for (unsigned int k = 0; k < face.geometry.size(); ++k)
    face.geometry[k] = at({double(k % (g + 1)) / g, double(k / (g + 1)) / g});
  for (unsigned int k = 0; k < face.nodes.size(); ++k)
    surface.nodes[face.nodes[k]].X = at({double(k % (p + 1)) / p, double(k / (p + 1)) / p});
  face.size   = face.geometry.front().distance(face.geometry.back());
  face.centre = at({0.5, 0.5});
}

void
check_quadrilaterals(const unsigned int degree)
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, -1}, {1, 1, 0}, {{1, 1, 1}}),
                  block("upper", {0, 0, 0}, {1, 1, 1}, {{1, 1, 1}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  Problem<3>   problem(scene, degree);
  auto        &slave = *problem.interfaces[0].slave, &master = *problem.interfaces[0].master_surface;
  unsigned int n_empty = 0;
  for (unsigned int sample = 0; sample < 200; ++sample)
    {
      const double gap = sample % 3 == 0 ? 0.1 : 0, distortion = sample % 2 == 0 ? 0.2 : 0;
      const auto   a = random_quadrilateral(distortion), b = random_quadrilateral(distortion);
      reshape(slave, a, gap);
      reshape(master, b, 0);
      std::vector<OverlapPoint<3>> points;
      overlap_faces(slave, 0, master, {0}, 1, 0.1, points);
      const auto [expected, first] = intersect(a, b);
      n_empty += expected == 0;
      double       area = 0;
      Tensor<1, 3> moment;
      for (const auto &p : points)
        {
          area += p.weight;
          moment += p.weight * p.x_slave;
          check::is_true(p.weight > 0, "positive weights");
          check::is_close(p.gap, gap, 1e-12, "gap of parallel faces", 1);
          for (unsigned int d = 0; d < 2; ++d)
            check::is_true(p.xi_slave[d] > -1e-10 && p.xi_slave[d] < 1 + 1e-10 && p.xi_master[d] > -1e-10 &&
                               p.xi_master[d] < 1 + 1e-10,
                           "points lie in both faces");
          check::is_close((p.x_master - p.x_slave - p.gap * p.normal).norm(), 0, 1e-12, "opposite points", 1);
          check::is_close(
              slave.position(0, p.xi_slave).distance(p.x_slave), 0, 1e-13, "places on the slave", 1);
          check::is_close(
              master.position(0, p.xi_master).distance(p.x_master), 0, 1e-13, "places on the master", 1);
        }
      check::is_close(area, expected, 1e-12, "area of the common part", 1);
      for (unsigned int d = 0; d < 2; ++d)
        check::is_close(moment[d], first[d], 1e-12, "first moment of the common part", 1);
    }
  check::is_true(n_empty > 0 && n_empty < 100, "some faces do not meet");
}

struct Cover
{
  double area = 0, gap = 0; // int 1, int g
};

// The flat top of a block, [-1, 1]^2 at z = 0, of 10 x 10 faces below an obstacle.
Cover
cover(ObstacleData obstacle, const unsigned int degree = 1)
{
  obstacle.normal = Tensor<1, 3>({0, 0, -1});
  const Problem<3> problem(
      scene_with_obstacle(block("it", {-1, -1, -1}, {1, 1, 0}, {{10, 10, 1}}), "top", obstacle), degree);
  check_weights(problem, "below an obstacle");
  Cover  result;
  double rows = 0;
  for (const auto &row : problem.coupling().rows)
    rows += row.area;
  for (const auto &p : problem.coupling().points)
    {
      result.area += p.weight;
      result.gap += p.weight * p.gap;
    }
  check::is_close(rows, result.area, 1e-12, "areas of the rows");
  return result;
}

void
check_obstacles()
{
  using Type = ObstacleData::Type;
  ObstacleData obstacle;
  obstacle.centre = {0, 0, 0.25};
  for (const unsigned int degree : {1, 2})
    {
      const auto plane = cover(obstacle, degree);
      check::is_close(plane.area, 4, 1e-12, "plane: area");
      check::is_close(plane.gap, 1, 1e-12, "plane: gap");
    }

  obstacle.type         = Type::paraboloid;
  obstacle.radius       = 3;
  const auto paraboloid = cover(obstacle);
  check::is_close(paraboloid.area, 4, 1e-12, "paraboloid: area");
  check::is_close(paraboloid.gap, 1 + 8. / 3 / 6, 1e-12, "paraboloid: int of r^2/(2R)");

  // 2 int_-1^1 (R - sqrt(R^2 - x^2)) dx = 4R - 2 (sqrt(R^2 - 1) + R^2 asin(1/R))
  const double R      = 3;
  obstacle.type       = Type::cylinder;
  obstacle.centre     = {0, 0, 0.25 + R};
  obstacle.axis       = Tensor<1, 3>({0, 1, 0});
  const auto cylinder = cover(obstacle, 2);
  check::is_close(cylinder.area, 4, 1e-12, "cylinder: area");
  check::is_close(
      cylinder.gap, 1 + 4 * R - 2 * (std::sqrt(R * R - 1) + R * R * std::asin(1 / R)), 1e-9, "cylinder: gap");
  obstacle.axis = Tensor<1, 3>({1, 0, 0});
  check::is_close(cover(obstacle, 2).gap, cylinder.gap, 1e-12, "cylinder, turned: gap");

  obstacle.type     = Type::sphere;
  const auto sphere = cover(obstacle, 2);
  double     exact  = 0; // midpoint rule
  const int  n      = 1000;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      {
        const double x = (i + 0.5) / n, y = (j + 0.5) / n;
        exact += 4. / n / n * (0.25 + R - std::sqrt(R * R - x * x - y * y));
      }
  check::is_close(sphere.area, 4, 1e-12, "sphere: area");
  check::is_close(sphere.gap, exact, 1e-6, "sphere: gap");

  // int of r over the square: 4/3 (sqrt 2 + asinh 1); the apex is a corner of four faces
  obstacle.type   = Type::cone;
  obstacle.centre = {0, 0, 0.25};
  obstacle.flank  = 20;
  const auto cone = cover(obstacle, 2);
  check::is_close(cone.area, 4, 1e-12, "cone: area");
  check::is_close(cone.gap,
                  1 + std::tan(20 * numbers::PI / 180) * 4. / 3 * (std::sqrt(2.) + std::asinh(1.)),
                  1e-4,
                  "cone: gap");

  // With an edge: disks of radius w. The edge is straight within a lattice square (side s = 0.025), so that a
  // strip of up to s^2/(8 w) is lost.
  for (const double w : {0.33, 0.61, 0.99})
    for (const auto type : {Type::plane, Type::paraboloid, Type::cone})
      {
        const std::string what = "an obstacle of half width " + std::to_string(w);
        const double      s = 0.025 * std::sqrt(2.), area = numbers::PI * w * w;
        obstacle.type      = type;
        obstacle.centre    = {0, 0, 0.25};
        obstacle.size      = w;
        const auto covered = cover(obstacle);
        check::is_true(covered.area <= area * (1 + 1e-12), what + ": not too large");
        check::is_close(covered.area, area, s * s / (4 * w * w), what + ": area");
        const double gap = type == Type::plane ? 0
                           : type == Type::paraboloid
                               ? numbers::PI * std::pow(w, 4) / 4 / R
                               : std::tan(20 * numbers::PI / 180) * 2 * numbers::PI / 3 * w * w * w;
        check::is_close(covered.gap, 0.25 * area + gap, s * s / (2 * w * w), what + ": gap");
      }
}

// An edge of the polygon on one of the window's, but for rounding: the cut polygon and the vertex that its
// triangles have in common stay the same.
void
check_rounding()
{
  const std::vector<Point<2>> window = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                              exact  = {{0.21, 0}, {0.93, 0}, {0.72, 0.66}, {0.3, 0.58}};
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      Polygon<double> polygon;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const Point<2> &p = exact[(i + trial) % 4];
          polygon.emplace_back(p[1] == 0 ? Point<2>(p[0], random_number(-1e-15, 1e-15)) : p);
        }
      for (unsigned int i = 0; i < 4; ++i)
        polygon = cut(polygon, Components<2, double>(window[i]), Components<2, double>(window[(i + 1) % 4]));
      const std::string what = "rounding at an edge, trial " + std::to_string(trial);
      check::is_true(polygon.size() == 4, what + ": vertices");
      check::is_true(value_of(polygon[foremost_vertex(polygon)]).distance(exact[2]) < 1e-14,
                     what + ": the first vertex");
    }
}

// Points of a face that lie next to its ends are taken back to where they are, along normals that turn.
void
check_ends()
{
  Scene scene;
  for (const double inner : {0.7, 1.})
    {
      scene.bodies.emplace_back();
      scene.bodies.back().name         = inner < 1 ? "shaft" : "hub";
      scene.bodies.back().shape        = "ring";
      scene.bodies.back().inner_radius = inner;
      scene.bodies.back().radius       = inner + 0.3;
      scene.bodies.back().refinements  = 1;
    }
  scene.pairs = {pair_of({"shaft", "outer", {}}, {"hub", "inner", {}})};
  for (const unsigned int degree : {1, 2})
    {
      const Problem<2> problem(scene, degree);
      const auto      &slave = *problem.interfaces[0].slave;
      for (unsigned int face = 0; face < slave.faces.size(); ++face)
        for (double small = 0.1; small > 1e-17; small /= 3)
          for (const double xi : {small, 1 - small})
            check::is_close(project_to_slave(slave, face, slave.position(face, Point<1>(xi))),
                            xi,
                            1e-14,
                            "foot next to an end",
                            1);
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    check_quadrilaterals(degree);
  check_obstacles();
  check_rounding();
  check_ends();
  return check::result();
}
} // namespace test_face_overlap

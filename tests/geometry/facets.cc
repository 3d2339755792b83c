// Polygons that stand for curves have facets; corners, chamfers, flat parts and true geometry have none.
#include "check.h"

#include <amontons/geometry/facets.h>
#include <amontons/geometry/quadratic_faces.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

namespace test_facets
{
using namespace Amontons;
using namespace dealii;

template <int dim>
std::vector<Facet<dim>>
facets_of(
    Triangulation<dim>                 &triangulation,
    const bool                          flat,
    const std::set<types::boundary_id> &ids,
    const IsMirror<dim>                &is_mirror = [](const auto &) { return false; })
{
  if (flat)
    triangulation.set_all_manifold_ids(numbers::flat_manifold_id);
  const auto before = find_facets(triangulation, ids, is_mirror);
  triangulation.refine_global(1);
  const auto after = find_facets(triangulation, ids, is_mirror);
  check::is_true(before.size() == after.size(), "refinement changes no facets");
  return after;
}

// Block above a polygonal line from left to right.
std::vector<Facet<2>>
facets_below(const std::vector<Point<2>> &line)
{
  std::vector<Point<2>>    vertices = line;
  std::vector<CellData<2>> cells(line.size() - 1);
  for (const auto &p : line)
    vertices.emplace_back(p[0], 100);
  for (unsigned int i = 0; i < cells.size(); ++i)
    {
      const unsigned int n = line.size();
      cells[i].vertices    = {i, i + 1, n + i, n + i + 1};
    }
  Triangulation<2> triangulation;
  triangulation.create_triangulation(vertices, cells, SubCellData());
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      face->set_boundary_id(face->center()[1] < 50 ? 1 : 0);
  return facets_of(triangulation, true, {1});
}

// R (sin a, 1 - cos a)
std::vector<Point<2>>
arc(const double R, const double angle, const unsigned int n)
{
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const double a = angle * (2. * i / n - 1);
      points.emplace_back(R * std::sin(a), R * (1 - std::cos(a)));
    }
  return points;
}

void
check_rings()
{
  for (const bool flat : {true, false})
    for (const unsigned int boundary : {0, 1})
      {
        Triangulation<2> ring;
        GridGenerator::hyper_shell(ring, Point<2>(), 2., 3., 24, true);
        const auto facets = facets_of(ring, flat, {boundary});
        check::is_true(facets.size() == (flat ? 24 : 0), "facets of a ring");
        const double R = boundary == 0 ? 2 : 3, angle = numbers::PI / 12, size = 2 * R * std::sin(angle / 2);
        for (const auto &facet : facets)
          {
            check::is_close(
                facet.angle, boundary == 0 ? -angle : angle, 1e-10, "kinks of a ring, with their sign");
            check::is_close(facet.size, size, 1e-10, "length of the facets");
            check::is_close(facet.radius, size / 2, 1e-10, "they reach as far");
            check::is_close(facet.mean_square, angle * angle, 1e-10, "mean square");
          }
      }
}

void
check_lines()
{
  check::is_true(facets_below(arc(10, 0.5, 8)).size() == 8, "an arc of eight facets");
  check::is_true(facets_below(arc(10, 0.5, 4)).size() == 4, "of four: three kinks in a row");
  check::is_true(facets_below(arc(10, 0.5, 3)).empty(), "two kinks are a chamfer on each side");
  check::is_true(facets_below({{-20, 0}, {0, 0}, {20, 3}}).empty(), "one kink between flat parts");
  check::is_true(facets_below({{-20, 3}, {-10, 0}, {-3, 0}, {4, 0}, {10, 0}, {20, 3}}).empty(),
                 "two kinks with a meshed flat part between them");
  check::is_true(facets_below({{-4, 0}, {-3, 1}, {-2, 0}, {-1, 1}, {0, 0}, {1, 1}}).empty(), "a saw");
  // straight, fillet, straight
  auto line = arc(10, 0.5, 6);
  line.insert(line.begin(), {line[0][0] - 15, line[0][1] + 15 * std::tan(0.5)});
  line.insert(line.begin(), {line[0][0] - 15, line[0][1] + 15 * std::tan(0.5)});
  const auto fillet = facets_below(line);
  check::is_true(fillet.size() == 7, "a fillet, with the flat face that meets its last kink");
}

// Of second order, and a quarter of it between planes of symmetry: kinks of theta^3/16, also at the planes.
void
check_arcs()
{
  for (const unsigned int n : {24, 6})
    {
      Triangulation<2> ring;
      if (n == 24)
        GridGenerator::hyper_shell(ring, Point<2>(), 2., 3., n, true);
      else
        GridGenerator::quarter_hyper_shell(ring, Point<2>(), 2., 3., n, true);
      ring.set_all_manifold_ids(numbers::flat_manifold_id);
      MiddleNodes<2> nodes;
      for (const auto &face : ring.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() < 2)
          {
            const Tensor<1, 2> middle = face->center();
            nodes.of_edges[{{std::min(face->vertex_index(0), face->vertex_index(1)),
                             std::max(face->vertex_index(0), face->vertex_index(1))}}] =
                Point<2>((face->boundary_id() == 0 ? 2. : 3.) / middle.norm() * middle);
          }
      attach_quadratic_faces(nodes, 7, ring);
      const auto facets =
          facets_of<2>(ring, false, {1}, [](const auto &face) { return face->boundary_id() > 1; });
      check::is_true(facets.size() == n, "arcs of a ring");
      const double angle = numbers::PI / 12, kink = 2 * (std::tan(angle / 2) - 2 * std::tan(angle / 4));
      check::is_close(kink, std::pow(angle, 3) / 16, 2e-2, "kinks of arcs by their angle");
      for (const auto &facet : facets)
        {
          check::is_true(facet.is_curved, "they are curved");
          check::is_close(facet.angle, kink, 2e-2, "kinks of arcs");
          check::is_close(facet.mean_square, facet.angle * facet.angle, 1e-10, "at both ends");
        }
    }
}

// A block above y = x^2/40 + x^3/600, whose curvature goes from 0 by 1/100 per length; n faces through points
// of the curve, straight: of the parabola without the second term.
std::vector<Facet<2>>
facets_of_parabolas(const unsigned int n, const double third)
{
  const auto       y = [third](const double x) { return x * x / 40 + third * x * x * x; };
  Triangulation<2> block;
  GridGenerator::subdivided_hyper_rectangle(block, {n, 1}, Point<2>(-1, -10), Point<2>(1, 10), true);
  GridTools::transform([&](const Point<2> &p) { return p[1] < 0 ? Point<2>(p[0], y(p[0])) : p; }, block);
  MiddleNodes<2> nodes;
  for (const auto &face : block.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 2)
      {
        const double x                                                             = face->center()[0];
        nodes.of_edges[{{std::min(face->vertex_index(0), face->vertex_index(1)),
                         std::max(face->vertex_index(0), face->vertex_index(1))}}] = Point<2>(x, y(x));
      }
  attach_quadratic_faces(nodes, 7, block);
  return facets_of<2>(block, false, {2});
}

void
check_steps()
{
  constexpr double third = 1. / 600; // y''' = 1/100
  for (const unsigned int n : {4, 8})
    {
      const double h      = 2. / n;
      const auto   facets = facets_of_parabolas(n, third);
      check::is_true(facets.size() == n, "parabolas along a curve of third degree");
      for (const auto &facet : facets)
        for (const double step : facet.steps)
          check::is_true(step == 0 || std::abs(std::abs(step) * 100 / h - 1) < 0.02,
                         "steps of its curvature");
      check::is_true(facets[1].steps[0] * facets[1].steps[1] < 0, "down on one side, up on the other");
    }
  check::is_true(facets_of_parabolas(3, third).empty(), "two steps");
  check::is_true(facets_of_parabolas(8, 0).empty(), "one parabola");
}

void
check_space()
{
  Triangulation<3> cube;
  GridGenerator::subdivided_hyper_cube(cube, 4);
  check::is_true(facets_of(cube, true, {0}).empty(), "no facets on a cube");
  for (const bool flat : {true, false})
    {
      Triangulation<3> tube;
      GridGenerator::cylinder_shell(tube, 2., 3., 4., 20, 2);
      std::set<types::boundary_id> outer = {1};
      for (const auto &face : tube.active_face_iterators())
        if (face->at_boundary())
          {
            const auto c = face->center();
            face->set_boundary_id(std::abs(c[2]) < 1e-10 || std::abs(c[2] - 2) < 1e-10 ? 2
                                  : std::hypot(c[0], c[1]) > 3.5                       ? 1
                                                                                       : 3);
          }
      const auto facets = facets_of(tube, flat, outer);
      check::is_true(facets.size() == (flat ? 40 : 0), "facets of a tube");
      const double angle = numbers::PI / 10;
      for (const auto &facet : facets)
        {
          check::is_close(facet.angle, angle, 1e-10, "kinks of a tube");
          check::is_close(facet.mean_square, angle * angle, 1e-10, "in one direction only");
          check::is_close(facet.size, 8 * std::sin(angle / 2), 1e-10, "length across the kinks");
        }
    }
  Triangulation<3> round, ball;
  GridGenerator::hyper_ball(round);
  round.refine_global(3);
  GridGenerator::flatten_triangulation(round, ball);
  const auto facets = facets_of(ball, true, {0});
  check::is_true(facets.size() == 6 * 64, "facets of a sphere: " + std::to_string(facets.size()));
  for (const auto &facet : facets)
    check::is_close(
        std::sqrt(facet.mean_square / 2), facet.size, 0.3, "kinks of a sphere are h/R in both directions");
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_rings();
  check_lines();
  check_arcs();
  check_steps();
  check_space();
  return check::result();
}
} // namespace test_facets

// Built-in shapes have the area, the boundaries and the curved refinement that scene.h promises; bodies do
// not fuse.
#include "check.h"

#include <amontons/geometry/geometry.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_tools.h>

namespace test_grids
{
using namespace Amontons;
using namespace dealii;

// Volume of all cells of material 0 (empty boundary), or area of a boundary.
template <int dim>
double
measure(const Geometry<dim> &geometry, const std::string &boundary = "")
{
  const MappingQ<dim>   mapping(4);
  const FE_Nothing<dim> fe;
  FEValues<dim>         cell_values(mapping, fe, QGauss<dim>(5), update_JxW_values);
  FEFaceValues<dim>     face_values(mapping, fe, QGauss<dim - 1>(5), update_JxW_values);

  double sum = 0;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == 0)
      {
        if (boundary.empty())
          {
            cell_values.reinit(cell);
            for (const double JxW : cell_values.get_JxW_values())
              sum += JxW;
          }
        else
          for (const auto &b : geometry.boundaries)
            for (const unsigned int f : cell->face_indices())
              if (b.name == boundary && cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == b.id)
                {
                  face_values.reinit(cell, f);
                  for (const double JxW : face_values.get_JxW_values())
                    sum += JxW;
                }
      }
  return Utilities::MPI::sum(sum, geometry.communicator);
}

BodyData
make_body(const std::string &shape)
{
  BodyData body;
  body.name            = "it";
  body.shape           = shape;
  body.centre          = {1, 2, 0.5};
  body.radius          = 2;
  body.inner_radius    = 1;
  body.refinements     = 2;
  body.rotation_angle  = 30;
  body.rotation_centre = {0.3, 0.2, 0.1};
  body.shift           = Tensor<1, 3>({1, -1, 0.5});
  return body;
}

template <int dim>
void
check_shape(const BodyData &body, const double volume, const std::map<std::string, double> &boundaries)
{
  const std::string what = body.shape + " " + std::to_string(dim) + "D ";
  Scene             scene;
  scene.kind   = dim == 3 ? ProblemType::three_dimensional : ProblemType::plane_strain;
  scene.bodies = {body};
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);

  check::is_close(measure(geometry), volume, 1e-6, what + "volume");
  check::is_true(geometry.boundaries.size() == boundaries.size(), what + "number of boundaries");
  for (const auto &[name, area] : boundaries)
    check::is_close(measure(geometry, name), area, 1e-6, what + name);

  double worst = 1;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      for (unsigned int v = 0; v < cell->n_vertices(); ++v)
        {
          Tensor<2, dim> edges;
          for (unsigned int d = 0; d < dim; ++d)
            {
              edges[d] = cell->vertex(v | (1u << d)) - cell->vertex(v & ~(1u << d));
              edges[d] /= edges[d].norm();
            }
          worst = std::min(worst, determinant(edges));
        }
  worst = Utilities::MPI::min(worst, geometry.communicator);
  check::is_true(worst > (dim == 2 ? 0.5 : 0.25), what + "scaled Jacobian " + std::to_string(worst));

  for (const auto &b : geometry.boundaries)
    if (b.geometry.type != TrueGeometry::Type::flat)
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (!cell->is_artificial() && face->at_boundary() && face->boundary_id() == b.id)
            for (const unsigned int v : face->vertex_indices())
              {
                Tensor<1, dim> r = face->vertex(v);
                for (unsigned int d = 0; d < dim; ++d)
                  r[d] -= b.geometry.centre[d];
                if constexpr (dim == 3)
                  r -= (r * b.geometry.axis) * b.geometry.axis;
                check::is_close(r.norm(), b.name == "inner" ? 1 : 2, 1e-12, what + "vertex on " + b.name);
              }
}

void
check_blocks()
{
  BodyData body = make_body("block");
  body.lower    = {-1, 0, 1};
  body.upper    = {2, 1, 3};
  body.cells    = {{3, 2, 2}};
  body.grading  = {{4, 1, 0.5}};
  check_shape<2>(body, 3, {{"left", 1}, {"right", 1}, {"bottom", 3}, {"top", 3}});
  check_shape<3>(body, 6, {{"left", 2}, {"right", 2}, {"bottom", 3}, {"top", 3}, {"front", 6}, {"back", 6}});
}

// x = c + R (X - c) + shift
void
check_placement()
{
  BodyData body = make_body("block");
  body.lower    = {-1, 0, 1};
  body.upper    = {2, 1, 3};
  Scene scene;
  scene.kind   = ProblemType::plane_strain;
  scene.bodies = {body};
  Geometry<2> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  Point<2> mean; // of the vertices: the block's centre, (0.5, 0.5) before
  double   n = 0;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      {
        mean += cell->vertex(v) - Point<2>();
        ++n;
      }
  const double c = std::sqrt(3.) / 2, s = 0.5; // of 30 degrees
  check::is_close(mean[0] / n, 0.3 + c * 0.2 - s * 0.3 + 1, 1e-12, "placement in x");
  check::is_close(mean[1] / n, 0.2 + s * 0.2 + c * 0.3 - 1, 1e-12, "placement in y");
}

void
check_round_shapes()
{
  const double pi = numbers::PI;
  check_shape<2>(make_body("disk"), 4 * pi, {{"arc", 4 * pi}});
  check_shape<2>(make_body("half disk"), 2 * pi, {{"arc", 2 * pi}, {"cut", 4}});
  check_shape<2>(make_body("quarter disk"), pi, {{"arc", pi}, {"cut", 2}, {"axis", 2}});
  check_shape<2>(make_body("ring"), 3 * pi, {{"inner", 2 * pi}, {"outer", 4 * pi}});
  check_shape<2>(make_body("half ring"), 1.5 * pi, {{"inner", pi}, {"outer", 2 * pi}, {"cut x", 2}});
  check_shape<2>(
      make_body("quarter ring"), 0.75 * pi, {{"inner", pi / 2}, {"outer", pi}, {"cut x", 1}, {"cut y", 1}});
}

void
check_round_shapes_3d()
{
  const double pi = numbers::PI;
  const auto   check =
      [](const std::string &shape, const double volume, const std::map<std::string, double> &areas) {
        BodyData body      = make_body(shape);
        body.rotation_axis = Tensor<1, 3>({1, 1, 0});
        body.length        = 3;
        check_shape<3>(body, volume, areas);
      };
  check("sphere", 32 * pi / 3, {{"surface", 16 * pi}});
  check("half sphere", 16 * pi / 3, {{"surface", 8 * pi}, {"plane z", 4 * pi}});
  check("quarter sphere", 8 * pi / 3, {{"surface", 4 * pi}, {"plane x", 2 * pi}, {"plane z", 2 * pi}});
  check(
      "eighth sphere", 4 * pi / 3, {{"surface", 2 * pi}, {"plane x", pi}, {"plane y", pi}, {"plane z", pi}});
  check("hollow sphere", 28 * pi / 3, {{"inner", 4 * pi}, {"outer", 16 * pi}});
  check("half hollow sphere", 14 * pi / 3, {{"inner", 2 * pi}, {"outer", 8 * pi}, {"plane z", 3 * pi}});
  check("quarter hollow sphere",
        7 * pi / 3,
        {{"inner", pi}, {"outer", 4 * pi}, {"plane x", 1.5 * pi}, {"plane z", 1.5 * pi}});
  check("eighth hollow sphere",
        7 * pi / 6,
        {{"inner", pi / 2},
         {"outer", 2 * pi},
         {"plane x", 0.75 * pi},
         {"plane y", 0.75 * pi},
         {"plane z", 0.75 * pi}});
  check("cylinder", 12 * pi, {{"surface", 12 * pi}, {"bottom", 4 * pi}, {"top", 4 * pi}});
  check("half cylinder", 6 * pi, {{"surface", 6 * pi}, {"bottom", 2 * pi}, {"top", 2 * pi}, {"plane y", 12}});
  check("quarter cylinder",
        3 * pi,
        {{"surface", 3 * pi}, {"bottom", pi}, {"top", pi}, {"plane x", 6}, {"plane y", 6}});
  check("hollow cylinder",
        9 * pi,
        {{"inner", 6 * pi}, {"outer", 12 * pi}, {"bottom", 3 * pi}, {"top", 3 * pi}});
  check("half hollow cylinder",
        4.5 * pi,
        {{"inner", 3 * pi}, {"outer", 6 * pi}, {"bottom", 1.5 * pi}, {"top", 1.5 * pi}, {"plane y", 6}});
  check("quarter hollow cylinder",
        2.25 * pi,
        {{"inner", 1.5 * pi},
         {"outer", 3 * pi},
         {"bottom", 0.75 * pi},
         {"top", 0.75 * pi},
         {"plane x", 3},
         {"plane y", 3}});
}

// Pieces at their place, without placement: the signs of x, y, z from the centre, 0 for both.
template <int dim>
void
check_orientation(const std::string &shape, const std::array<int, 3> &signs)
{
  Scene    scene;
  BodyData body       = make_body(shape);
  body.rotation_angle = 0;
  body.shift          = Tensor<1, 3>();
  scene.kind          = dim == 3 ? ProblemType::three_dimensional : ProblemType::plane_strain;
  scene.bodies        = {body};
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  const auto [lower, upper] = GridTools::compute_bounding_box(geometry.triangulation).get_boundary_points();
  for (unsigned int d = 0; d < dim; ++d)
    check::is_true(lower[d] >= body.centre[d] - (signs[d] == 1 ? 1e-12 : 3) &&
                       upper[d] <= body.centre[d] + (signs[d] == -1 ? 1e-12 : 3),
                   shape + " is on the right side");
}

// Cells of thick rings and shells are as long as they are thick, from the hole to far away.
template <int dim>
void
check_thick(const std::string &shape)
{
  BodyData body    = make_body(shape);
  body.radius      = 30;
  body.refinements = 0;
  Scene scene;
  scene.kind   = dim == 3 ? ProblemType::three_dimensional : ProblemType::plane_strain;
  scene.bodies = {body};
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  double worst = 1;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    for (const unsigned int l : cell->line_indices())
      worst = std::max(worst, cell->diameter() / cell->line(l)->diameter());
  check::is_true(worst < 4,
                 "thick " + shape + ": a cell is " + std::to_string(worst) + " times as long as an edge");
}

void
check_orientations()
{
  check_orientation<2>("half disk", {{0, -1, 0}});
  check_orientation<2>("quarter disk", {{1, -1, 0}});
  check_orientation<2>("half ring", {{0, 1, 0}});
  check_orientation<2>("quarter ring", {{1, 1, 0}});
  for (const std::string hollow : {"", "hollow "})
    {
      check_orientation<3>("half " + hollow + "sphere", {{0, 0, -1}});
      check_orientation<3>("quarter " + hollow + "sphere", {{1, 0, -1}});
      check_orientation<3>("eighth " + hollow + "sphere", {{1, 1, -1}});
      check_orientation<3>("half " + hollow + "cylinder", {{0, -1, 1}});
      check_orientation<3>("quarter " + hollow + "cylinder", {{1, -1, 1}});
    }
}

// Quarter cylinders that cross at the origin, as doc/scene_files.md places them: both lie in x >= 0, y <= 0,
// above and below z = 0, with their symmetry planes on x = 0 and y = 0.
void
check_crossed_cylinders()
{
  BodyData upper        = make_body("quarter cylinder"), lower;
  upper.centre          = {0, 2, 0};
  upper.shift           = Tensor<1, 3>();
  upper.length          = 3;
  upper.rotation_centre = Point<3>();
  lower                 = upper;
  upper.rotation_angle  = 90;
  upper.rotation_axis   = Tensor<1, 3>({1, 0, 0});
  lower.rotation_angle  = 120;
  lower.rotation_axis   = Tensor<1, 3>({-1, 1, -1});
  lower.name            = "lower";
  Scene scene;
  scene.kind = ProblemType::three_dimensional;
  for (const BodyData &body : {upper, lower})
    {
      scene.bodies = {body};
      Geometry<3> geometry(MPI_COMM_WORLD);
      make_geometry(scene, geometry);
      const bool above       = body.name != "lower";
      const auto [low, high] = GridTools::compute_bounding_box(geometry.triangulation).get_boundary_points();
      const Point<3> expected_low(0, above ? -3 : -2, above ? 0 : -2),
          expected_high(above ? 2 : 3, 0, above ? 2 : 0);
      check::is_true(low.distance(expected_low) < 1e-12 && high.distance(expected_high) < 1e-12,
                     "place of a crossed cylinder");
      const std::map<std::string, unsigned int> planes =
          above ? std::map<std::string, unsigned int>{{"plane x", 0}, {"bottom", 1}}
                : std::map<std::string, unsigned int>{{"plane x", 1}, {"bottom", 0}};
      for (const auto &[name, d] : planes)
        for (const auto &cell : geometry.triangulation.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() &&
                face->boundary_id() == geometry.boundary({body.name, name, {}}, scene).id)
              check::is_close(face->center()[d], 0, 1e-12, name + " of a crossed cylinder", 1);
    }
}

template <int dim>
void
check_two_blocks()
{
  Scene scene;
  scene.kind = dim == 3 ? ProblemType::three_dimensional : ProblemType::axisymmetric;
  BodyData lower;
  lower.name             = "lower";
  lower.upper            = {1, 1, 1};
  lower.cells            = {{2, 2, 2}};
  lower.refinements      = 3 - (dim - 2);
  BodyData upper         = lower;
  upper.name             = "upper";
  upper.refinements      = 1;
  upper.shift[1]         = 1;
  upper.rigid            = MotionData();
  upper.rigid->name      = "upper";
  upper.rigid->reference = {0.5, 1, 0};
  ObstacleData obstacle;
  obstacle.motion.name      = "wall";
  obstacle.motion.reference = {0, 3, 0};
  ConditionData platen;
  platen.type         = ConditionData::Type::platen;
  platen.motion       = MotionData();
  platen.motion->name = "platen";
  scene.bodies        = {lower, upper};
  scene.obstacles     = {obstacle};
  scene.conditions    = {ConditionData(), platen};

  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  check::is_true(geometry.triangulation.n_global_active_cells() ==
                     std::pow(2 * (1 << lower.refinements), dim) + std::pow(4, dim) + 3,
                 "cells of two blocks and three carriers");
  const unsigned int n_vertices = 2 * std::pow(3, dim) + 3 * (1 << dim);
  check::is_true(geometry.triangulation.get_used_vertices().size() >= n_vertices,
                 "touching blocks do not fuse");
  check::is_true(geometry.boundaries.size() == 4 * dim, "boundaries of both");
  check::is_close(geometry.body_sizes[0], std::sqrt(dim), 1e-12, "body size");

  check::is_true(geometry.carriers.size() == 3 && geometry.carriers[0].motion.name == "upper" &&
                     geometry.carriers[1].motion.name == "wall" && geometry.carrier("platen") == 2,
                 "carriers in order");
  check::is_true(geometry.carriers[0].motion.reference[0] == (dim == 2 ? 0. : 0.5), "axial reference");
  check::is_true(geometry.is_carrier(2) && !geometry.is_carrier(1), "material ids of carriers");

  std::map<unsigned int, unsigned int> n_faces;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            ++n_faces[face->boundary_id()];
        if (geometry.is_carrier(cell->material_id()))
          {
            check::is_true(cell->level() == 0, "carriers are not refined");
            const auto &carrier = geometry.carriers[cell->material_id() - 2];
            for (unsigned int v = 0; v < cell->n_vertices(); ++v)
              for (unsigned int d = 0; d < dim; ++d)
                check::is_close(cell->vertex(v)[d],
                                carrier.motion.reference[d] + ((v >> d) & 1) * carrier.size,
                                1e-12,
                                "corner of a carrier",
                                1);
          }
      }
  const auto &top = geometry.boundary({"lower", dim == 2 ? "top" : "back", {}}, scene);
  check::is_close(Utilities::MPI::sum(n_faces[top.id], MPI_COMM_WORLD),
                  std::pow(2 * (1 << lower.refinements), dim - 1),
                  0,
                  "faces that touch the other body");

  try
    {
      geometry.boundary({"lower", "tpo", {"a.prm", 7, "Pair"}}, scene);
      check::is_true(false, "unknown boundary");
    }
  catch (const InputError &e)
    {
      const std::string message = e.what();
      check::is_true(message.find("a.prm:7") == 0 && message.find("bottom") != std::string::npos,
                     "message for an unknown boundary: " + message);
    }
}

template <typename Change>
void
check_error(const std::string &words, const ProblemType kind, const Change &change)
{
  Scene    scene;
  BodyData body = make_body("disk");
  scene.kind    = kind;
  change(body);
  scene.bodies = {body};
  try
    {
      Geometry<2> geometry(MPI_COMM_WORLD);
      make_geometry(scene, geometry);
      check::is_true(false, "no error: " + words);
    }
  catch (const InputError &e)
    {
      check::is_true(std::string(e.what()).find(words) != std::string::npos, e.what());
    }
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_blocks();
  check_placement();
  check_round_shapes();
  check_round_shapes_3d();
  check_orientations();
  check_thick<2>("ring");
  check_thick<2>("quarter ring");
  check_thick<3>("half hollow sphere");
  check_crossed_cylinders();
  check_two_blocks<2>();
  check_two_blocks<3>();

  const ProblemType plane = ProblemType::plane_strain;
  check_error("axisymmetric", ProblemType::axisymmetric, [](BodyData &b) { b.shift[0] = -3; });
  check_error("unknown shape", plane, [](BodyData &b) { b.shape = "blob"; });
  check_error("unknown shape 'sphere' in 2D", plane, [](BodyData &b) { b.shape = "sphere"; });
  check_error("out of the plane", plane, [](BodyData &b) { b.rotation_axis[0] = 1; });
  check_error("inner radius", plane, [](BodyData &b) {
    b.shape        = "ring";
    b.inner_radius = 2;
  });
  check_error("lower corner", plane, [](BodyData &b) { b.shape = "block"; });
  check_error("boundary 'arc'", plane, [](BodyData &b) {
    b.true_geometry["arc"] = {TrueGeometry::Type::circle, Point<3>(1.1, 2, 0), {}};
  });
  check_error("boundary 'ark'", plane, [](BodyData &b) { b.true_geometry["ark"] = TrueGeometry(); });
  return check::result();
}
} // namespace test_grids

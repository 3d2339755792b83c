// Built-in shapes have the area, the boundaries and the curved refinement that scene.h promises; bodies do
// not fuse.
#include "check.h"

#include <amontons/geometry/geometry.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_tools.h>

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
  scene.kind   = dim == 3 ? Kind::three_dimensional : Kind::plane_strain;
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
    if (b.geometry.type == TrueGeometry::Type::circle)
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (!cell->is_artificial() && face->at_boundary() && face->boundary_id() == b.id)
            for (const unsigned int v : face->vertex_indices())
              {
                Tensor<1, dim> r = face->vertex(v);
                for (unsigned int d = 0; d < dim; ++d)
                  r[d] -= b.geometry.centre[d];
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
  BodyData ball      = make_body("disk");
  ball.rotation_axis = Tensor<1, 3>({1, 1, 0});
  check_shape<3>(ball, 32 * pi / 3, {{"arc", 16 * pi}});
  ball.shape = "half disk";
  check_shape<3>(ball, 16 * pi / 3, {{"arc", 8 * pi}, {"cut", 4 * pi}});
  ball.shape = "quarter disk";
  check_shape<3>(ball, 8 * pi / 3, {{"arc", 4 * pi}, {"cut", 2 * pi}, {"axis", 2 * pi}});
}

// The lower half at its place, without placement: the arc is below, and symmetric about x = centre.
void
check_orientation()
{
  Scene    scene;
  BodyData body       = make_body("quarter disk");
  body.rotation_angle = 0;
  body.shift          = Tensor<1, 3>();
  scene.bodies        = {body};
  Geometry<2> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  for (const auto &p : geometry.triangulation.get_vertices())
    check::is_true(p[0] >= 1 - 1e-12 && p[1] <= 2 + 1e-12, "the quarter disk is at x >= 0, y <= 0");
}

template <int dim>
void
check_two_blocks()
{
  Scene scene;
  scene.kind = dim == 3 ? Kind::three_dimensional : Kind::axisymmetric;
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
check_error(const std::string &words, const Kind kind, const Change &change)
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
  check_round_shapes();
  check_orientation();
  check_two_blocks<2>();
  check_two_blocks<3>();

  const Kind plane = Kind::plane_strain;
  check_error("axisymmetric", Kind::axisymmetric, [](BodyData &b) { b.shift[0] = -3; });
  check_error("unknown shape", plane, [](BodyData &b) { b.shape = "blob"; });
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

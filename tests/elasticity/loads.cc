// External forces: resultants of pressures, tractions, total forces, body forces and of what acts on rigid
// motions are what the scene asks for.
#include "check.h"

#include <amontons/elasticity/loads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <set>

namespace test_loads
{
using namespace Amontons;

BodyData
block()
{
  BodyData body;
  body.name  = "it";
  body.lower = {1, 0, 0};
  body.upper = {3, 1, 1.5};
  body.cells = {{3, 2, 2}};
  return body;
}

ConditionData
load(const ConditionData::Type        type,
     const std::vector<BoundaryName> &boundaries,
     const std::vector<Expression>   &value)
{
  ConditionData condition;
  condition.type       = type;
  condition.boundaries = boundaries;
  for (unsigned int d = 0; d < value.size(); ++d)
    condition.value[d] = value[d];
  return condition;
}

// Work of the loads at time t on the displacement u(X) of the bodies and carriers: exact for rigid motions.
template <int dim>
double
work(const Scene                                             &scene,
     const unsigned int                                       degree,
     const double                                             t,
     const std::function<Tensor<1, dim>(const Point<dim> &)> &u)
{
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  Discretization<dim> discretization(scene, geometry, degree);
  discretization.distribute_dofs();
  const auto                                    loads = assemble_loads<dim>(discretization, t, {});
  std::map<types::global_dof_index, Point<dim>> points;
  DoFTools::map_dofs_to_support_points(discretization.mapping(), discretization.dof_handler, points);
  std::set<types::global_dof_index>    done;
  std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
  double                               sum = 0;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (done.insert(dofs[i]).second)
          sum += loads(dofs[i]) * u(points.at(dofs[i]))[discretization.fe.system_to_component_index(i).first];
    }
  return sum;
}

template <int dim>
Tensor<1, dim>
resultant(const Scene &scene, const unsigned int degree, const double t = 1)
{
  Tensor<1, dim> force;
  for (unsigned int d = 0; d < dim; ++d)
    force[d] = work<dim>(scene, degree, t, [d](const Point<dim> &) {
      Tensor<1, dim> v;
      v[d] = 1;
      return v;
    });
  return force;
}

template <int dim>
void
check_force(const Tensor<1, dim> &force, const Tensor<1, dim> &expected, const std::string &what)
{
  for (unsigned int d = 0; d < dim; ++d)
    check::is_close(force[d], expected[d], 1e-11, what + ", component " + std::to_string(d), expected.norm());
}

Scene
pressed_quarter_disk(const double R, const double p)
{
  Scene    scene;
  BodyData disk;
  disk.name        = "it";
  disk.shape       = "quarter disk";
  disk.radius      = R;
  disk.centre      = {1, 2, 0};
  disk.refinements = 1;
  scene.bodies     = {disk};
  scene.conditions = {load(ConditionData::Type::pressure, {{"it", "arc", {}}}, {Expression(p)})};
  return scene;
}

void
check_pressure_on_circle(const unsigned int degree)
{
  const double R = 2.5, p = 3;
  check_force<2>(resultant<2>(pressed_quarter_disk(R, p), degree),
                 Tensor<1, 2>({-p * R, p * R}),
                 "pressure on a quarter circle");
}

// What touches has areas of the facets, or of quadratic faces. Where all of them touch, no pressure is left.
void
check_covered_circle(const unsigned int degree)
{
  const Scene scene = pressed_quarter_disk(2.5, 3);
  Geometry<2> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  Discretization<2> discretization(scene, geometry, degree);
  discretization.distribute_dofs();
  const QGauss<1> line(5);
  FEFaceValues<2> values(
      discretization.mapping(), discretization.fe, line, update_JxW_values | update_quadrature_points);
  std::vector<CoveredPoint<2>> covered;
  const auto                   arc = geometry.boundary({"it", "arc", {}}, scene).id;
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == arc)
        {
          values.reinit(cell, f);
          for (unsigned int q = 0; q < line.size(); ++q)
            covered.push_back(
                {cell,
                 f,
                 discretization.mapping().transform_real_to_unit_cell(cell, values.quadrature_point(q)),
                 values.JxW(q)});
        }
  check::is_close(assemble_loads<2>(discretization, 1, covered).linfty_norm(),
                  0,
                  1e-12,
                  "pressure on a circle that is covered",
                  assemble_loads<2>(discretization, 1, {}).linfty_norm());
}

// Of linear elements, too, over the curve: the pressure on an eighth of a ball, and the weight of half a
// ring.
void
check_curved(const unsigned int degree)
{
  const double pi = numbers::PI, p = 3;
  Scene        scene;
  scene.kind = ProblemType::three_dimensional;
  BodyData ball;
  ball.name        = "it";
  ball.shape       = "eighth sphere";
  ball.radius      = 2;
  ball.refinements = 1;
  scene.bodies     = {ball};
  scene.conditions = {load(ConditionData::Type::pressure, {{"it", "surface", {}}}, {Expression(p)})};
  const auto force = resultant<3>(scene, degree);
  for (unsigned int d = 0; d < 3; ++d)
    check::is_close(std::abs(force[d]), p * pi, 2e-4, "pressure on a ball");

  BodyData ring;
  ring.name         = "it";
  ring.shape        = "half ring";
  ring.radius       = 2;
  ring.inner_radius = 1;
  ring.refinements  = 1;
  ring.body_force   = {{Expression(0.), Expression(-p), Expression(0.)}};
  scene.kind        = ProblemType::plane_strain;
  scene.bodies      = {ring};
  scene.conditions  = {};
  check::is_close(resultant<2>(scene, degree)[1], -p * 3 * pi / 2, 2e-4, "weight of half a ring");
}

void
check_block_2d(const unsigned int degree)
{
  using Type = ConditionData::Type;
  using V    = Tensor<1, 2>;
  const BoundaryName top{"it", "top", {}}, right{"it", "right", {}};
  Scene              scene;
  scene.bodies     = {block()};
  scene.conditions = {load(Type::traction, {top}, {Expression("3*t*x", {}), Expression(-1.)})};
  check_force<2>(resultant<2>(scene, degree, 2), V({24, -2}), "traction");
  scene.conditions = {load(Type::total_force, {top, right}, {Expression(5.), Expression("-7*t", {})})};
  check_force<2>(resultant<2>(scene, degree, 0.5), V({5, -3.5}), "total force on two boundaries");
  scene.conditions = {load(Type::pressure, {right}, {Expression("2*y", {})})};
  check_force<2>(resultant<2>(scene, degree), V({-1, 0}), "linear pressure");
  scene.conditions           = {};
  scene.bodies[0].body_force = {{Expression(0.), Expression("-x*t", {}), Expression(0.)}};
  check_force<2>(resultant<2>(scene, degree, 3), V({0, -12}), "body force");

  // full turn
  scene.kind = ProblemType::axisymmetric;
  check::is_close(resultant<2>(scene, degree, 3)[1], -2 * numbers::PI * 26, 1e-12, "axisymmetric body force");
  scene.bodies[0].body_force = {};
  scene.conditions           = {load(Type::pressure, {top}, {Expression(2.)})};
  check::is_close(resultant<2>(scene, degree)[1], -2 * numbers::PI * 8, 1e-12, "axisymmetric pressure");
  scene.conditions = {load(Type::total_force, {top}, {Expression(0.), Expression(-11.)})};
  check::is_close(resultant<2>(scene, degree)[1], -11, 1e-12, "axisymmetric total force");
}

void
check_block_3d(const unsigned int degree)
{
  using Type = ConditionData::Type;
  using V    = Tensor<1, 3>;
  Scene scene;
  scene.kind       = ProblemType::three_dimensional;
  scene.bodies     = {block()};
  scene.conditions = {load(Type::total_force,
                           {{"it", "front", {}}, {"it", "top", {}}},
                           {Expression(5.), Expression(-7.), Expression(2.)})};
  check_force<3>(resultant<3>(scene, degree), V({5, -7, 2}), "3D total force");
  scene.conditions = {load(Type::pressure, {{"it", "back", {}}, {"it", "left", {}}}, {Expression("x", {})})};
  check_force<3>(resultant<3>(scene, degree), V({1.5, -6, 0}), "3D pressure");
}

// Loads that begin, end or jump within a face or a cell: a strip that no point of the usual formula lies in,
// and the corner of a face in space.
void
check_jumps(const unsigned int degree)
{
  using Type = ConditionData::Type;
  const BoundaryName top{"it", "top", {}};
  Scene              scene;
  scene.bodies     = {block()};
  scene.conditions = {load(Type::pressure, {top}, {Expression("if(x > 1.3 && x < 1.34, 50*t, 0)", {})})};
  check::is_close(resultant<2>(scene, degree, 2)[1], -4, 1e-5, "pressure on a strip", 4);
  scene.conditions = {load(Type::pressure, {top}, {Expression("if(x > 1.3 && x < 1.304, 50*t, 0)", {})})};
  check::is_close(resultant<2>(scene, degree, 2)[1], -0.4, 1e-5, "pressure on a narrow strip", 0.4);
  scene.conditions = {load(Type::traction, {top}, {Expression(0.), Expression("if(x < 2.2, 3, -x)", {})})};
  check::is_close(resultant<2>(scene, degree)[1], 3 * 1.2 - 2.08, 1e-5, "traction that jumps", 3);
  scene.conditions           = {};
  scene.bodies[0].body_force = {{Expression("if(x + y < 1.5, 8, 0)", {}), Expression(0.), Expression(0.)}};
  check::is_close(resultant<2>(scene, degree)[0], 1, 1e-2, "body force on a triangle", 1);
  if (degree == 2)
    return; // in space once
  scene.bodies[0].body_force = {};
  scene.kind                 = ProblemType::three_dimensional;
  scene.conditions           = {
                load(Type::pressure, {{"it", "back", {}}}, {Expression("if(x < 1.1 && z < 0.1, 100, 0)", {})})};
  check::is_close(resultant<3>(scene, degree)[1], -1, 3e-3, "pressure on a corner", 1);
}

// Forces and moments on a platen do the work F . U + M . theta on its rigid motion.
template <int dim>
void
check_platen(const ProblemType kind)
{
  Scene scene;
  scene.kind   = kind;
  scene.bodies = {block()};
  ConditionData platen;
  platen.type       = ConditionData::Type::platen;
  platen.boundaries = {{"it", "top", {}}};
  MotionData motion;
  motion.name      = "platen";
  motion.reference = {2, 1, 0.5};
  motion.force     = {{Expression(2.), Expression("-3*t", {}), Expression(dim == 3 ? 1. : 0.)}};
  motion.moment    = {
         {Expression(dim == 3 ? 0.4 : 0.), Expression(dim == 3 ? -0.7 : 0.), Expression("1.1*t", {})}};
  platen.motion    = motion;
  scene.conditions = {platen};

  Tensor<1, 3> U({0.3, -0.2, 0.5}), theta({0.1, -0.4, 0.7});
  if (dim == 2)
    theta[0] = theta[1] = 0;
  const auto rigid = [&](const Point<dim> &X) {
    Tensor<1, 3> r;
    for (unsigned int d = 0; d < dim; ++d)
      r[d] = X[d] - motion.reference[d];
    const auto     v = U + cross_product_3d(theta, r);
    Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = v[d];
    return u;
  };
  double expected = 0;
  for (unsigned int d = 0; d < dim; ++d)
    expected += motion.force[d].value(motion.reference, 2) * U[d];
  for (unsigned int d = 0; d < 3; ++d)
    expected += motion.moment[d].value(motion.reference, 2) * theta[d];
  for (const unsigned int degree : {1, 2})
    check::is_close(
        work<dim>(scene, degree, 2, rigid), expected, 1e-12, "work of the force and moment on a platen");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_pressure_on_circle(degree);
      check_curved(degree);
      check_covered_circle(degree);
      check_block_2d(degree);
      check_block_3d(degree);
      check_jumps(degree);
    }
  check_platen<2>(ProblemType::plane_strain);
  check_platen<3>(ProblemType::three_dimensional);
  return check::result();
}
} // namespace test_loads

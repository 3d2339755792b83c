// Supports hold what the scene prescribes: planes, displacements, platens, rigid bodies and their carriers,
// the axis of revolution.
#include "check.h"

#include <amontons/discretization/discretization.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <random>

namespace test_supports
{
using namespace Amontons;

BodyData
block(const std::string &name, const Point<3> &lower, const Point<3> &upper)
{
  BodyData body;
  body.name  = name;
  body.lower = lower;
  body.upper = upper;
  body.cells = {{3, 2, 2}};
  return body;
}

ConditionData
condition(const ConditionData::Type type, const std::vector<BoundaryName> &boundaries)
{
  ConditionData result;
  result.type       = type;
  result.boundaries = boundaries;
  return result;
}

// A random vector on which the supports of the scene are imposed.
template <int dim>
struct Problem
{
  Problem(const Scene &s, const unsigned int degree, const double t = 0, const bool refine_locally = false)
      : scene(s), geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    if (refine_locally)
      {
        for (const auto &cell : geometry.triangulation.active_cell_iterators())
          if (!geometry.is_carrier(cell->material_id()))
            {
              cell->set_refine_flag();
              break;
            }
        geometry.triangulation.execute_coarsening_and_refinement();
      }
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, degree);
    discretization->distribute_dofs();
    supports = discretization->make_supports(t);
    u        = LA::Vector(discretization->locally_owned, MPI_COMM_WORLD);
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> random(-1, 1);
    for (const auto dof : discretization->locally_owned)
      u(dof) = random(generator);
    u.compress(VectorOperation::insert);
    supports.distribute(u);
  }

  // Calls action(position, displacement) for the nodes of body b where `where` holds; returns how many.
  unsigned int
  for_nodes(const unsigned int                                                     b,
            const std::function<bool(const Point<dim> &)>                         &where,
            const std::function<void(const Point<dim> &, const Tensor<1, dim> &)> &action) const
  {
    std::map<types::global_dof_index, Point<dim>> points;
    DoFTools::map_dofs_to_support_points(discretization->mapping(), discretization->dof_handler, points);
    std::vector<types::global_dof_index> dofs(discretization->fe.n_dofs_per_cell());
    unsigned int                         n = 0;
    for (const auto &cell : discretization->dof_handler.active_cell_iterators())
      if (cell->material_id() == b)
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < discretization->fe.base_element(0).n_dofs_per_cell(); ++i)
            {
              Tensor<1, dim>   value;
              const Point<dim> X = points.at(dofs[discretization->fe.component_to_system_index(0, i)]);
              for (unsigned int c = 0; c < dim; ++c)
                value[c] = u(dofs[discretization->fe.component_to_system_index(c, i)]);
              if (where(X))
                {
                  action(X, value);
                  ++n;
                }
            }
        }
    check::is_true(n > 0, "there are nodes to look at");
    return n;
  }

  // Displacement of the carrier's corners A, B, C(, D).
  Tensor<1, dim>
  corner(const unsigned int m, const unsigned int k) const
  {
    Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      value[c] = u(discretization->carrier_dofs[m][k][c]);
    return value;
  }

  Scene                                scene;
  Geometry<dim>                        geometry;
  std::unique_ptr<Discretization<dim>> discretization;
  Constraints                          supports;
  LA::Vector                           u;
};

template <int dim>
void
check_zero(const Tensor<1, dim> &v, const std::string &what)
{
  check::is_close(v.norm(), 0, 1e-12, what, 1);
}

// u = U + theta x (X - reference)
template <int dim>
Tensor<1, dim>
rigid(const Tensor<1, 3> &U, const Tensor<1, 3> &theta, const Point<3> &reference, const Point<dim> &X)
{
  Tensor<1, 3> r;
  for (unsigned int d = 0; d < dim; ++d)
    r[d] = X[d] - reference[d];
  const auto     v = U + cross_product_3d(theta, r);
  Tensor<1, dim> u;
  for (unsigned int d = 0; d < dim; ++d)
    u[d] = v[d];
  return u;
}

// The rotation that a carrier's corners show.
template <int dim>
Tensor<1, 3>
rotation_of(const Problem<dim> &problem, const unsigned int m)
{
  const double s = problem.geometry.carriers[m].size;
  const auto   A = problem.corner(m, 0), B = problem.corner(m, 1), C = problem.corner(m, 2);
  Tensor<1, 3> theta;
  theta[2] = (B[1] - A[1]) / s;
  if (dim == 3)
    {
      theta[1] = -(B[dim - 1] - A[dim - 1]) / s;
      theta[0] = (C[dim - 1] - A[dim - 1]) / s;
    }
  return theta;
}

template <int dim>
Tensor<1, 3>
translation_of(const Problem<dim> &problem, const unsigned int m)
{
  Tensor<1, 3> U;
  for (unsigned int d = 0; d < dim; ++d)
    U[d] = problem.corner(m, 0)[d];
  return U;
}

// All planes of a block that is turned by `angle`, also where it has hanging nodes.
void
check_planes(const unsigned int degree, const double angle)
{
  Scene scene;
  scene.bodies                   = {block("it", {0, 0, 0}, {2, 1, 0})};
  scene.bodies[0].rotation_angle = angle;
  scene.conditions = {condition(ConditionData::Type::symmetry, {{"it", "left", {}}, {"it", "bottom", {}}})};
  const Problem<2>   problem(scene, degree, 0, true);
  const double       a = angle * numbers::PI / 180;
  const Tensor<1, 2> x({std::cos(a), std::sin(a)}), y({-std::sin(a), std::cos(a)});
  problem.for_nodes(
      0,
      [&](const Point<2> &X) { return std::abs(X * x) < 1e-10; },
      [&](const Point<2> &, const Tensor<1, 2> &u) {
        check::is_close(u * x, 0, 1e-12, "symmetry plane 'left'", 1);
      });
  unsigned int n_moving = 0;
  problem.for_nodes(
      0,
      [&](const Point<2> &X) { return std::abs(X * y) < 1e-10; },
      [&](const Point<2> &X, const Tensor<1, 2> &u) {
        check::is_close(u * y, 0, 1e-12, "symmetry plane 'bottom'", 1);
        if (X.norm() < 1e-10)
          check_zero(u, "the corner of two planes");
        else
          n_moving += u.norm() > 1e-3;
      });
  check::is_true(n_moving > 0, "nodes may move in their plane");
}

void
check_planes_3d(const unsigned int degree)
{
  Scene scene;
  scene.kind                     = ProblemType::three_dimensional;
  scene.bodies                   = {block("it", {0, 0, 0}, {2, 1, 1})};
  scene.bodies[0].rotation_angle = 25;
  scene.bodies[0].rotation_axis  = Tensor<1, 3>({1, 1, 0.5});
  scene.conditions               = {condition(ConditionData::Type::symmetry,
                                {{"it", "left", {}}, {"it", "bottom", {}}, {"it", "front", {}}})};
  const Problem<3> problem(scene, degree);
  unsigned int     n_corners = 0;
  // The edges of the turned block from its corner at the origin: Rodrigues' formula.
  const Tensor<1, 3>        k = scene.bodies[0].rotation_axis / scene.bodies[0].rotation_axis.norm();
  const double              a = 25 * numbers::PI / 180;
  std::vector<Tensor<1, 3>> axes;
  for (unsigned int d = 0; d < 3; ++d)
    {
      Tensor<1, 3> e;
      e[d] = 1;
      axes.push_back(std::cos(a) * e + std::sin(a) * cross_product_3d(k, e) +
                     (1 - std::cos(a)) * (k * e) * k);
    }
  problem.for_nodes(
      0,
      [](const Point<3> &) { return true; },
      [&](const Point<3> &X, const Tensor<1, 3> &u) {
        unsigned int n_planes = 0;
        for (const auto &normal : axes)
          if (std::abs(X * normal) < 1e-10)
            {
              ++n_planes;
              check::is_close(u * normal, 0, 1e-11, "oblique plane in 3D", 1);
            }
        n_corners += n_planes == 3;
        if (n_planes == 3)
          check_zero(u, "the corner of three planes");
      });
  check::is_true(n_corners == 1, "the planes are where the test expects them");
}

void
check_displacement(const unsigned int degree)
{
  Scene         scene;
  ConditionData top   = condition(ConditionData::Type::displacement, {{"it", "top", {}}});
  top.displacement[1] = Expression("-0.1*t*(1 + x)", {});
  ConditionData left  = condition(ConditionData::Type::displacement, {{"it", "left", {}}});
  left.displacement   = {{Expression("y^2", {}), Expression(0.5), {}}};
  scene.bodies        = {block("it", {0, 0, 0}, {2, 1, 0})};
  scene.conditions    = {top, left};
  const Problem<2> problem(scene, degree, 2);
  problem.for_nodes(
      0,
      [](const Point<2> &X) { return X[1] > 1 - 1e-10; },
      [](const Point<2> &X, const Tensor<1, 2> &u) {
        check::is_close(u[1], -0.2 * (1 + X[0]), 1e-12, "displacement of the top: the first condition wins");
      });
  problem.for_nodes(
      0,
      [](const Point<2> &X) { return X[0] < 1e-10; },
      [](const Point<2> &X, const Tensor<1, 2> &u) {
        check::is_close(u[0], X[1] * X[1], 1e-12, "displacement of the left", 1);
        if (X[1] < 1 - 1e-10)
          check::is_close(u[1], 0.5, 1e-12, "second component");
      });
}

// prescribed: by component, displacement and rotation; what is not prescribed is free.
template <int dim>
void
check_platen(const ProblemType                               kind,
             const unsigned int                              degree,
             const std::array<std::optional<Expression>, 3> &displacement,
             const std::array<std::optional<Expression>, 3> &rotation)
{
  const std::string what = dim == 2 ? "platen" : "platen in 3D";
  Scene             scene;
  scene.kind   = kind;
  scene.bodies = {block("it", {0, 0, 0}, {2, 1, 1})};
  MotionData motion;
  motion.name                = "platen";
  motion.reference           = {0.7, 1.5, 0.2};
  motion.displacement        = displacement;
  motion.rotation            = rotation;
  scene.conditions           = {condition(ConditionData::Type::platen, {{"it", "top", {}}})};
  scene.conditions[0].motion = motion;
  const double       t       = 0.5;
  const Problem<dim> problem(scene, degree, t);

  const auto U = translation_of(problem, 0), theta = rotation_of(problem, 0);
  for (unsigned int d = 0; d < 3; ++d)
    {
      if (d < dim && displacement[d])
        check::is_close(U[d], displacement[d]->value(motion.reference, t), 1e-12, what + ": displacement", 1);
      if ((dim == 3 || d == 2) && rotation[d])
        check::is_close(theta[d], rotation[d]->value(motion.reference, t), 1e-12, what + ": rotation", 1);
      else if (dim == 3 || d == 2)
        check::is_true(std::abs(theta[d]) > 1e-6, what + ": a rotation that is not prescribed is free");
    }
  problem.for_nodes(
      0,
      [](const Point<dim> &X) { return X[dim - 1] > 1 - 1e-10; },
      [&](const Point<dim> &X, const Tensor<1, dim> &u) {
        check_zero(u - rigid(U, theta, motion.reference, X), what + ": moves as a rigid body");
      });
  // Its corners, too.
  for (unsigned int k = 0; k <= dim; ++k)
    {
      Point<dim> X;
      for (unsigned int d = 0; d < dim; ++d)
        X[d] = motion.reference[d] + (k == d + 1 ? problem.geometry.carriers[0].size : 0.);
      check_zero(problem.corner(0, k) - rigid(U, theta, motion.reference, X), what + ": carrier");
    }
}

template <int dim>
void
check_platens(const ProblemType kind, const unsigned int degree)
{
  const std::optional<Expression> free, zero = Expression(0.), some = Expression("0.3*t", {}),
                                        more = Expression("0.1 - t", {});
  check_platen<dim>(kind, degree, {{free, free, free}}, {{free, free, free}});
  check_platen<dim>(kind, degree, {{zero, some, more}}, {{zero, zero, zero}});
  check_platen<dim>(kind, degree, {{free, some, free}}, {{free, free, free}});
  check_platen<dim>(kind, degree, {{some, free, zero}}, {{some, more, some}});
  check_platen<dim>(kind, degree, {{some, free, zero}}, {{some, free, more}});
  check_platen<dim>(kind, degree, {{free, free, free}}, {{free, more, free}});
}

void
check_rigid_body(const unsigned int degree)
{
  Scene scene;
  scene.bodies = {block("it", {0, 0, 0}, {2, 1, 0}), block("rigid", {0, 1, 0}, {2, 2, 0})};
  MotionData motion;
  motion.name           = "rigid";
  motion.reference      = {1, 3, 0};
  motion.displacement   = {{Expression(0.1), Expression("-t", {}), {}}};
  motion.rotation[2]    = Expression("0.2*t", {});
  scene.bodies[1].rigid = motion;
  for (const bool prescribed : {true, false})
    {
      if (!prescribed)
        scene.bodies[1].rigid->rotation[2] = scene.bodies[1].rigid->displacement[0] = {};
      const Problem<2> problem(scene, degree, 0.5, true);
      check::is_true(problem.discretization->is_deformable(0) && !problem.discretization->is_deformable(1),
                     "which body is rigid");
      const auto U = translation_of(problem, 0), theta = rotation_of(problem, 0);
      check::is_close(U[1], -0.5, 1e-12, "displacement of a rigid body");
      if (prescribed)
        {
          check::is_close(U[0], 0.1, 1e-12, "displacement of a rigid body");
          check::is_close(theta[2], 0.1, 1e-12, "rotation of a rigid body");
        }
      problem.for_nodes(
          1,
          [](const Point<2> &) { return true; },
          [&](const Point<2> &X, const Tensor<1, 2> &u) {
            check_zero(u - rigid(U, theta, motion.reference, X), "a rigid body follows its motion");
          });
      for (const Point<2> X : {Point<2>(0.3, 1.2), Point<2>(-4, 7)})
        {
          const auto   weights = problem.discretization->carrier_weights(0, X);
          Tensor<1, 2> u;
          for (unsigned int k = 0; k < 3; ++k)
            u += weights[k] * problem.corner(0, k);
          check_zero(u - rigid(U, theta, motion.reference, X), "carrier weights");
        }
    }
}

// u = U + (R - 1) (X - reference), R = exp(theta x) by its series
template <int dim>
Tensor<1, dim>
turned(const Tensor<1, 3> &U, const Tensor<1, 3> &theta, const Point<3> &reference, const Point<dim> &X)
{
  Tensor<1, 3> term;
  for (unsigned int d = 0; d < dim; ++d)
    term[d] = X[d] - reference[d];
  Tensor<1, 3> v = U;
  for (unsigned int n = 1; n < 60; ++n)
    {
      term = cross_product_3d(theta, term) / n;
      v += term;
    }
  Tensor<1, dim> u;
  for (unsigned int d = 0; d < dim; ++d)
    u[d] = v[d];
  return u;
}

MotionData
motion_of(const std::string  &name,
          const Point<3>     &reference,
          const Tensor<1, 3> &displacement,
          const Tensor<1, 3> &rotation)
{
  MotionData motion;
  motion.name      = name;
  motion.reference = reference;
  for (unsigned int d = 0; d < 3; ++d)
    {
      motion.displacement[d] = Expression(displacement[d]);
      motion.rotation[d]     = Expression(rotation[d]);
    }
  return motion;
}

// A platen, a rigid body and an obstacle, each about another vector.
template <int dim>
void
check_finite_rotations(const unsigned int degree, const std::array<Tensor<1, 3>, 3> &theta)
{
  const std::array<Point<3>, 3>     reference = {{{0.7, 1.5, 0.2}, {1, 3, -1}, {-2, 0.4, 0.6}}};
  const std::array<Tensor<1, 3>, 3> U         = {{Tensor<1, 3>({0.3, -0.1, dim == 2 ? 0. : 0.2}),
                                                  Tensor<1, 3>({-1, 0.5, dim == 2 ? 0. : 2.}),
                                                  Tensor<1, 3>()}};
  Scene                             scene;
  scene.kind          = dim == 2 ? ProblemType::plane_strain : ProblemType::three_dimensional;
  scene.kinematics    = Kinematics::finite_strain;
  const double height = dim == 2 ? 0 : 1;
  scene.bodies        = {block("it", {0, 0, 0}, {2, 1, height}), block("rigid", {0, 2, 0}, {2, 3, height})};
  scene.conditions    = {condition(ConditionData::Type::platen, {{"it", "top", {}}})};
  scene.conditions[0].motion = motion_of("platen", reference[0], U[0], theta[0]);
  scene.bodies[1].rigid      = motion_of("rigid", reference[1], U[1], theta[1]);
  scene.obstacles.emplace_back();
  scene.obstacles[0].name   = "plane";
  scene.obstacles[0].motion = motion_of("plane", reference[2], U[2], theta[2]);
  const Problem<dim>               problem(scene, degree);
  const std::array<std::string, 3> names = {{"platen", "rigid", "plane"}};
  const auto moved = [&](const unsigned int i, const Point<dim> &X, const Tensor<1, dim> &u) {
    check_zero(u - turned(U[i], theta[i], reference[i], X), "finite rotation: " + names[i]);
  };
  problem.for_nodes(
      0,
      [](const Point<dim> &X) { return X[dim - 1] > 1 - 1e-10; },
      [&](const Point<dim> &X, const Tensor<1, dim> &u) { moved(0, X, u); });
  problem.for_nodes(
      1,
      [](const Point<dim> &) { return true; },
      [&](const Point<dim> &X, const Tensor<1, dim> &u) { moved(1, X, u); });
  for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int m = problem.geometry.carrier(names[i]);
      for (unsigned int k = 0; k <= dim; ++k)
        {
          Point<dim> X;
          for (unsigned int d = 0; d < dim; ++d)
            X[d] = reference[i][d] + (k == d + 1 ? problem.geometry.carriers[m].size : 0.);
          moved(i, X, problem.corner(m, k));
        }
    }
}

void
check_axisymmetric(const unsigned int degree)
{
  Scene scene;
  scene.kind   = ProblemType::axisymmetric;
  scene.bodies = {block("it", {0, 0, 0}, {2, 1, 0})};
  MotionData motion;
  motion.name                = "platen";
  motion.reference           = {5, 1, 0};
  motion.displacement[1]     = Expression(-0.25);
  scene.conditions           = {condition(ConditionData::Type::platen, {{"it", "top", {}}})};
  scene.conditions[0].motion = motion;
  for (const bool prescribed : {true, false})
    {
      if (!prescribed)
        scene.conditions[0].motion->displacement[1] = {};
      const Problem<2> problem(scene, degree);
      problem.for_nodes(
          0,
          [](const Point<2> &X) { return X[0] < 1e-10; },
          [](const Point<2> &, const Tensor<1, 2> &u) {
            check::is_close(u[0], 0, 1e-12, "the axis stays", 1);
          });
      const double w = prescribed ? -0.25 : problem.corner(0, 0)[1];
      problem.for_nodes(
          0,
          [](const Point<2> &X) { return X[1] > 1 - 1e-10; },
          [w](const Point<2> &, const Tensor<1, 2> &u) {
            check_zero(u - Tensor<1, 2>({0, w}), "axisymmetric platen moves axially");
          });
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      for (const double angle : {0., 30., 45., 90., 137.})
        check_planes(degree, angle);
      check_planes_3d(degree);
      check_displacement(degree);
      check_platens<2>(ProblemType::plane_strain, degree);
      check_platens<3>(ProblemType::three_dimensional, degree);
      check_rigid_body(degree);
      check_axisymmetric(degree);
      const auto vector = [](const double x, const double y, const double z) {
        return Tensor<1, 3>({x, y, z});
      };
      check_finite_rotations<2>(degree,
                                {{vector(0, 0, 0.5 * numbers::PI), vector(0, 0, -4), vector(0, 0, 0)}});
      check_finite_rotations<3>(degree,
                                {{vector(0, 0, 0.5 * numbers::PI), vector(0, -1, 0), vector(3, 0, 0)}});
      check_finite_rotations<3>(degree, {{vector(1, -2, 0.5), vector(0.1, 0, 2), vector(-1, -1, 4)}});
    }
  return check::result();
}
} // namespace test_supports

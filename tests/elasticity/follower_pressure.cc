// Pressure on the current surface: its stiffness is its derivative, on a closed surface it does work on the
// volume only, it turns with the body, and covered points take it away; other loads stay as they were.
#include "check.h"
#include "deformed_blocks.h"

#include <amontons/elasticity/loads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

namespace test_follower_pressure
{
using namespace Amontons;

namespace
{
  ConditionData
  load(const ConditionData::Type type, const std::vector<std::string> &boundaries, const Expression &value)
  {
    ConditionData condition;
    condition.type = type;
    for (const auto &boundary : boundaries)
      condition.boundaries.push_back({"it", boundary, {}});
    condition.value[0] = value;
    return condition;
  }

  ConditionData
  pressure_everywhere(const int dim, const Expression &value)
  {
    std::vector<std::string> boundaries = {"left", "right", "bottom", "top"};
    if (dim == 3)
      boundaries.insert(boundaries.end(), {"front", "back"});
    return load(ConditionData::Type::pressure, boundaries, value);
  }

  template <int dim>
  LA::Vector
  loads_at(const Problem<dim> &problem, const LA::Vector &u)
  {
    return assemble_loads<dim>(*problem.discretization, 2, {}, &u);
  }

  template <int dim>
  void
  check_stiffness(const Case &c)
  {
    Problem<dim> problem(c, {{2, 1, 1}});
    problem.scene.conditions = {pressure_everywhere(dim, Expression("t*(1 + x*y)", {}))};
    const LA::Vector u = problem.random_field(0.2 / c.degree), v = problem.random_field(1. / c.degree);
    LA::Vector       difference = derivative([&](const LA::Vector &w) { return loads_at(problem, w); }, u, v);
    const double     scale      = difference.linfty_norm();
    for (const auto &part : pressure_stiffness(*problem.discretization, 2, u))
      {
        Vector<double> local(part.columns.size()), force(part.rows.size());
        v.extract_subvector_to(part.columns.begin(), part.columns.end(), local.begin());
        part.matrix.vmult(force, local);
        force *= -1;
        difference.add(part.rows, force);
      }
    difference.compress(VectorOperation::add);
    check::is_close(difference.linfty_norm(), 0, 1e-10, c.name() + ": stiffness of the pressure", scale);
  }

  template <int dim>
  double
  current_volume(const Problem<dim> &problem, const LA::Vector &u)
  {
    const auto           &fe = problem.discretization->fe;
    FEValues<dim>         values(problem.discretization->mapping(),
                         fe,
                         QGauss<dim>(fe.degree + 3),
                         ElasticityOperator<dim>::needed_flags());
    FiniteKinematics<dim> kinematics(fe, problem.scene.kind);
    std::vector<double>   local(fe.n_dofs_per_cell());
    double                volume = 0;
    for (const auto &cell : problem.discretization->dof_handler.active_cell_iterators())
      {
        values.reinit(cell);
        std::vector<types::global_dof_index> dofs(local.size());
        cell->get_dof_indices(dofs);
        u.extract_subvector_to(dofs, local);
        kinematics.reinit(values, local);
        for (unsigned int q = 0; q < kinematics.n_points(); ++q)
          volume += kinematics.weight(q) * kinematics.jacobian(q);
      }
    return volume;
  }

  template <int dim>
  void
  check_closed_surface(const Case &c)
  {
    Problem<dim> problem(c, {{2, 1, 1}});
    problem.scene.conditions = {pressure_everywhere(dim, Expression(3.))};
    const LA::Vector u = problem.random_field(0.2 / c.degree), v = problem.random_field(1. / c.degree);
    check::is_close(loads_at(problem, u) * v,
                    -3 * derivative([&](const LA::Vector &w) { return current_volume(problem, w); }, u, v),
                    1e-9,
                    c.name() + ": work of pressure on a closed surface");
  }

  // A straight block turned by 90 degrees and stretched along its new height: the pressure on its right side
  // (face 1), now at the top, pushes down, on its left one up, and covering that side leaves nothing.
  void
  check_covered(const unsigned int degree, const unsigned int face)
  {
    Problem<2> problem({ProblemType::plane_strain, degree, 0.3, Law::neo_hookean}, {{1, 1, 1}});
    for (const auto &cell : problem.geometry.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        cell->vertex(v) = Point<2>(1 + v % 2, v / 2);
    problem.scene.conditions = {
        load(ConditionData::Type::pressure, {face == 1 ? "right" : "left"}, Expression(3.))};
    LA::Vector u   = problem.discretization->make_relevant_vector();
    const auto all = problem.discretization->dof_handler.begin_active();
    {
      LA::Vector                           owned = problem.discretization->make_owned_vector();
      const FESystem<2>                   &fe    = problem.discretization->fe;
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      all->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        {
          const unsigned int component = fe.system_to_component_index(i).first;
          const Point<2>     X         = fe.unit_support_point(i) + Point<2>(1, 0);
          owned(dofs[i])               = (component == 0 ? -1.5 * X[1] : X[0]) - X[component];
        }
      owned.compress(VectorOperation::insert);
      u = owned;
    }
    const auto sum = [&](const LA::Vector &loads, const unsigned int c) {
      double force = 0;
      for (const auto &[dof, component] : problem.components)
        if (component == c)
          force += loads(dof);
      return force;
    };
    const LA::Vector loads = loads_at(problem, u);
    check::is_close(sum(loads, 0), 0, 1e-12, "no force across", 3);
    check::is_close(sum(loads, 1), face == 1 ? -4.5 : 4.5, 1e-12, "pressure on the turned side");

    const QGauss<1>              points(4);
    std::vector<CoveredPoint<2>> covered;
    for (unsigned int q = 0; q < points.size(); ++q)
      covered.push_back({all, face, Point<2>(face, points.point(q)[0]), 1.5 * points.weight(q)});
    check::is_close(assemble_loads<2>(*problem.discretization, 2, covered, &u).linfty_norm(),
                    0,
                    1e-12,
                    "pressure on a covered side",
                    loads.linfty_norm());
  }

  template <int dim>
  void
  check_dead_loads(const Case &c)
  {
    Problem<dim> problem(c, {{2, 1, 1}});
    problem.scene.conditions = {load(ConditionData::Type::traction, {"top"}, Expression("x*t", {})),
                                load(ConditionData::Type::total_force, {"right"}, Expression(-2.))};
    problem.scene.bodies[0].body_force[1] = Expression("1 + y", {});
    LA::Vector difference                 = loads_at(problem, problem.random_field(0.2 / c.degree));
    difference -= assemble_loads<dim>(*problem.discretization, 2, {});
    check::is_close(difference.linfty_norm(), 0, 1e-15, c.name() + ": dead loads");
  }

  template <int dim>
  void
  check_all(const Case &c)
  {
    check_stiffness<dim>(c);
    check_closed_surface<dim>(c);
    check_dead_loads<dim>(c);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      for (const ProblemType kind : {ProblemType::plane_strain, ProblemType::axisymmetric})
        check_all<2>({kind, degree, 0.3, Law::neo_hookean});
      check_all<3>({ProblemType::three_dimensional, degree, 0.3, Law::neo_hookean});
      {
        check_covered(degree, 0);
        check_covered(degree, 1);
      }
    }
  return check::result();
}
} // namespace test_follower_pressure

#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/friction/active_set.h>
#include <amontons/solver/contact_nodes.h>
#include <amontons/solver/semismooth_newton.h>

namespace Amontons
{
  void
  NewtonParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact solver");
    prm.add_parameter("Maximum iterations",
                      max_iterations,
                      "Of the active-set (semismooth Newton) iteration on one mesh.",
                      Patterns::Integer(1));
    prm.add_parameter("Tolerance",
                      tolerance,
                      "Residual of the equilibrium relative to the internal forces.",
                      Patterns::Double(1e-14, 1e-2));
    prm.add_parameter(
        "Complementarity factor",
        scaling,
        "Multiplies the complementarity parameter c = E/h; neither the result nor the number of "
        "iterations should depend on it.",
        Patterns::Double(1e-8, 1e8));
    prm.leave_subsection();
  }

  template <int dim>
  SemismoothNewton<dim>::SemismoothNewton(const NewtonParameters       &parameters,
                                          const LinearSolverParameters &solver_parameters,
                                          const Discretization<dim>    &discretization,
                                          TimerOutput                  &timer)
      : parameters(parameters), solver_parameters(solver_parameters), discretization(discretization),
        timer(timer)
  {
  }

  template <int dim>
  NewtonReport
  SemismoothNewton<dim>::solve(const ElasticityOperator<dim>            &elasticity,
                               const std::vector<ContactInterface<dim>> &interfaces,
                               const Constraints                        &supports,
                               const LA::Vector                         &loads,
                               SolutionState                            &state,
                               const Observer                           &observer)
  {
    NewtonReport        report;
    TimerOutput::Scope  scope(timer, "contact iteration");
    const MPI_Comm      communicator = discretization.geometry.communicator;
    const auto          nodes        = collect_contact_nodes(discretization, interfaces, parameters.scaling);
    FloatingBodies<dim> floating(discretization, supports, interfaces);

    std::vector<const LinearEquation *> all;
    for (const auto &node : nodes)
      for (const auto &e : node.equations)
        all.push_back(&e.equation);
    floating.set_loads(loads);
    report.note = floating.check_loads(all);
    floating.choose_pins(all);

    LA::Vector u(discretization.locally_owned, communicator);
    u = state.displacement;
    supports.distribute(u);
    state.displacement = u;

    std::vector<bool> closed;
    bool              have_guess = state.states.size() == interfaces.size();
    for (unsigned int i = 0; have_guess && i < interfaces.size(); ++i)
      have_guess = state.states[i].size() == interfaces[i].coupling.rows.size();
    if (have_guess)
      for (const auto &node : nodes)
        closed.push_back(node.tied || state.states[node.interface][node.row] != ContactState::open);
    else
      closed = first_guess_of_closed_nodes(nodes, interfaces, floating, state.displacement);

    const CellMatrices cells{
        elasticity.n_cells(), [&](const unsigned int c) -> const auto &{return elasticity.dofs(c);
  }
  , [&](const unsigned int c) -> const auto & { return elasticity.matrix(c); }
};
std::vector<LinearEquation> candidates;
for (const auto *equation : all)
  {
    candidates.push_back(*equation);
    substitute(candidates.back(), supports);
  }

// Terms on the increment only, which vanish at convergence: pins for motions that contact can never hold, and
// a weak diagonal for those that no closed node holds yet.
const double proximal_factor = 1e-8;
LA::Vector   proximal        = discretization.make_owned_vector();
LA::Vector   pins            = discretization.make_owned_vector();
if (floating.any())
  {
    double largest = 0;
    for (unsigned int c = 0; c < cells.n; ++c)
      for (unsigned int i = 0; i < cells.dofs(c).size(); ++i)
        {
          largest = std::max(largest, cells.matrix(c)(i, i));
          if (floating.floats()[elasticity.body(c)])
            proximal(cells.dofs(c)[i]) += proximal_factor * cells.matrix(c)(i, i);
        }
    proximal.compress(VectorOperation::add);
    largest = Utilities::MPI::max(largest, communicator);
    for (unsigned int m = 0; m < discretization.carrier_dofs.size(); ++m)
      for (const auto &corner : discretization.carrier_dofs[m])
        for (const auto dof : corner)
          if (discretization.locally_owned.is_element(dof))
            proximal(dof) = proximal_factor * largest;
    for (const auto dof : floating.pins())
      if (discretization.locally_owned.is_element(dof))
        pins(dof) = largest;
    proximal.compress(VectorOperation::insert);
    pins.compress(VectorOperation::insert);
    proximal += pins;
  }

// The factorisation refers to the matrix, which must outlive it.
CondensedSystem system(discretization.locally_owned, discretization.relevant, communicator);
LinearSolver    solver(solver_parameters, dim);
const auto      n_dofs = discretization.dof_handler.n_dofs();
if (!solver.is_direct(n_dofs))
  solver.set_near_null_space(rigid_body_modes(discretization));
Timer linear_solve;
{
  TimerOutput::Scope scope(timer, "sparsity and bulk matrix");
  system.setup(cells, supports, candidates);
}

ActiveSetUpdate     update;
LA::Vector          du(discretization.locally_owned, communicator);
std::vector<double> multipliers, pressure(nodes.size()), gap(nodes.size()), c(nodes.size());
for (unsigned int k = 0; k < nodes.size(); ++k)
  c[k] = nodes[k].c;
std::unique_ptr<ContactConstraints> constraints;
std::vector<unsigned int>           first_equation; // of closed node k
bool                                set_changed = true;
std::string                         unheld;         // motions that the closed nodes leave
double                              forcing = 1e-8; // the first solve is the one that is timed

for (unsigned int iteration = 0; iteration < parameters.max_iterations; ++iteration)
  {
    NewtonReport::Iteration step{};
    if (set_changed)
      {
        TimerOutput::Scope           scope(timer, "assemble condensed system");
        std::vector<ContactEquation> active;
        first_equation.assign(nodes.size(), numbers::invalid_unsigned_int);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (closed[k])
            {
              first_equation[k] = active.size();
              active.insert(active.end(), nodes[k].equations.begin(), nodes[k].equations.end());
            }
        constraints = std::make_unique<ContactConstraints>(supports, active);
        std::vector<const LinearEquation *> holding;
        for (const auto &equation : active)
          holding.push_back(&equation.equation);
        unheld = floating.unheld_by(holding);
        system.assemble(cells,
                        constraints->all(),
                        !unheld.empty()            ? &proximal
                        : !floating.pins().empty() ? &pins
                                                   : nullptr);
        solver.matrix_changed(system.matrix(), iteration == 0);
      }

    // Move on to the constraints, then solve for the homogeneous increment.
    constraints->all().distribute(u);
    state.displacement  = u;
    LA::Vector residual = loads;
    residual -= elasticity.apply(state.displacement);
    LA::Vector rhs = condense(residual, constraints->all(), loads);
    for (const auto dof : discretization.locally_owned)
      if (constraints->all().is_constrained(dof))
        rhs(dof) = 0;
    {
      TimerOutput::Scope scope(timer, "linear solve");
      LA::Vector         owned_rhs(discretization.locally_owned, communicator);
      owned_rhs         = rhs;
      const auto result = solver.solve(system.matrix(), du, owned_rhs, forcing);
      step.krylov       = result.iterations;
      if (!result.success)
        {
          report.message =
              "the linear solver failed after " + std::to_string(result.iterations) + " iterations";
          return report;
        }
    }
    if (iteration == 0)
      report.one_linear_solve_seconds = linear_solve.wall_time();
    u += du;
    constraints->all().distribute(u);
    state.displacement = u;

    // Contact forces from the unconstrained residual.
    LA::Vector internal = elasticity.apply(state.displacement);
    LA::Vector raw      = internal;
    raw -= loads;
    const LA::Vector    on_supports = condense(raw, supports, loads);
    std::vector<double> at_pivots(constraints->pivots().size(), 0.);
    for (unsigned int e = 0; e < at_pivots.size(); ++e)
      if (const auto pivot = constraints->pivots()[e];
          pivot && discretization.locally_owned.is_element(*pivot))
        at_pivots[e] = on_supports(*pivot);
    Utilities::MPI::sum(at_pivots, communicator, at_pivots);
    multipliers = constraints->recover_multipliers(at_pivots);

    double largest_pressure = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const auto &equation = nodes[k].equations[0].equation;
        pressure[k]          = closed[k] ? multipliers[first_equation[k]] / nodes[k].area : 0.;
        gap[k]               = closed[k] ? 0. : equation.value - evaluate(equation, state.displacement);
        if (closed[k] && !constraints->pivots()[first_equation[k]])
          pressure[k] = 0;
        largest_pressure = std::max(largest_pressure, std::abs(pressure[k]));
        (nodes[k].tied ? step.n_stick : closed[k] ? step.n_slip : step.n_open) += 1;
      }

    LA::Vector free_residual = condense(raw, constraints->all(), loads);
    for (const auto dof : discretization.locally_owned)
      if (constraints->all().is_constrained(dof))
        free_residual(dof) = 0;
    // What rounding leaves of |K||u| counts as zero: scenes without stress, stiff bodies on soft ones.
    const double rounding = 1e-14 * elasticity.rounding_scale(state.displacement);
    const double scale    = std::max({internal.l2_norm(), loads.l2_norm(), rounding / parameters.tolerance});
    step.residual         = scale > 0 ? free_residual.l2_norm() / scale : 0;

    std::vector<bool> next = closed;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (nodes[k].tied)
        pressure[k] = std::numeric_limits<double>::max();
    step.n_changes     = update.update(pressure, gap, c, 1e-9 * largest_pressure, next);
    set_changed        = step.n_changes > 0;
    closed             = set_changed ? next : closed;
    report.safeguarded = report.safeguarded || update.safeguarded();
    report.iterations.push_back(step);
    observer(step);
    if (!std::isfinite(step.residual))
      {
        report.message = "the residual is not a number";
        return report;
      }
    if (!set_changed)
      {
        if (step.residual <= parameters.tolerance)
          {
            report.converged = true;
            break;
          }
        if (report.iterations.size() > 1 && !unheld.empty() &&
            step.residual > 0.5 * report.iterations[report.iterations.size() - 2].residual)
          {
            report.message =
                "the loads drive the rigid " + unheld +
                ", and no node that is closed holds it: the bodies move apart or slide off each other; "
                "reverse the load, move the bodies together, or hold this motion by a support";
            break;
          }
        forcing = std::min(1e-2, std::max(1e-14, 0.1 * parameters.tolerance / step.residual));
      }
    else
      // While many nodes still change, systems are solved as far as that is worth; the last ones for good.
      forcing = step.n_changes > 4 + 0.05 * step.n_slip ? 1e-4 : solver_parameters.tolerance;
  }

// The result by interface and row.
state.states.assign(interfaces.size(), {});
state.pressures.assign(interfaces.size(), {});
state.gaps.assign(interfaces.size(), {});
state.tied_multipliers.assign(interfaces.size(), {});
for (unsigned int k = 0; k < nodes.size(); ++k)
  {
    const auto i = nodes[k].interface;
    state.states[i].push_back(nodes[k].tied ? ContactState::stick
                              : closed[k]   ? ContactState::slip
                                            : ContactState::open);
    state.gaps[i].push_back(gap[k]);
    std::vector<double> tied(nodes[k].tied ? dim : 0, 0.);
    double              p = 0;
    if (closed[k] && !report.iterations.empty() && first_equation[k] != numbers::invalid_unsigned_int)
      {
        if (nodes[k].tied)
          for (unsigned int d = 0; d < dim; ++d)
            {
              tied[d] = multipliers[first_equation[k] + d] / nodes[k].area;
              p += tied[d] * interfaces[i].coupling.rows[nodes[k].row].normal[d];
            }
        else
          p = pressure[k];
      }
    state.pressures[i].push_back(p);
    state.tied_multipliers[i].push_back(tied);
  }
if (!unheld.empty())
  {
    double force = 0;
    for (const auto dof : discretization.locally_owned)
      force += std::abs(proximal(dof) * du(dof));
    const double load           = loads.l1_norm();
    force                       = Utilities::MPI::sum(force, communicator);
    report.regularisation_force = load > 0 ? force / load : force;
  }
if (!report.converged && report.message.empty())
  report.message = "no converged contact set after " + std::to_string(report.iterations.size()) +
                   " iterations (residual " + std::to_string(report.iterations.back().residual) + ", " +
                   std::to_string(report.iterations.back().n_changes) +
                   " nodes still change); try a finer mesh, smaller loads or more iterations";
return report;
}

template class SemismoothNewton<2>;
} // namespace Amontons

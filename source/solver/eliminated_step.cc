#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/elasticity/geometric_forces.h>
#include <amontons/solver/condensed_friction.h>
#include <amontons/solver/eliminated_step.h>
#include <amontons/solver/stability.h>

namespace Amontons
{
  namespace
  {
    // A response costs a tenth to a twentieth of a factorisation, in small systems less than their assembly.
    unsigned int
    most_responses(const types::global_dof_index n_dofs)
    {
      return std::max<types::global_dof_index>(100, 400000 / n_dofs);
    }
  } // namespace

  template <int dim>
  EliminatedStep<dim>::EliminatedStep(const ContactEquilibrium<dim> &problem)
      : problem(problem), any_friction(problem.contact.any_friction()),
        system(problem.discretization.locally_owned,
               problem.discretization.relevant,
               problem.discretization.geometry.communicator),
        solver(problem.solver_parameters, dim, !any_friction, problem.gives_up)
  {
  }

  // The pattern, and the bulk of the matrix.
  template <int dim>
  void
  EliminatedStep<dim>::prepare(const LA::Vector *springs)
  {
    if (!solver.is_direct(problem.discretization.dof_handler.n_dofs()))
      solver.set_near_null_space(rigid_body_modes(problem.discretization));

    TimerOutput::Scope           scope(problem.timer, "sparsity and bulk matrix");
    std::vector<ContactEquation> candidates;
    for (const auto &node : problem.contact.nodes())
      for (const auto *equation : node.holding())
        {
          candidates.push_back(*equation);
          substitute(candidates.back().equation, problem.supports);
        }
    for (const auto &node : problem.contact.nodes())
      if (node.frictional || (node.tied && !node.planes.empty())) // slip and planes mix components
        {
          candidates.push_back(all_components(node));
          substitute(candidates.back().equation, problem.supports);
        }
    system.setup(problem.mechanics.bodies().tangent(), problem.supports, candidates, springs);
  }

  template <int dim>
  void
  EliminatedStep<dim>::linearise(Iterate<dim> &now, const LA::Vector *springs, const Drag *drag)
  {
    Assert(drag == nullptr, ExcNotImplemented());
    (void)drag;
    TimerOutput::Scope scope(problem.timer, "assemble condensed system");
    system.assemble(
        problem.mechanics.bodies().tangent(), *now.constraints, springs, stiffness_of_contact(now));
    solver.matrix_changed(now.is_first() ? LinearSolver::all_rows : now.report.iterations.back().n_changes);
  }

  template <int dim>
  std::vector<LocalMatrix>
  EliminatedStep<dim>::stiffness_of_contact(const Iterate<dim> &now) const
  {
    const auto              &nodes = problem.contact.nodes();
    std::vector<LocalMatrix> matrices;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (now.states[k] != ContactStatus::open &&
          problem.discretization.locally_owned.is_element(nodes[k].holding()[0]->candidates[0]))
        {
          if (!problem.by_equations(k))
            matrices.push_back(problem.penalty->stiffness(k, now.states));
          else if (nodes[k].frictional && now.states[k] == ContactStatus::slip && now.laws[k].stiffness > 0)
            matrices.push_back(slip_stiffness(nodes[k], now.laws[k]));
        }
    return matrices;
  }

  template <int dim>
  typename EliminatedStep<dim>::Solved
  EliminatedStep<dim>::solve(const Iterate<dim> &now, const Drag *)
  {
    const auto &owned  = problem.discretization.locally_owned;
    LA::Vector  moved  = now.u, du;
    auto       &u      = problem.state.displacement;
    const auto &bodies = problem.mechanics.bodies();
    distribute(now.constraints->trial(), moved, u);
    LA::Vector       residual = problem.mechanics.loads();
    const LA::Vector internal = bodies.internal_forces(u);
    residual -= internal;
    if (any_friction || problem.penalty != nullptr)
      residual += known_contact_forces(problem, now);
    Solved result;
    result.push = condense(residual, now.constraints->test(), residual);
    zero_constrained(now.constraints->test(), owned, result.push);

    TimerOutput::Scope scope(problem.timer, "linear solve");
    du.reinit(moved);
    // Where nothing has changed since the increment before, what is left of its forces is noise.
    const double scale =
        now.is_first() ? std::max(result.push.l2_norm(), fine_tolerance() * internal.l2_norm() / forcing(now))
                       : now.force_scale;
    const auto report = solver.solve(system.matrix(), du, result.push, forcing(now) * scale);
    result.linear     = report;
    moved += du;
    distribute(now.constraints->trial(), moved, u);
    result.change = moved;
    result.change -= now.u;
    return result;
  }

  // While many nodes still change, systems are solved as far as that is worth; the last ones for good. Where
  // only weak springs hold a motion, even a small residual may be a large motion. With friction in 3D the
  // directions of slip change after the set: as far as superlinear convergence needs.
  template <int dim>
  double
  EliminatedStep<dim>::forcing(const Iterate<dim> &now) const
  {
    const auto  &nodes = problem.contact.nodes();
    const double fine  = fine_tolerance();
    if (now.is_first())
      return std::any_of(nodes.begin(), nodes.end(), [](const auto &node) { return !node.tied; }) ? 1e-4
                                                                                                  : fine;
    const auto &last = now.report.iterations.back();
    if (!now.free_modes.empty())
      return fine;
    if (dim == 3 && any_friction)
      return std::min(1e-3, std::max(fine, 0.03 * std::pow(last.residual, 1.5)));
    return now.set_changed() && last.n_changes > 0.05 * (last.n_slip + last.n_stick) ? 1e-3 : fine;
  }

  template <int dim>
  double
  EliminatedStep<dim>::fine_tolerance() const
  {
    return std::min(problem.solver_parameters.tolerance, 0.3 * problem.parameters.tolerance);
  }

  template <int dim>
  bool
  EliminatedStep<dim>::looks_ahead(const Iterate<dim> &now) const
  {
    return dim == 2 && any_friction && problem.penalty == nullptr && now.free_modes.empty() &&
           !looked_in_vain && solver.is_direct(problem.discretization.dof_handler.n_dofs());
  }

  template <int dim>
  std::vector<bool>
  EliminatedStep<dim>::movable_nodes() const
  {
    std::vector<bool> result;
    for (const auto &node : problem.contact.nodes())
      result.push_back(
          std::none_of(node.components.begin(), node.components.end(), [&](const auto &component) {
            return !component.candidates.empty() && problem.supports.is_constrained(component.candidates[0]);
          }));
    return result;
  }

  // Of the system as it stands, with the constraints of `at`.
  template <int dim>
  ContactCompliance<dim>
  EliminatedStep<dim>::compliance(const Iterate<dim> &at, const BaseSolution<dim> &base)
  {
    return {problem.discretization,
            problem.mechanics.bodies(),
            problem.supports,
            *at.constraints,
            at.first_equation,
            base,
            system.matrix(),
            solver};
  }

  // Where this ends where it began, rounding speaks differently here and there: systems of the bodies decide
  // from now on.
  template <int dim>
  unsigned int
  EliminatedStep<dim>::look_ahead(Iterate<dim>                     &now,
                                  const std::vector<ContactStatus> &before,
                                  const double                      rounding)
  {
    if (!looks_ahead(now))
      return pivot(now, before);
    TimerOutput::Scope      scope(problem.timer, "condensed contact");
    const BaseSolution<dim> base{
        problem.contact.nodes(), before, now.laws, now.answers, movable_nodes(), now.u};
    const auto              responses = compliance(now, base);
    ActiveSetLookahead<dim> condensed(
        base,
        [&](const unsigned int k, const NodeInput input) { return responses.respond(k, input); },
        most_responses(problem.discretization.dof_handler.n_dofs()));
    looked_in_vain = !condensed.lead(now.states, rounding, problem.parameters.max_iterations);
    if (looked_in_vain)
      now.states.update(now.answers, rounding);
    return condensed.n_responses();
  }

  // The system and the bodies with all nodes open but the tied ones, and what the nodes answer there.
  template <int dim>
  Iterate<dim>
  EliminatedStep<dim>::with_open_nodes(const Iterate<dim> &now, const LA::Vector *springs)
  {
    const auto  &nodes = problem.contact.nodes();
    auto        &u     = problem.state.displacement;
    Iterate<dim> open(now);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (!nodes[k].tied)
        open.states.open(k);
    open.laws.assign(nodes.size(), SlipLaw<dim>());
    open.constraints = std::make_shared<ContactConstraints>(
        constraints_of(problem, problem.supports, open.states, &open.first_equation));
    system.assemble(problem.mechanics.bodies().tangent(), *open.constraints, springs, {});
    solver.matrix_changed(LinearSolver::all_rows);
    open.u += solve(open, nullptr).change;
    u = open.u;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        open.answers[k]     = {};
        open.answers[k].gap = problem.contact.gap(k, u);
        if (nodes[k].frictional)
          open.answers[k].slip = problem.contact.slip(k, u);
      }
    u = now.u;
    return open;
  }

  template <int dim>
  double
  EliminatedStep<dim>::stress_stiffening(const Iterate<dim> &now, const double most_strain)
  {
    const auto      &discretization = problem.discretization;
    const auto      &bodies         = problem.mechanics.bodies();
    const LA::Vector stressed       = problem.state.displacement; // readable
    LA::Vector       readable = discretization.make_relevant_vector(), start = now.u;
    distribute(now.constraints->trial(), start, readable);
    // What the constraints make of a motion from there.
    const auto motion = [&](const LA::Vector &v) {
      LA::Vector moved = start;
      moved += v;
      distribute(now.constraints->trial(), moved, readable);
      moved -= start;
      return moved;
    };
    LargestRitzValue<LA::Vector> lanczos;
    lanczos.forces = [&](const LA::Vector &v) {
      readable = v;
      return geometric_forces(bodies, discretization, stressed, readable, most_strain);
    };
    lanczos.energies = [&](const LA::Vector &v) {
      readable = v;
      return bodies.internal_forces(readable);
    };
    lanczos.answer = [&](const LA::Vector &force) {
      LA::Vector push = condense(force, now.constraints->test(), force), v(push);
      zero_constrained(now.constraints->test(), discretization.locally_owned, push);
      v = 0;
      if (push.l2_norm() > 0)
        solver.solve(system.matrix(), v, push, 0.1 * push.l2_norm()); // Ritz values are right in any space
      return motion(v);
    };
    LA::Vector smooth = discretization.make_owned_vector(); // and different in all places
    for (const auto i : discretization.locally_owned)
      smooth(i) = std::sin(0.37 * i) + 0.3 * std::cos(0.011 * i);
    smooth.compress(VectorOperation::insert);
    return lanczos.find(lanczos.answer(lanczos.forces(motion(smooth))), most_strain);
  }

  // The part of the bounds of friction that does not depend on pressures, and its slope.
  template <int dim>
  std::vector<ShearBound>
  EliminatedStep<dim>::linear_bounds(const Iterate<dim> &now) const
  {
    std::vector<ShearBound> bounds(now.answers.size());
    for (unsigned int k = 0; k < bounds.size(); ++k)
      if (const double p = now.answers[k].pressure; problem.contact.nodes()[k].frictional)
        {
          bounds[k] = now.states.bound(k, p);
          bounds[k].value -= bounds[k].slope * std::max(0., p);
        }
    return bounds;
  }

  template <int dim>
  bool
  EliminatedStep<dim>::settle(Iterate<dim> &now, const LA::Vector *springs)
  {
    const unsigned int most  = 160; // nodes: each takes two solves, and four rows of a dense problem
    const auto        &nodes = problem.contact.nodes();
    if (dim == 3 || !any_friction || problem.penalty != nullptr || nodes.size() > most ||
        !solver.is_direct(problem.discretization.dof_handler.n_dofs()))
      return false;
    TimerOutput::Scope scope(problem.timer, "condensed contact");
    now.states.forget(); // bounds follow pressures again
    const auto              open = with_open_nodes(now, springs);
    const BaseSolution<dim> base{nodes, open.states.all(), open.laws, open.answers, movable_nodes(), open.u};
    const auto              responses = compliance(open, base);
    const auto              found     = solve_condensed_friction<dim>(
        base,
        [&](const unsigned int k, const NodeInput input) { return responses.respond(k, input); },
        linear_bounds(now));
    if (found)
      now.states.impose(*found);
    return found.has_value();
  }

  // Without friction, where all nodes at once change in vain.
  template <int dim>
  unsigned int
  EliminatedStep<dim>::pivot(Iterate<dim> &now, const std::vector<ContactStatus> &before)
  {
    constexpr unsigned int n_most = 800, n_most_times = 3;
    if (any_friction || !now.states.safeguarded() || !now.free_modes.empty() || problem.penalty != nullptr ||
        n_pivoted == n_most_times || !solver.is_direct(problem.discretization.dof_handler.n_dofs()))
      return 0;
    TimerOutput::Scope scope(problem.timer, "condensed contact");
    ++n_pivoted;
    unsigned int            n_responses = 0;
    const BaseSolution<dim> base{
        problem.contact.nodes(), before, now.laws, now.answers, movable_nodes(), now.u};
    const auto responses = compliance(now, base);
    const auto found     = solve_condensed_contact<dim>(
        base,
        [&](const unsigned int k, const NodeInput input) {
          ++n_responses;
          return responses.respond(k, input);
        },
        n_most);
    if (!found)
      return 0;
    now.states.impose(*found);
    now.report.pivoted = true;
    return n_responses;
  }

  template class EliminatedStep<2>;
  template class EliminatedStep<3>;
} // namespace Amontons

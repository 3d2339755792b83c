#include <amontons/elasticity/geometric_forces.h>
#include <amontons/solver/condensed_friction.h>
#include <amontons/solver/eliminated_step.h>
#include <amontons/solver/stability.h>

namespace Amontons
{
  namespace
  {
    // A response costs a fiftieth of a factorisation, in space a hundredth, in small systems less than their
    // assembly does, and serves as long as the factors: those that are new may cost two. All of them take
    // memory.
    template <int dim>
    unsigned int
    most_responses(const unsigned int            n_known,
                   const std::size_t             n_nodes,
                   const types::global_dof_index n_dofs)
    {
      constexpr std::size_t bytes = 256 << 20;
      const std::size_t     n_new = std::max<std::size_t>(dim == 2 ? 128 : 256, 400000 / n_dofs);
      return std::min(n_known + n_new, bytes / (sizeof(NodalContact<dim>) * n_nodes));
    }

    template <int dim>
    std::vector<bool>
    movable_nodes(const ContactEquilibrium<dim> &problem)
    {
      std::vector<bool> result;
      for (const auto &node : problem.contact.nodes())
        result.push_back(
            std::none_of(node.components.begin(), node.components.end(), [&](const auto &component) {
              return !component.candidates.empty() &&
                     problem.supports.is_constrained(component.candidates[0]) &&
                     !others_hold(component, problem.supports);
            }));
      return result;
    }
  } // namespace

  template <int dim>
  EliminatedStep<dim>::EliminatedStep(const ContactEquilibrium<dim> &problem, KeptSystem<dim> &kept)
      : problem(problem), any_friction(problem.contact.any_friction()), movable(movable_nodes(problem)),
        kept(kept)
  {
  }

  template <int dim>
  void
  EliminatedStep<dim>::prepare(const LA::Vector *springs)
  {
    kept.prepare(problem, springs);
  }

  template <int dim>
  void
  EliminatedStep<dim>::linearise(Iterate<dim> &now, const LA::Vector *new_springs, const Drag *drag)
  {
    Assert(drag == nullptr, ExcNotImplemented());
    (void)drag;
    springs = new_springs;
    by_base = is_near_base(now);
    if (!by_base)
      assemble(now);
  }

  template <int dim>
  void
  EliminatedStep<dim>::assemble(const Iterate<dim> &now)
  {
    TimerOutput::Scope scope(problem.timer, "assemble condensed system");
    const bool         by_equations = problem.penalty == nullptr;
    const bool is_known = kept.has_states() && kept.has_springs(springs) && (by_equations || !now.is_first());
    const unsigned int n_others = is_known ? kept.n_other_states(now.states) : LinearSolver::all_rows;
    if (!any_friction && by_equations && n_others == 0)
      return; // the same matrix
    base.reset();
    kept.assemble(problem, now, springs, stiffness_of_contact(now));
    if (looks_ahead(now))
      kept.solver->values_changed(); // what responds to single inputs are factors
    else
      kept.solver->matrix_changed(n_others);
  }

  // What tells of the present states costs less than a factorisation does.
  template <int dim>
  bool
  EliminatedStep<dim>::is_near_base(const Iterate<dim> &now)
  {
    constexpr unsigned int n_most_unknown = dim == 2 ? 64 : 256;
    if (!looks_ahead(now) || !kept.has_states() || !kept.solver->has_factors() || !kept.has_springs(springs))
      return false;
    const auto from = base_solution(kept.states, kept.laws, now);
    return condensed(from).n_unknown(now.states) <= n_most_unknown;
  }

  // With the states and laws of the matrix, at the present loads.
  template <int dim>
  void
  EliminatedStep<dim>::find_base(const Iterate<dim> &now)
  {
    base.emplace(now);
    for (unsigned int k = 0; k < kept.states.size(); ++k)
      base->states.impose(k, kept.states[k], kept.laws[k]);
    base->laws        = kept.laws;
    base->constraints = std::make_shared<ContactConstraints>(
        constraints_of(problem, problem.supports, base->states, &base->first_equation));
    by_base = false;
    base->u += solve(*base, nullptr).change;
    by_base             = true;
    const auto &u       = problem.state.displacement; // that of the base
    LA::Vector  balance = problem.mechanics.bodies().internal_forces(u);
    balance -= problem.mechanics.loads();
    balance -= known_contact_forces(problem, *base);
    base->answers = nodal_answers(problem, *base, problem.supports, balance);
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

  // `moved` obeys the constraints of `now` then, and is the displacement of the state.
  template <int dim>
  typename EliminatedStep<dim>::Push
  EliminatedStep<dim>::push_at(const Iterate<dim> &now, LA::Vector &moved) const
  {
    auto &u = problem.state.displacement;
    distribute(now.constraints->trial(), moved, u);
    LA::Vector       residual = problem.mechanics.loads();
    const LA::Vector internal = problem.mechanics.bodies().internal_forces(u);
    residual -= internal;
    if (any_friction || problem.penalty != nullptr)
      residual += known_contact_forces(problem, now);
    Push result = {condense(residual, now.constraints->test(), residual), internal.l2_norm()};
    zero_constrained(now.constraints->test(), problem.discretization.locally_owned, result.condensed);
    return result;
  }

  template <int dim>
  typename EliminatedStep<dim>::Solved
  EliminatedStep<dim>::solve(const Iterate<dim> &now, const Drag *)
  {
    if (by_base)
      {
        if (auto solved = solve_by_base(now))
          return *solved;
        by_base = false;
        assemble(now);
      }
    LA::Vector moved = now.u, du;
    const Push push  = push_at(now, moved);
    Solved     result;
    result.push = push.condensed;

    TimerOutput::Scope scope(problem.timer, "linear solve");
    du.reinit(moved);
    // Where nothing has changed since the increment before, what is left of its forces is noise.
    const double scale =
        now.is_first() ? std::max(result.push.l2_norm(), fine_tolerance() * push.internal / forcing(now))
                       : now.force_scale;
    result.linear = kept.solver->solve(kept.system->matrix(), du, result.push, forcing(now) * scale);
    moved += du;
    distribute(now.constraints->trial(), moved, problem.state.displacement);
    result.change = moved;
    result.change -= now.u;
    return result;
  }

  // The displacement is that of the base and what the inputs that lead to the present states make of it:
  // nothing if rounding leaves too much of the forces.
  template <int dim>
  std::optional<typename EliminatedStep<dim>::Solved>
  EliminatedStep<dim>::solve_by_base(const Iterate<dim> &now)
  {
    TimerOutput::Scope scope(problem.timer, "condensed contact");
    LA::Vector         moved = now.u;
    const Push         start = push_at(now, moved);
    Solved             result;
    result.push              = start.condensed;
    result.linear.iterations = base ? 0 : 1;
    if (!base)
      find_base(now);
    const auto from = base_solution(base->states.all(), base->laws, *base);
    auto       only = condensed(from);
    const auto x    = only.inputs(now.states);
    if (!x)
      return {};
    result.linear.iterations += only.n_asked();
    moved = base->u;
    if (!x->empty())
      moved += compliance(*base, from).motion(*x);
    const Push   left   = push_at(now, moved);
    const double rest   = left.condensed.l2_norm(),
                 enough = fine_tolerance() * std::max(start.condensed.l2_norm(), left.internal);
    if (!(rest <= enough) &&
        !(rest <= 1e-14 * problem.mechanics.bodies().rounding_scale(problem.state.displacement)))
      return {};
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
    const double given = problem.solver_parameters.tolerance, of_forces = problem.parameters.tolerance;
    return given > 0 ? std::min(given, 0.3 * of_forces)
                     : std::max(0.1 * of_forces, std::min(1e-10, 0.3 * of_forces));
  }

  template <int dim>
  bool
  EliminatedStep<dim>::looks_ahead(const Iterate<dim> &now) const
  {
    return any_friction && problem.penalty == nullptr && now.free_modes.empty() && !looked_in_vain &&
           kept.solver->is_direct(problem.discretization.dof_handler.n_dofs());
  }

  // Of the system as it stands, with the constraints of `at`.
  template <int dim>
  ContactCompliance<dim>
  EliminatedStep<dim>::compliance(const Iterate<dim> &at, const BaseSolution<dim> &from) const
  {
    return {problem.discretization,
            problem.mechanics.bodies(),
            problem.supports,
            *at.constraints,
            at.first_equation,
            from,
            kept.system->matrix(),
            *kept.solver};
  }

  template <int dim>
  BaseSolution<dim>
  EliminatedStep<dim>::base_solution(const std::vector<ContactStatus> &states,
                                     const std::vector<SlipLaw<dim>>  &laws,
                                     const Iterate<dim>               &at) const
  {
    return {problem.contact.nodes(), states, laws, at.answers, movable, at.u};
  }

  // From the base, whose responses serve as long as its matrix does.
  template <int dim>
  ActiveSetLookahead<dim>
  EliminatedStep<dim>::condensed(const BaseSolution<dim> &from)
  {
    const auto respond = [this, &from, solver = std::shared_ptr<ContactCompliance<dim>>()](
                             const std::vector<ContactInput> &inputs) mutable {
      if (solver == nullptr) // takes a while
        solver = std::make_shared<ContactCompliance<dim>>(compliance(*base, from));
      return solver->respond(inputs);
    };
    return {from,
            respond,
            most_responses<dim>(
                kept.responses.size(), from.nodes.size(), problem.discretization.dof_handler.n_dofs()),
            kept.responses};
  }

  // Where this ends where it began, rounding speaks differently here and there: systems of the bodies decide
  // from now on.
  template <int dim>
  unsigned int
  EliminatedStep<dim>::look_ahead(Iterate<dim>                     &now,
                                  const std::vector<ContactStatus> &before,
                                  const double                      rounding)
  {
    if (dim == 3 || !looks_ahead(now)) // laws follow the slip: sets alone say little
      return pivot(now, before);
    TimerOutput::Scope scope(problem.timer, "condensed contact");
    if (!by_base)
      {
        base.emplace(now);
        for (unsigned int k = 0; k < before.size(); ++k)
          base->states.impose(k, before[k], now.laws[k]);
      }
    const auto from = base_solution(base->states.all(), base->laws, *base);
    auto       only = condensed(from);
    looked_in_vain  = !only.lead(now.states, before, now.laws, rounding, problem.parameters.max_iterations);
    if (looked_in_vain)
      now.states.update(now.answers, rounding);
    return only.n_asked();
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
    base.reset();
    by_base = false;
    kept.assemble(problem, open, springs, {});
    kept.solver->values_changed();
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
        kept.solver->solve(
            kept.system->matrix(), v, push, 0.1 * push.l2_norm()); // Ritz values are right in any space
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
        !kept.solver->is_direct(problem.discretization.dof_handler.n_dofs()))
      return false;
    TimerOutput::Scope scope(problem.timer, "condensed contact");
    now.states.forget(); // bounds follow pressures again
    const auto open      = with_open_nodes(now, springs);
    const auto from      = base_solution(open.states.all(), open.laws, open);
    const auto responses = compliance(open, from);
    const auto found     = solve_condensed_friction<dim>(
        from,
        [&](const std::vector<ContactInput> &inputs) { return responses.respond(inputs); },
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
        n_pivoted == n_most_times || !kept.solver->is_direct(problem.discretization.dof_handler.n_dofs()))
      return 0;
    TimerOutput::Scope scope(problem.timer, "condensed contact");
    ++n_pivoted;
    unsigned int n_responses = 0;
    const auto   from        = base_solution(before, now.laws, now);
    const auto   responses   = compliance(now, from);
    const auto   found       = solve_condensed_contact<dim>(
        from,
        [&](const std::vector<ContactInput> &inputs) {
          n_responses += inputs.size();
          return responses.respond(inputs);
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

#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/solver/contact_responses.h>
#include <amontons/solver/diagnosis.h>
#include <amontons/solver/proximal_terms.h>
#include <amontons/solver/semismooth_newton.h>
#include <amontons/solver/nodal_tractions.h>

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

  namespace
  {
    // A response costs a tenth to a twentieth of a factorisation, in small systems less than their assembly.
    unsigned int
    most_responses(const types::global_dof_index n_dofs)
    {
      return std::max<types::global_dof_index>(100, 400000 / n_dofs);
    }

    // One solve on one mesh: everything that lives as long as its iteration.
    template <int dim>
    class Iteration
    {
    public:
      Iteration(const NewtonParameters                   &parameters,
                const LinearSolverParameters             &solver_parameters,
                const Discretization<dim>                &discretization,
                const ElasticityOperator<dim>            &elasticity,
                const std::vector<ContactInterface<dim>> &interfaces,
                const Constraints                        &supports,
                const LA::Vector                         &loads,
                SolutionState<dim>                       &state,
                TimerOutput                              &timer)
          : parameters(parameters), solver_parameters(solver_parameters), discretization(discretization),
            elasticity(elasticity), interfaces(interfaces), supports(supports), loads(loads), state(state),
            timer(timer), communicator(discretization.geometry.communicator),
            nodes(collect_contact_nodes(discretization, interfaces, parameters.scaling)),
            any_friction(std::any_of(nodes.begin(), nodes.end(), [](const auto &n) { return n.frictional; })),
            floating(discretization, supports, interfaces), states(nodes, interfaces, floating, state.t),
            system(discretization.locally_owned, discretization.relevant, communicator),
            solver(solver_parameters, dim, !any_friction), answers(nodes.size()), origins(nodes.size())
      {
        u.reinit(discretization.locally_owned, communicator);
        du.reinit(discretization.locally_owned, communicator);
      }

      NewtonReport
      run(const typename SemismoothNewton<dim>::Observer &observer)
      {
        prepare();
        bool set_changed = true;
        //! [small strain]
        while (report.iterations.size() < parameters.max_iterations)
          {
            NewtonReport::Iteration step{};
            if (set_changed || any_friction)
              constrain_closed_nodes();
            if (!solve_increment(step))
              break;
            recover_contact(step);
            set_changed   = update_states(step);
            step.residual = relative_residual();
            report.iterations.push_back(step);
            observer(step);
            stop_or_go_on(step, set_changed);
            if (!report.goes_on())
              break;
            choose_forcing(step, set_changed);
            //! [small strain]
          }
        finish();
        return report;
      }

    private:
      void
      stop_or_go_on(const NewtonReport::Iteration &step, const bool set_changed)
      {
        if (!std::isfinite(step.residual))
          report.failure = Failure{Failure::Kind::not_a_number};
        else if (!set_changed && step.residual <= parameters.tolerance && states.held_too_much() == 0)
          report.converged = true;
        else if (!set_changed && states.held_too_much() > 0)
          report.failure = Diagnosis::friction_exceeded(states);
        else if (!set_changed && moves_apart())
          {
            report.failure         = Failure{Failure::Kind::moves_apart};
            report.failure->motion = states.describe(free_modes);
          }
        if (report.iterations.size() == 1 && report.goes_on())
          report.failure = Diagnosis::friction_beyond_limit(states);
      }

      // Motions without supports, the first guess of the closed nodes, the pattern and the bulk of the
      // matrix.
      void
      prepare()
      {
        std::vector<const LinearEquation *> all;
        for (const auto &node : nodes)
          for (const auto *e : node.holding())
            all.push_back(&e->equation);
        floating.set_loads(loads);
        report.note = floating.check_loads(all);
        floating.choose_pins(all);

        u = state.displacement;
        distribute(supports, u, state.displacement);
        if (state.committed.size() == state.displacement.size())
          for (unsigned int k = 0; k < nodes.size(); ++k)
            if (nodes[k].frictional)
              origins[k] = nodes[k].jump(state.committed);
        states.start(state, first_guess_of_closed_nodes(nodes, interfaces, floating, state.displacement));
        proximal = make_proximal_terms(discretization, elasticity, floating);
        const bool may_change =
            std::any_of(nodes.begin(), nodes.end(), [](const auto &node) { return !node.tied; });
        forcing = may_change ? 1e-4 : fine_forcing();
        if (!solver.is_direct(discretization.dof_handler.n_dofs()))
          solver.set_near_null_space(rigid_body_modes(discretization));

        TimerOutput::Scope           scope(timer, "sparsity and bulk matrix");
        std::vector<ContactEquation> candidates;
        for (const auto &node : nodes)
          for (const auto *equation : node.holding())
            {
              candidates.push_back(*equation);
              substitute(candidates.back().equation, supports);
            }
        if (any_friction) // slip mixes the components of a node
          for (const auto &node : nodes)
            if (node.frictional)
              {
                candidates.push_back(all_components(node));
                substitute(candidates.back().equation, supports);
              }
        system.setup(
            elasticity.tangent(), supports, candidates, floating.any() ? &proximal.springs : nullptr);
      }

      void
      constrain_closed_nodes()
      {
        TimerOutput::Scope           scope(timer, "assemble condensed system");
        std::vector<ContactEquation> active;
        first_equation.assign(nodes.size(), numbers::invalid_unsigned_int);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (states[k] != ContactState::open)
            {
              first_equation[k] = active.size();
              for (const auto &equation : states.equations(k, origins[k]))
                active.push_back(equation);
            }
        constraints = std::make_unique<ContactConstraints>(supports, active);
        free_modes  = states.unheld();
        laws.clear();
        for (unsigned int k = 0; k < nodes.size(); ++k)
          laws.push_back(states.law(k));
        system.assemble(elasticity.tangent(),
                        *constraints,
                        !free_modes.empty()        ? &proximal.springs
                        : !floating.pins().empty() ? &proximal.pins
                                                   : nullptr,
                        stiffness_across_slip());
        solver.matrix_changed(report.iterations.empty() ? LinearSolver::all_rows
                                                        : report.iterations.back().n_changes);
      }

      bool
      slips_with_friction(const unsigned int k) const
      {
        return nodes[k].frictional && states[k] == ContactState::slip;
      }

      std::vector<LocalMatrix>
      stiffness_across_slip() const
      {
        std::vector<LocalMatrix> matrices;
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (slips_with_friction(k) && laws[k].stiffness > 0 &&
              discretization.locally_owned.is_element(nodes[k].components[0].candidates[0]))
            matrices.push_back(slip_stiffness(nodes[k], laws[k]));
        return matrices;
      }

      LA::Vector
      known_shear_forces()
      {
        LA::Vector forces;
        forces.reinit(loads);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (slips_with_friction(k))
            add_known_shear_forces(nodes[k], laws[k], slip(k), discretization.locally_owned, forces);
        forces.compress(VectorOperation::add);
        return forces;
      }

      Tensor<1, dim>
      slip(const unsigned int k) const
      {
        return nodes[k].tangential(nodes[k].jump(state.displacement) - origins[k]);
      }

      // Moves on to the constraints, then solves for the homogeneous increment.
      bool
      solve_increment(NewtonReport::Iteration &step)
      {
        distribute(constraints->trial(), u, state.displacement);
        LA::Vector residual = loads;
        residual -= elasticity.internal_forces(state.displacement);
        if (any_friction)
          residual += known_shear_forces();
        LA::Vector rhs(discretization.locally_owned, communicator);
        rhs = condense(residual, constraints->test(), loads);
        zero_constrained(constraints->test(), discretization.locally_owned, rhs);

        TimerOutput::Scope scope(timer, "linear solve");
        const double       scale  = report.iterations.empty() ? rhs.l2_norm() : force_scale;
        const auto         result = solver.solve(system.matrix(), du, rhs, forcing * scale);
        step.krylov               = result.iterations;
        if (!result.success)
          {
            report.failure = Failure{Failure::Kind::linear_solver, result.iterations};
            return false;
          }
        if (report.iterations.empty())
          {
            report.one_linear_solve_seconds = clock.wall_time();
            report.start_residual           = rhs.l2_norm();
          }
        u += du;
        distribute(constraints->trial(), u, state.displacement);
        return true;
      }

      // Contact forces from the unconstrained residual; gaps of the open nodes.
      void
      recover_contact(NewtonReport::Iteration &step)
      {
        internal = elasticity.internal_forces(state.displacement);
        raw      = internal;
        raw -= loads;
        if (any_friction)
          raw -= known_shear_forces();
        multipliers = multipliers_of(raw, supports, *constraints);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            answers[k] = answer(k);
            (states[k] == ContactState::open    ? step.n_open
             : states[k] == ContactState::stick ? step.n_stick
                                                : step.n_slip) += 1;
          }
      }

      NodalContact<dim>
      answer(const unsigned int k) const
      {
        const CandidateNode<dim> &node = nodes[k];
        const auto gap = [&]() { return node.gap - evaluate(node.closing.equation, state.displacement); };
        if (states[k] == ContactState::open)
          {
            NodalContact<dim> result;
            result.gap = gap();
            if (node.frictional)
              result.slip = slip(k);
            return result;
          }
        const unsigned int e           = first_equation[k];
        const bool         has_a_pivot = constraints->pivots()[e].has_value();
        return answer_of_closed(node,
                                states[k],
                                laws[k],
                                node.frictional ? slip(k) : Tensor<1, dim>(),
                                has_a_pivot ? 0. : gap(),
                                has_a_pivot,
                                &multipliers[e]);
      }

      // What rounding leaves of |K||u| counts as zero: scenes without stress, stiff bodies on soft ones.
      double
      relative_residual()
      {
        LA::Vector free = condense(raw, constraints->test(), loads);
        zero_constrained(constraints->test(), discretization.locally_owned, free);
        const double rounding = 1e-14 * elasticity.rounding_scale(state.displacement);
        force_scale = std::max({internal.l2_norm(), loads.l2_norm(), rounding / parameters.tolerance});
        return force_scale == 0 ? 0 : std::hypot(free.l2_norm(), states.law_error(answers)) / force_scale;
      }

      bool
      update_states(NewtonReport::Iteration &step)
      {
        const double rounding = rounding_of_pressures(nodes, u.linfty_norm());
        const auto   before   = states.all();
        step.n_changes        = states.update(answers, rounding);
        if (step.n_changes > 0 && looks_ahead())
          {
            step.krylov += look_ahead({nodes, before, laws, answers, movable_nodes(), u}, rounding);
            step.n_changes = std::max(1u, n_changes_since(before));
          }
        report.safeguarded = report.safeguarded || states.safeguarded();
        report.frozen      = report.frozen || states.frozen();
        return step.n_changes > 0 || states.frozen();
      }

      std::vector<bool>
      movable_nodes() const
      {
        std::vector<bool> result;
        for (const auto &node : nodes)
          result.push_back(
              std::none_of(node.components.begin(), node.components.end(), [&](const auto &component) {
                return !component.candidates.empty() && supports.is_constrained(component.candidates[0]);
              }));
        return result;
      }

      bool
      looks_ahead() const
      {
        return dim == 2 && any_friction && free_modes.empty() && !looked_in_vain &&
               solver.is_direct(discretization.dof_handler.n_dofs());
      }

      unsigned int
      n_changes_since(const std::vector<ContactState> &old) const
      {
        unsigned int n = 0;
        for (unsigned int k = 0; k < nodes.size(); ++k)
          n += states[k] != old[k];
        return n;
      }

      // The states change further, as long as the contact nodes alone can tell, before the next system of the
      // bodies is solved. Where this ends where it began, rounding speaks differently here and there: systems
      // of the bodies decide from now on. Returns the number of systems solved for responses.
      unsigned int
      look_ahead(const BaseSolution<dim> &base, const double rounding)
      {
        TimerOutput::Scope          scope(timer, "condensed contact");
        const ContactResponses<dim> responses(discretization,
                                              elasticity,
                                              supports,
                                              *constraints,
                                              first_equation,
                                              base,
                                              system.matrix(),
                                              solver);
        CondensedContact<dim>       condensed(
            base,
            [&](const unsigned int k, const NodeInput input) { return responses.respond(k, input); },
            most_responses(discretization.dof_handler.n_dofs()));
        bool goes_on = true;
        for (unsigned int n = 0; n < parameters.max_iterations && goes_on && states.unheld().empty(); ++n)
          {
            const auto next = condensed.answers(states);
            goes_on         = next && (states.update(*next, rounding) > 0 || states.frozen());
          }
        looked_in_vain = condensed.is_base(states);
        if (looked_in_vain)
          states.update(answers, rounding);
        return condensed.n_responses();
      }

      // Weak springs are all that holds a motion, and they are not coming to rest.
      bool
      moves_apart() const
      {
        const unsigned int n = report.iterations.size();
        return n > 1 && !free_modes.empty() &&
               report.iterations[n - 1].residual > 0.5 * report.iterations[n - 2].residual;
      }

      // While many nodes still change, systems are solved as far as that is worth; the last ones for good.
      // Where only weak springs hold a motion, even a small residual may be a large motion. With friction in
      // 3D the directions of slip change after the set: as far as superlinear convergence needs.
      void
      choose_forcing(const NewtonReport::Iteration &step, const bool set_changed)
      {
        const bool rough =
            set_changed && step.n_changes > 0.05 * (step.n_slip + step.n_stick) && free_modes.empty();
        forcing = rough ? 1e-3 : fine_forcing();
        if (dim == 3 && any_friction && free_modes.empty())
          forcing = std::min(1e-3, std::max(fine_forcing(), 0.03 * std::pow(step.residual, 1.5)));
      }

      double
      fine_forcing() const
      {
        return std::min(solver_parameters.tolerance, 0.3 * parameters.tolerance);
      }

      // The result by interface and row.
      void
      finish()
      {
        report.start_residual = force_scale > 0 ? report.start_residual / force_scale : 0;
        if (report.iterations.empty() || !std::isfinite(report.iterations.back().residual))
          state.displacement = discretization.make_relevant_vector();
        state.contact = states.by_slave_node(answers);
        if (report.goes_on())
          report.failure = Diagnosis::no_states_found(report, states, any_friction);
      }

      const NewtonParameters                   &parameters;
      const LinearSolverParameters             &solver_parameters;
      const Discretization<dim>                &discretization;
      const ElasticityOperator<dim>            &elasticity;
      const std::vector<ContactInterface<dim>> &interfaces;
      const Constraints                        &supports;
      const LA::Vector                         &loads;
      SolutionState<dim>                       &state;
      TimerOutput                              &timer;
      const MPI_Comm                            communicator;

      Timer                                 clock;
      const std::vector<CandidateNode<dim>> nodes;
      const bool                            any_friction;
      FloatingBodies<dim>                   floating;
      NodeStates<dim>                       states;
      CondensedSystem                       system;
      LinearSolver                solver; // its factorisation refers to the matrix, which must outlive it
      NewtonReport                report;
      ProximalTerms               proximal;
      LA::Vector                  u, du, internal, raw;
      NodalContacts<dim>          answers;
      std::vector<Tensor<1, dim>> origins; // jumps that the increment started from
      std::vector<SlipLaw<dim>>   laws;    // that the last system was made with
      std::vector<double>         multipliers;
      std::unique_ptr<ContactConstraints> constraints;
      bool                                looked_in_vain = false;
      std::vector<unsigned int>           first_equation;  // of node k among those of the closed nodes
      std::vector<std::vector<double>>    free_modes;      // rigid motions that the closed nodes leave
      double                              forcing     = 0; // residual of the next linear solve / force_scale
      double                              force_scale = 0; // norm of the internal forces or loads
    };
  } // namespace

  template <int dim>
  NewtonReport
  SemismoothNewton<dim>::solve(const ElasticityOperator<dim>            &elasticity,
                               const std::vector<ContactInterface<dim>> &interfaces,
                               const Constraints                        &supports,
                               const LA::Vector                         &loads,
                               SolutionState<dim>                       &state,
                               const Observer                           &observer)
  {
    TimerOutput::Scope scope(timer, "contact iteration");
    return Iteration<dim>(parameters,
                          solver_parameters,
                          discretization,
                          elasticity,
                          interfaces,
                          supports,
                          loads,
                          state,
                          timer)
        .run(observer);
  }

  template class SemismoothNewton<2>;
  template class SemismoothNewton<3>;
} // namespace Amontons

#include <amontons/algebra/rigid_body_modes.h>
#include <amontons/solver/contact_responses.h>
#include <amontons/solver/damped_motion.h>
#include <amontons/solver/diagnosis.h>
#include <amontons/solver/finite_newton.h>
#include <amontons/solver/proximal_terms.h>
#include <amontons/solver/stability.h>
#include <amontons/solver/nodal_tractions.h>
#include <amontons/solver/tangent_reuse.h>

#include <deal.II/grid/grid_tools.h>

namespace Amontons
{
  template <int dim>
  FiniteNewton<dim>::FiniteNewton(const NewtonParameters       &parameters,
                                  const LinearSolverParameters &solver_parameters,
                                  const Discretization<dim>    &discretization,
                                  TimerOutput                  &timer)
      : parameters(parameters), solver_parameters(solver_parameters), discretization(discretization),
        timer(timer)
  {
  }

  namespace
  {
    Constraints
    without_values(const Constraints &constraints)
    {
      Constraints result(constraints);
      for (const auto &line : constraints.get_lines())
        result.set_inhomogeneity(line.index, 0);
      return result;
    }

    template <int dim>
    class FiniteIteration
    {
    public:
      FiniteIteration(const NewtonParameters             &parameters,
                      const LinearSolverParameters       &solver_parameters,
                      const Discretization<dim>          &discretization,
                      FiniteMechanics<dim>               &mechanics,
                      std::vector<ContactInterface<dim>> &interfaces,
                      const Constraints                  &prescribed,
                      SolutionState<dim>                 &state,
                      TimerOutput                        &timer)
          : parameters(parameters), solver_parameters(solver_parameters), discretization(discretization),
            mechanics(mechanics), elasticity(mechanics.bodies()), interfaces(interfaces),
            prescribed(prescribed), supports(without_values(prescribed)), state(state), timer(timer),
            communicator(discretization.geometry.communicator),
            contact(discretization, supports, interfaces, state, parameters.scaling),
            floating(discretization, supports, interfaces, &state.displacement),
            states(contact.nodes(), interfaces, floating, state.t),
            system(discretization.locally_owned, discretization.relevant, dim, communicator),
            solver(solver_parameters, dim, false), answers(contact.nodes().size()),
            smallest_cell(GridTools::minimal_cell_diameter(discretization.geometry.triangulation)),
            tangent(smallest_cell)
      {
        u.reinit(discretization.locally_owned, communicator);
        du.reinit(discretization.locally_owned, communicator);
        u            = state.displacement;
        any_friction = std::any_of(
            contact.nodes().begin(), contact.nodes().end(), [](const auto &node) { return node.frictional; });
      }

      // damped: the motion that the change of loads and supports sets off is followed until it rests.
      NewtonReport
      run(const bool damped, const typename SemismoothNewton<dim>::Observer &observer)
      {
        if (!prepare())
          return report;
        const LA::Vector start(u);
        const auto       first_answers = answers;
        if (damped)
          follow_motion(1, observer);
        else
          iterate(observer);
        for (unsigned int n = 0; n < 4 && report.converged; ++n)
          {
            const auto mode = unstable_mode();
            if (!mode)
              break;
            report.unstable = true;
            if (report.moved)
              leave_along(*mode, observer);
            else
              {
                put(start);
                guess_states();
                answers = first_answers;
                follow_motion(1, observer);
              }
          }
        finish();
        return report;
      }

    private:
      void
      iterate(const typename SemismoothNewton<dim>::Observer &observer)
      {
        while (report.iterations.size() < parameters.max_iterations)
          {
            NewtonReport::Iteration step{};
            LA::Vector              change;
            linearise();
            if (!solve_step(step, change) || !advance(change))
              return;
            look_at_states(step);
            observer(step);
            stop_or_go_on(step);
            if (report.goes_on() && stagnates())
              report.failure = Diagnosis::no_states_found(report, states, any_friction);
            if (!report.goes_on())
              return;
          }
      }

      void
      look_at_states(NewtonReport::Iteration &step)
      {
        recover_contact();
        count_states(step);
        step.residual = relative_residual();
        if (!motion && !report.iterations.empty())
          tangent.measure(u, step.residual * force_scale);
        step.n_changes = update_states(step.residual);
        report.iterations.push_back(step);
      }

      // A shorter increment helps more than further iterations, unless bounds of friction were held: they
      // settle slowly, but they do.
      bool
      stagnates() const
      {
        const unsigned int n = report.iterations.size(), last = 12;
        if (n < 25 || report.frozen)
          return false;
        const auto   smaller = [](const auto &a, const auto &b) { return a.residual < b.residual; };
        const auto   middle  = report.iterations.end() - last;
        const double before  = std::min_element(report.iterations.begin(), middle, smaller)->residual,
                     now     = std::min_element(middle, report.iterations.end(), smaller)->residual;
        return now > 0.3 * before;
      }

      // D du/dtau + internal - contact forces = loads from here on, until nothing moves.
      void
      follow_motion(const double first_step, const typename SemismoothNewton<dim>::Observer &observer)
      {
        constexpr unsigned int max_iterations = 300;
        const unsigned int     first          = report.iterations.size();
        report.converged                      = false;
        report.moved                          = true;
        damping                               = lumped_damping(discretization);
        motion                                = DampedMotion{DampedSteps(first_step), {}, {}};
        double     residual                   = 0;
        const auto no_balance_here            = Diagnosis::friction_beyond_limit(states);
        while (report.goes_on())
          {
            if (report.iterations.size() > first + max_iterations)
              report.failure = Failure{Failure::Kind::still_moving, max_iterations, residual};
            else if (const LA::Vector start(u); move_on(start, observer))
              {
                const auto &last = report.iterations.back();
                stop_or_go_on(last);
                motion->steps.accept(residual / last.residual);
                residual = last.residual;
              }
            else
              go_back(start);
          }
        motion.reset();
        if (!report.converged && no_balance_here) // it may move to where there is one
          report.failure = no_balance_here;
      }

      // One step of implicit Euler,  D (u - start)/dtau + internal - contact forces = loads, with the states
      // of its end; false: it is too long.
      bool
      move_on(const LA::Vector &start, const typename SemismoothNewton<dim>::Observer &observer)
      {
        const unsigned int max_iterations = 8;
        motion->force                     = discretization.make_owned_vector();
        states.forget();
        for (unsigned int n = 0; n < max_iterations; ++n)
          {
            NewtonReport::Iteration step{};
            LA::Vector              change;
            linearise();
            if (!solve_step(step, change) || (n == 0 && !motion->is_downhill) || !advance(change, 1))
              return false;
            motion->force = u;
            motion->force -= start;
            if (motion->force.linfty_norm() > 0.1 * damping.length)
              return false;
            motion->force.scale(damping.values);
            motion->force /= motion->steps.size();
            look_at_states(step);
            observer(step);
            if (!std::isfinite(step.residual))
              return false;
            if (step.n_changes == 0 && motion->error <= std::max(0.1 * step.residual, parameters.tolerance) &&
                largest_violation() <= 1e-4)
              return true;
          }
        return false;
      }

      void
      go_back(const LA::Vector &start)
      {
        report.failure.reset();
        if (!put(start) || !motion->steps.reject())
          {
            report.failure = Failure{Failure::Kind::motion_lost};
            if (inversion)
              report.failure->cell = inversion->cell;
          }
      }

      // With nodes that slip and rub, motion backwards meets another stiffness: not looked at.
      std::optional<UnstableMode>
      unstable_mode()
      {
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (contact.nodes()[k].frictional && states[k] == ContactState::slip)
            return {};
        if (!free_modes.empty() || is_iterative())
          return {};
        TimerOutput::Scope scope(timer, "stability");
        damping = lumped_damping(discretization);
        if (report.moved)
          {
            linearise();
            LA::Vector              change;
            NewtonReport::Iteration step{};
            if (!solve_step(step, change)) // factorises
              return {};
          }
        return find_unstable_mode(
            [&](LA::Vector &y, const LA::Vector &x) {
              LA::Vector force(x);
              force.scale(damping.values);
              LA::Vector rhs = condense(force, assembled->test(), mechanics.loads());
              zero_constrained(assembled->test(), discretization.locally_owned, rhs);
              const auto result = solver.solve(system.matrix(), y, rhs, 0.); // by its factors
              supports.distribute(y);
              return result.success;
            },
            damping.values);
      }

      // From an unstable equilibrium that the motion itself led to: the way that the increment pushes, if
      // any.
      void
      leave_along(const UnstableMode &mode, const typename SemismoothNewton<dim>::Observer &observer)
      {
        LA::Vector kick(mode.shape);
        kick *= (first_push * kick < 0 ? -1e-3 : 1e-3) * damping.length;
        if (advance(kick))
          follow_motion(0.5 / mode.rate, observer);
        else
          report.converged = false;
      }

      bool
      prepare()
      {
        contact.move(state.displacement);
        {
          TimerOutput::Scope scope(timer, "assemble stiffness");
          if (const auto inverted = mechanics.start(state.displacement))
            {
              report.failure = Diagnosis::inverted(discretization, *inverted);
              return false;
            }
        }
        std::vector<const LinearEquation *> equations;
        for (const auto &node : contact.nodes())
          for (const auto *e : node.holding())
            equations.push_back(&e->equation);
        floating.set_loads(mechanics.loads());
        report.note = floating.check_loads(equations);
        floating.choose_pins(equations);
        guess_states();
        take_tractions();
        proximal = make_proximal_terms(discretization, elasticity, floating);
        if (is_iterative())
          solver.set_near_null_space(rigid_body_modes(discretization));
        return true;
      }

      void
      guess_states()
      {
        for (unsigned int k = 0; k < answers.size(); ++k)
          states.open(k);
        states.start(state, touching_nodes());
        open_lonely_nodes();
      }

      void
      open_lonely_nodes()
      {
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (states[k] != ContactState::open && !contact.is_opposite(k))
            states.open(k);
      }

      // Bodies and surfaces where they were before.
      bool
      put(const LA::Vector &where)
      {
        u                  = where;
        state.displacement = u;
        if (!evaluate())
          return false;
        contact.move(state.displacement);
        open_lonely_nodes();
        return true;
      }

      // The tractions that the state knows, for the first tangent.
      void
      take_tractions()
      {
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (const auto *known = state.contact_of(contact.nodes()[k].interface, contact.nodes()[k].node);
              known != nullptr && states[k] != ContactState::open)
            {
              answers[k].pressure = known->pressure;
              answers[k].shear    = known->shear;
            }
      }

      std::vector<bool>
      touching_nodes() const
      {
        const auto rest = discretization.make_relevant_vector();
        return first_guess_of_closed_nodes(contact.nodes(), interfaces, floating, rest);
      }

      // At state.displacement; dilatations: empty for those of the displacement.
      bool
      evaluate(const std::vector<double> &dilatations = {}, const bool with_stiffness = true)
      {
        TimerOutput::Scope scope(timer, "assemble stiffness");
        const auto         inverted = mechanics.evaluate(state.displacement, dilatations, with_stiffness);
        if (inverted)
          inversion = Diagnosis::inverted(discretization, *inverted);
        return !inverted;
      }

      ContactConstraints
      constraints_of(const NodeStates<dim> &states)
      {
        std::vector<ContactEquation> equations;
        first_equation.assign(answers.size(), numbers::invalid_unsigned_int);
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (states[k] != ContactState::open)
            {
              first_equation[k] = equations.size();
              for (auto &equation : states.equations(k, Tensor<1, dim>()))
                {
                  equation.equation.value = 0;
                  equations.push_back(equation);
                }
            }
        return ContactConstraints(supports, equations);
      }

      bool
      is_iterative() const
      {
        return !solver.is_direct(discretization.dof_handler.n_dofs());
      }

      void
      linearise()
      {
        laws.clear();
        for (unsigned int k = 0; k < answers.size(); ++k)
          laws.push_back(states.law(k));
        constraints = std::make_shared<ContactConstraints>(constraints_of(states));
        free_modes  = states.unheld();
        if (system_serves_again())
          {
            update_rows();
            return;
          }
        if (!tangent_serves_again())
          differentiate();
        further = contact.stiffness(states, answers, state.displacement);
        for (auto &matrix : mechanics.stiffness_of_loads(state.displacement))
          further.push_back(std::move(matrix));
        write_rows();
        TimerOutput::Scope scope(timer, "assemble condensed system");
        if (system.link(supports, *constraints, further, rows))
          solver.matrix_changed(LinearSolver::all_rows); // lets go of the matrix
        else
          solver.values_changed();
        const LA::Vector *added = springs();
        LA::Vector        sum;
        if (motion)
          {
            sum = damping.values;
            sum /= motion->steps.size();
            if (added != nullptr)
              sum += *added;
            added = &sum;
          }
        system.assemble(elasticity.tangent(), supports, *constraints, further, added, rows, is_iterative());
        assembled     = constraints;
        damped_system = motion.has_value();
      }

      // Bodies and contact. The pattern of the system knows from the beginning what nodes beside closed ones
      // link: they may close soon.
      void
      differentiate()
      {
        {
          TimerOutput::Scope scope(timer, "assemble stiffness");
          mechanics.complete(state.displacement);
        }
        tangent.made_at(u);
        TimerOutput::Scope scope(timer, "differentiate contact");
        const bool         is_first = report.iterations.empty();
        NodeStates<dim>    more(states);
        if (is_first)
          for (const unsigned int k : contact.neighbours(states))
            more.close(k);
        contact.differentiate(more);
        if (is_first)
          {
            system.link(supports, constraints_of(more), contact.links(), {});
            constraints = std::make_shared<ContactConstraints>(constraints_of(states));
          }
      }

      void
      write_rows()
      {
        rows.clear();
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (states[k] != ContactState::open)
            for (auto &row : contact.written_rows(k, states[k], pivots_of(k), state.displacement))
              rows.push_back(row);
      }

      std::vector<std::optional<types::global_dof_index>>
      pivots_of(const unsigned int k) const
      {
        const auto first = constraints->pivots().begin() + first_equation[k];
        return {first, first + (states[k] == ContactState::stick ? dim : 1)};
      }

      // Where this is enough for the tolerance, the system stays as it is.
      bool
      system_serves_again() const
      {
        return !report.iterations.empty() && report.iterations.back().n_changes == 0 && !motion &&
               !damped_system && free_modes.empty() && constraints->pivots() == assembled->pivots() &&
               tangent.expected_contraction(u) * report.iterations.back().residual <
                   0.5 * parameters.tolerance;
      }

      // Where the set moves, residuals do not fall by more than 1e-3 anyway.
      bool
      tangent_serves_again() const
      {
        return !report.iterations.empty() && report.iterations.back().n_changes > 0 && !motion &&
               contact.is_differentiated(states) && tangent.strain_since(u) < 1e-3;
      }

      // Their values alone, for the matrix as it is.
      void
      update_rows()
      {
        auto row = rows.begin();
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (states[k] != ContactState::open)
            {
              const auto pivots = pivots_of(k);
              const auto values = contact.row_values(k, states[k], state.displacement);
              for (unsigned int c = 0; c < pivots.size(); ++c)
                if (pivots[c])
                  (row++)->equation.value = values[c];
            }
      }

      const LA::Vector *
      springs() const
      {
        return !free_modes.empty() ? &proximal.springs : !floating.pins().empty() ? &proximal.pins : nullptr;
      }

      // The change of what supports prescribe since u was made: they hold it from the first step on, and the
      // bodies follow in the linear way.
      LA::Vector
      prescribed_change() const
      {
        LA::Vector moved(u);
        prescribed.distribute(moved);
        moved -= u;
        LA::Vector result = discretization.make_relevant_vector();
        result            = moved;
        return result;
      }

      // K times it, with everything that the system holds.
      LA::Vector
      forces_of(const LA::Vector &change) const
      {
        LA::Vector forces = discretization.make_owned_vector();
        const auto add =
            [&](const FullMatrix<double> &matrix, const auto &row_dofs, const auto &column_dofs) {
              Vector<double> x(column_dofs.size()), y(row_dofs.size());
              for (unsigned int j = 0; j < column_dofs.size(); ++j)
                x[j] = change(column_dofs[j]);
              if (x.all_zero())
                return;
              matrix.vmult(y, x);
              forces.add(row_dofs, y);
            };
        for (unsigned int c = 0; c < elasticity.n_cells(); ++c)
          add(elasticity.matrix(c), elasticity.dofs(c), elasticity.dofs(c));
        for (const auto &matrix : further)
          add(matrix.matrix, matrix.rows, matrix.columns);
        forces.compress(VectorOperation::add);
        return forces;
      }

      LA::Vector
      known_shear_forces() const
      {
        LA::Vector forces = discretization.make_owned_vector();
        for (unsigned int k = 0; any_friction && k < answers.size(); ++k)
          if (contact.nodes()[k].frictional && states[k] == ContactState::slip && contact.is_opposite(k))
            add_known_shear_forces(contact.nodes()[k],
                                   laws[k],
                                   contact.slip(k, state.displacement),
                                   discretization.locally_owned,
                                   forces);
        forces.compress(VectorOperation::add);
        return forces;
      }

      // (K + D/dtau) du . du > 0: motion leaves unstable equilibria; steps that are too long would go there.
      bool
      goes_downhill(const LA::Vector &change) const
      {
        LA::Vector relevant = discretization.make_relevant_vector();
        relevant            = change;
        LA::Vector force(change);
        force.scale(damping.values);
        return forces_of(relevant) * change + force * change / motion->steps.size() > 0;
      }

      // Newton's residual goes like its square: the linear one need not be smaller, nor than what the
      // tolerance asks for.
      double
      linear_tolerance(const LA::Vector &rhs) const
      {
        if (report.iterations.empty())
          return 1e-4 * rhs.l2_norm();
        const auto  &last = report.iterations.back();
        const double r = last.residual, factor = last.n_changes > 0 ? 1e-2 : std::min(1e-3, r);
        return 0.1 * std::max(factor * r, parameters.tolerance) * force_scale;
      }

      bool
      solve_step(NewtonReport::Iteration &step, LA::Vector &full)
      {
        const LA::Vector change   = prescribed_change();
        LA::Vector       residual = known_shear_forces();
        residual -= mechanics.unbalanced();
        residual -= elasticity.forces_of_excess();
        residual -= forces_of(change);
        if (motion)
          residual -= motion->force;
        LA::Vector rhs(discretization.locally_owned, communicator);
        rhs = condense(residual, constraints->test(), mechanics.loads());
        zero_constrained(constraints->test(), discretization.locally_owned, rhs);
        const LA::Vector push(rhs);
        for (const auto &row : rows)
          if (discretization.locally_owned.is_element(row.row))
            rhs(row.row) =
                system.row_scale(row.row) * (row.equation.value - Amontons::evaluate(row.equation, change));
        rhs.compress(VectorOperation::insert);
        {
          TimerOutput::Scope scope(timer, "linear solve");
          const auto         form      = is_iterative() ? system.eliminated_form() : EliminatedForm();
          const double       tolerance = linear_tolerance(rhs);
          const auto         result =
              solver.solve(system.matrix(), du, rhs, tolerance, is_iterative() ? &form : nullptr);
          step.krylov = result.iterations;
          tangent.solved(rhs.l2_norm(), tolerance);
          if (!result.success)
            {
              report.failure = Failure{Failure::Kind::linear_solver, result.iterations};
              return false;
            }
        }
        if (report.iterations.empty())
          {
            report.one_linear_solve_seconds = clock.wall_time();
            report.start_residual           = push.l2_norm();
            first_push                      = push;
          }
        supports.distribute(du);
        if (motion)
          motion->is_downhill = goes_downhill(du);
        full = du;
        full += owned_part(change);
        return true;
      }

      LA::Vector
      owned_part(const LA::Vector &relevant) const
      {
        LA::Vector result(discretization.locally_owned, communicator);
        result = relevant;
        return result;
      }

      // u + factor step with the largest factor of 1, 1/2, ... that leaves cells as they are.
      bool
      advance(const LA::Vector &step, const unsigned int n_tries = 5)
      {
        if (!std::isfinite(step.l2_norm()))
          {
            report.failure = Failure{Failure::Kind::not_a_number};
            return false;
          }
        const LA::Vector start(u);
        LA::Vector       relevant = discretization.make_relevant_vector();
        relevant                  = step;
        const auto change         = mechanics.change_of_dilatations(relevant);
        const bool with_stiffness = motion || step.linfty_norm() > 1e-3 * smallest_cell;
        double     factor         = 1;
        for (unsigned int n = 0; n < n_tries; ++n, factor /= 2)
          {
            u = start;
            u.add(factor, step);
            state.displacement = u;
            if (evaluate(change.after(factor), with_stiffness))
              {
                TimerOutput::Scope scope(timer, "contact surfaces");
                contact.move(state.displacement);
                open_lonely_nodes();
                for (unsigned int k = 0; k < answers.size(); ++k)
                  if (states[k] == ContactState::slip && contact.nodes()[k].frictional)
                    {
                      states.turn(k);
                      laws[k] = states.law(k);
                    }
                return true;
              }
          }
        u                  = start;
        state.displacement = u;
        report.failure     = inversion;
        return false;
      }

      // Multipliers from the residual at the pivots, where the surfaces are now; gaps of the open nodes.
      void
      recover_contact()
      {
        constraints = std::make_shared<ContactConstraints>(constraints_of(states));
        balance     = mechanics.unbalanced();
        balance -= known_shear_forces();
        if (motion)
          {
            motion->balance = balance;
            motion->balance += motion->force;
          }
        const auto multipliers = multipliers_of(motion ? motion->balance : balance, supports, *constraints);
        for (unsigned int k = 0; k < answers.size(); ++k)
          answers[k] = answer(k, multipliers);
      }

      NodalContact<dim>
      answer(const unsigned int k, const std::vector<double> &multipliers) const
      {
        const CandidateNode<dim> &node = contact.nodes()[k];
        if (states[k] == ContactState::open)
          {
            NodalContact<dim> result;
            result.gap = contact.open_gap(k);
            if (node.frictional && contact.is_opposite(k)) // where its law starts if it closes
              result.slip = contact.slip(k, state.displacement);
            return result;
          }
        const unsigned int e = first_equation[k];
        return answer_of_closed(node,
                                states[k],
                                laws[k],
                                node.frictional ? contact.slip(k, state.displacement) : Tensor<1, dim>(),
                                node.gap,
                                constraints->pivots()[e].has_value(),
                                &multipliers[e]);
      }

      void
      count_states(NewtonReport::Iteration &step) const
      {
        for (unsigned int k = 0; k < answers.size(); ++k)
          if (contact.is_opposite(k))
            (states[k] == ContactState::open    ? step.n_open
             : states[k] == ContactState::stick ? step.n_stick
                                                : step.n_slip) += 1;
      }

      // Of equilibrium, relative to the forces, and of the closed nodes' equations, relative to the faces.
      // Forces of the excess that balance each other, as under uniform stress, are seen by none of the free
      // rows; but supports and closed nodes carry them.
      double
      relative_residual()
      {
        force_scale = mechanics.force_scale(state.displacement, parameters.tolerance);
        if (motion)
          motion->error = relative_residual_of(motion->balance);
        return std::max({relative_residual_of(balance),
                         largest_violation(),
                         relative(elasticity.forces_of_excess().l2_norm())});
      }

      // With the excess it is that of the displacement alone, but for the square of the excess.
      double
      relative_residual_of(const LA::Vector &forces) const
      {
        LA::Vector with_excess(forces);
        with_excess += elasticity.forces_of_excess();
        return std::max(relative_force(forces), relative_force(with_excess));
      }

      double
      relative_force(const LA::Vector &forces) const
      {
        LA::Vector free = condense(forces, constraints->test(), mechanics.loads());
        zero_constrained(constraints->test(), discretization.locally_owned, free);
        return relative(std::hypot(free.l2_norm(), states.law_error(answers)));
      }

      double
      relative(const double force) const
      {
        return force_scale == 0 ? 0 : force / force_scale;
      }

      double
      largest_violation() const
      {
        double distance = 0;
        for (unsigned int k = 0; k < answers.size(); ++k)
          distance = std::max(distance,
                              contact.violation(k, states[k], state.displacement) /
                                  interfaces[contact.nodes()[k].interface].slave->mean_size);
        return distance;
      }

      // Far from equilibrium, what would only take back the last change is not believed: near the edge of the
      // contact a node may pull when closed and penetrate when open, until the others have followed.
      bool
      waits_for_equilibrium(const double residual, const double rounding)
      {
        if (motion || residual <= 1e-3 || n_waits == 6 || previous_set.empty())
          {
            n_waits = 0;
            return false;
          }
        NodeStates<dim> next(states);
        const bool      takes_back = next.update(answers, rounding) > 0 && next.all() == previous_set;
        n_waits                    = takes_back ? n_waits + 1 : 0;
        return takes_back;
      }

      unsigned int
      update_states(const double residual)
      {
        const double rounding = rounding_of_pressures(contact.nodes(), u.linfty_norm());
        if (waits_for_equilibrium(residual, rounding))
          return 0;
        previous_set         = states.all();
        const unsigned int n = states.update(answers, rounding);
        report.safeguarded   = report.safeguarded || states.safeguarded();
        report.frozen        = report.frozen || states.frozen();
        return n;
      }

      void
      stop_or_go_on(const NewtonReport::Iteration &step)
      {
        const bool set_changed = step.n_changes > 0 || states.frozen();
        if (!std::isfinite(step.residual))
          report.failure = Failure{Failure::Kind::not_a_number};
        else if (!set_changed && step.residual <= parameters.tolerance && states.held_too_much() == 0)
          report.converged = true;
        else if (!set_changed && step.residual <= parameters.tolerance)
          report.failure = Diagnosis::friction_exceeded(states);
      }

      void
      finish()
      {
        report.start_residual = relative(report.start_residual);
        state.contact         = states.by_slave_node(answers);
        if (report.goes_on())
          report.failure = Diagnosis::no_states_found(report, states, any_friction);
      }

      const NewtonParameters             &parameters;
      const LinearSolverParameters       &solver_parameters;
      const Discretization<dim>          &discretization;
      FiniteMechanics<dim>               &mechanics;
      const ElasticityOperator<dim>      &elasticity;
      std::vector<ContactInterface<dim>> &interfaces;
      const Constraints                  &prescribed;
      const Constraints                   supports; // homogeneous
      SolutionState<dim>                 &state;
      TimerOutput                        &timer;
      const MPI_Comm                      communicator;

      Timer                               clock;
      MovingContact<dim>                  contact;
      FloatingBodies<dim>                 floating;
      NodeStates<dim>                     states;
      TangentSystem                       system;
      LinearSolver                        solver; // refers to the matrix, which must outlive it
      NewtonReport                        report;
      ProximalTerms                       proximal;
      bool                                any_friction = false;
      LA::Vector                          u, du, balance;
      NodalContacts<dim>                  answers;
      std::vector<SlipLaw<dim>>           laws;
      std::vector<LocalMatrix>            further;
      std::vector<WrittenRow>             rows;
      std::shared_ptr<ContactConstraints> constraints, assembled; // now; of the matrix
      bool                                damped_system = false;
      std::vector<unsigned int>           first_equation; // by node, in the constraints made last
      std::vector<std::vector<double>>    free_modes;     // rigid motions that the closed nodes leave
      std::optional<Failure>              inversion;      // the last one
      std::vector<ContactState>           previous_set;   // before the last change of states
      unsigned int                        n_waits     = 0;
      double                              force_scale = 0;
      const double                        smallest_cell;
      TangentReuse                        tangent;
      Damping                             damping;
      std::optional<DampedMotion>         motion;
      LA::Vector                          first_push;
    };
  } // namespace

  template <int dim>
  NewtonReport
  FiniteNewton<dim>::solve(FiniteMechanics<dim>                           &mechanics,
                           std::vector<ContactInterface<dim>>             &interfaces,
                           const Constraints                              &supports,
                           SolutionState<dim>                             &state,
                           const typename SemismoothNewton<dim>::Observer &observer,
                           const bool                                      damped)
  {
    TimerOutput::Scope scope(timer, "contact iteration");
    return FiniteIteration<dim>(
               parameters, solver_parameters, discretization, mechanics, interfaces, supports, state, timer)
        .run(damped, observer);
  }

  template class FiniteNewton<2>;
  template class FiniteNewton<3>;
} // namespace Amontons

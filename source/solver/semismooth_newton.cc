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

  namespace
  {
    // The DoFs that constraints own have no equation of their own.
    void
    zero_constrained(const Constraints &constraints, const IndexSet &owned, LA::Vector &vector)
    {
      for (const auto dof : owned)
        if (constraints.is_constrained(dof))
          vector(dof) = 0;
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
                SolutionState                            &state,
                TimerOutput                              &timer)
          : parameters(parameters), solver_parameters(solver_parameters), discretization(discretization),
            elasticity(elasticity), interfaces(interfaces), supports(supports), loads(loads), state(state),
            timer(timer), communicator(discretization.geometry.communicator),
            nodes(collect_contact_nodes(discretization, interfaces, parameters.scaling)),
            floating(discretization, supports, interfaces),
            system(discretization.locally_owned, discretization.relevant, communicator),
            solver(solver_parameters, dim), pressure(nodes.size(), 0.), gap(nodes.size(), 0.)
      {
        u.reinit(discretization.locally_owned, communicator);
        du.reinit(discretization.locally_owned, communicator);
      }

      NewtonReport
      run(const typename SemismoothNewton<dim>::Observer &observer)
      {
        prepare();
        bool set_changed = true;
        while (report.iterations.size() < parameters.max_iterations)
          {
            NewtonReport::Iteration step{};
            if (set_changed)
              constrain_closed_nodes();
            if (!solve_increment(step))
              break;
            recover_contact(step);
            step.residual = relative_residual();
            set_changed   = update_set(step);
            report.iterations.push_back(step);
            observer(step);
            if (!std::isfinite(step.residual))
              report.message =
                  "the solution is not a number: a load or prescribed displacement may not be one, "
                  "or the stiffness is singular";
            else if (!set_changed && step.residual <= parameters.tolerance)
              report.converged = true;
            else if (!set_changed && moves_apart())
              report.message =
                  "the loads drive the rigid " + unheld +
                  ", and no node that is closed holds it: the bodies move apart or slide off each "
                  "other; reverse the load, move the bodies together, or hold this motion by a support";
            if (report.converged || !report.message.empty())
              break;
            choose_forcing(step, set_changed);
          }
        finish();
        return report;
      }

    private:
      // Motions without supports, the first guess of the closed nodes, the pattern and the bulk of the
      // matrix.
      void
      prepare()
      {
        std::vector<const LinearEquation *> all;
        for (const auto &node : nodes)
          for (const auto &e : node.equations)
            all.push_back(&e.equation);
        floating.set_loads(loads);
        report.note = floating.check_loads(all);
        floating.choose_pins(all);

        u = state.displacement;
        supports.distribute(u);
        state.displacement = u;
        guess_closed_nodes();
        make_proximal_terms();
        const bool may_change =
            std::any_of(nodes.begin(), nodes.end(), [](const CandidateNode &node) { return !node.tied; });
        forcing = may_change ? 1e-4 : fine_forcing();
        if (!solver.is_direct(discretization.dof_handler.n_dofs()))
          solver.set_near_null_space(rigid_body_modes(discretization));

        TimerOutput::Scope           scope(timer, "sparsity and bulk matrix");
        std::vector<ContactEquation> candidates;
        for (const auto &node : nodes)
          for (const auto &equation : node.equations)
            {
              candidates.push_back(equation);
              substitute(candidates.back().equation, supports);
            }
        system.setup(cells(), supports, candidates, floating.any() ? &springs : nullptr);
      }

      CellMatrices
      cells() const
      {
        CellMatrices result;
        result.n      = elasticity.n_cells();
        result.dofs   = [this](const unsigned int c) -> const auto   &{ return elasticity.dofs(c); };
        result.matrix = [this](const unsigned int c) { return elasticity.matrix(c); };
        return result;
      }

      void
      guess_closed_nodes()
      {
        bool known = state.states.size() == interfaces.size();
        for (unsigned int i = 0; known && i < interfaces.size(); ++i)
          known = state.states[i].size() == interfaces[i].coupling.rows.size();
        if (!known)
          closed = first_guess_of_closed_nodes(nodes, interfaces, floating, state.displacement);
        else
          for (const auto &node : nodes)
            closed.push_back(node.tied || state.states[node.interface][node.row] != ContactState::open);
      }

      // Diagonal terms on the increment only, which vanish at convergence: pins for motions that contact can
      // never hold, and weak springs for those that no closed node holds yet.
      void
      make_proximal_terms()
      {
        if (!floating.any())
          return;
        const double weak = 1e-8;
        springs           = discretization.make_owned_vector();
        pins              = discretization.make_owned_vector();
        double largest    = 0;
        for (unsigned int c = 0; c < elasticity.n_cells(); ++c)
          for (unsigned int i = 0; i < elasticity.dofs(c).size(); ++i)
            {
              largest = std::max(largest, elasticity.diagonal(c, i));
              if (floating.floats()[elasticity.body(c)])
                springs(elasticity.dofs(c)[i]) += weak * elasticity.diagonal(c, i);
            }
        springs.compress(VectorOperation::add);
        largest = Utilities::MPI::max(largest, communicator);
        for (const auto &carrier : discretization.carrier_dofs)
          for (const auto &corner : carrier)
            for (const auto dof : corner)
              if (discretization.locally_owned.is_element(dof))
                springs(dof) = weak * largest;
        for (const auto dof : floating.pins())
          if (discretization.locally_owned.is_element(dof))
            pins(dof) = largest;
        springs.compress(VectorOperation::insert);
        pins.compress(VectorOperation::insert);
        springs += pins;
      }

      void
      constrain_closed_nodes()
      {
        TimerOutput::Scope                  scope(timer, "assemble condensed system");
        std::vector<ContactEquation>        active;
        std::vector<const LinearEquation *> holding;
        first_equation.assign(nodes.size(), numbers::invalid_unsigned_int);
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (closed[k])
            {
              first_equation[k] = active.size();
              for (const auto &equation : nodes[k].equations)
                {
                  active.push_back(equation);
                  holding.push_back(&equation.equation);
                }
            }
        constraints = std::make_unique<ContactConstraints>(supports, active);
        unheld      = floating.unheld_by(holding);
        system.assemble(cells(),
                        constraints->all(),
                        !unheld.empty()            ? &springs
                        : !floating.pins().empty() ? &pins
                                                   : nullptr);
        solver.matrix_changed(system.matrix(), report.iterations.empty());
      }

      // Moves on to the constraints, then solves for the homogeneous increment.
      bool
      solve_increment(NewtonReport::Iteration &step)
      {
        constraints->all().distribute(u);
        state.displacement  = u;
        LA::Vector residual = loads;
        residual -= elasticity.apply(state.displacement);
        LA::Vector rhs(discretization.locally_owned, communicator);
        rhs = condense(residual, constraints->all(), loads);
        zero_constrained(constraints->all(), discretization.locally_owned, rhs);

        TimerOutput::Scope scope(timer, "linear solve");
        const double       scale  = report.iterations.empty() ? rhs.l2_norm() : force_scale;
        const auto         result = solver.solve(system.matrix(), du, rhs, forcing * scale);
        step.krylov               = result.iterations;
        if (!result.success)
          {
            first_equation.assign(nodes.size(), numbers::invalid_unsigned_int); // the multipliers are older
            report.message =
                "the linear solver failed after " + std::to_string(result.iterations) + " iterations";
            return false;
          }
        if (report.iterations.empty())
          report.one_linear_solve_seconds = clock.wall_time();
        u += du;
        constraints->all().distribute(u);
        state.displacement = u;
        return true;
      }

      // Contact forces from the unconstrained residual; gaps of the open nodes.
      void
      recover_contact(NewtonReport::Iteration &step)
      {
        internal = elasticity.apply(state.displacement);
        raw      = internal;
        raw -= loads;
        const LA::Vector    on_supports = condense(raw, supports, loads);
        std::vector<double> at_pivots(constraints->pivots().size(), 0.);
        for (unsigned int e = 0; e < at_pivots.size(); ++e)
          if (const auto pivot = constraints->pivots()[e];
              pivot && discretization.locally_owned.is_element(*pivot))
            at_pivots[e] = on_supports(*pivot);
        Utilities::MPI::sum(at_pivots, communicator, at_pivots);
        multipliers = constraints->recover_multipliers(at_pivots);

        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            const auto &equation = nodes[k].equations[0].equation;
            const bool  carries  = closed[k] && constraints->pivots()[first_equation[k]];
            pressure[k]          = carries ? multipliers[first_equation[k]] / nodes[k].area : 0.;
            gap[k]               = carries ? 0. : equation.value - evaluate(equation, state.displacement);
            (nodes[k].tied ? step.n_stick : closed[k] ? step.n_slip : step.n_open) += 1;
          }
      }

      // What rounding leaves of |K||u| counts as zero: scenes without stress, stiff bodies on soft ones.
      double
      relative_residual()
      {
        LA::Vector free = condense(raw, constraints->all(), loads);
        zero_constrained(constraints->all(), discretization.locally_owned, free);
        const double rounding = 1e-14 * elasticity.rounding_scale(state.displacement);
        force_scale = std::max({internal.l2_norm(), loads.l2_norm(), rounding / parameters.tolerance});
        return force_scale == 0 ? 0 : free.l2_norm() / force_scale;
      }

      bool
      update_set(NewtonReport::Iteration &step)
      {
        std::vector<double> p, g, c;
        std::vector<bool>   next;
        double              largest = 0, rounding = 0;
        for (unsigned int k = 0; k < nodes.size(); ++k)
          if (!nodes[k].tied)
            {
              p.push_back(pressure[k]);
              g.push_back(gap[k]);
              c.push_back(nodes[k].c);
              next.push_back(closed[k]);
              largest  = std::max(largest, std::abs(pressure[k]));
              rounding = std::max(rounding, nodes[k].rounding);
            }
        rounding += 1e-13 * (c.empty() ? 0. : *std::max_element(c.begin(), c.end())) * u.linfty_norm();
        step.n_changes     = active_set.update(p, g, c, std::max(1e-9 * largest, rounding), next);
        report.safeguarded = report.safeguarded || active_set.safeguarded();
        for (unsigned int k = 0, n = 0; k < nodes.size(); ++k)
          if (!nodes[k].tied)
            closed[k] = next[n++];
        return step.n_changes > 0;
      }

      // Weak springs are all that holds a motion, and they are not coming to rest.
      bool
      moves_apart() const
      {
        const unsigned int n = report.iterations.size();
        return n > 1 && !unheld.empty() &&
               report.iterations[n - 1].residual > 0.5 * report.iterations[n - 2].residual;
      }

      // While many nodes still change, systems are solved as far as that is worth; the last ones for good.
      // Where only weak springs hold a motion, even a small residual may be a large motion.
      void
      choose_forcing(const NewtonReport::Iteration &step, const bool set_changed)
      {
        const bool rough = set_changed && step.n_changes > 0.05 * step.n_slip && unheld.empty();
        forcing          = rough ? 1e-3 : fine_forcing();
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
        if (report.iterations.empty() || !std::isfinite(report.iterations.back().residual))
          {
            state.displacement = discretization.make_relevant_vector();
            closed.assign(nodes.size(), false);
          }
        else if (!unheld.empty())
          {
            double force = 0;
            for (const auto dof : discretization.locally_owned)
              force += std::abs(springs(dof) * du(dof));
            const double load           = loads.l1_norm();
            force                       = Utilities::MPI::sum(force, communicator);
            report.regularisation_force = load > 0 ? force / load : force;
          }
        state.states.assign(interfaces.size(), {});
        state.pressures.assign(interfaces.size(), {});
        state.gaps.assign(interfaces.size(), {});
        state.tied_multipliers.assign(interfaces.size(), {});
        for (unsigned int k = 0; k < nodes.size(); ++k)
          store(k);
        if (!report.converged && report.message.empty())
          report.message = "no converged contact set after " + std::to_string(report.iterations.size()) +
                           " iterations (residual " + std::to_string(report.iterations.back().residual) +
                           ", " + std::to_string(report.iterations.back().n_changes) +
                           " nodes still change); try a finer mesh, smaller loads or more iterations";
      }

      void
      store(const unsigned int k)
      {
        const auto  i       = nodes[k].interface;
        const auto &row     = interfaces[i].coupling.rows[nodes[k].row];
        const bool  carries = closed[k] && first_equation[k] != numbers::invalid_unsigned_int;

        std::vector<double> tied(nodes[k].tied ? dim : 0, 0.);
        double              p = carries && !nodes[k].tied ? pressure[k] : 0.;
        for (unsigned int d = 0; carries && d < tied.size(); ++d)
          {
            tied[d] = multipliers[first_equation[k] + d] / row.area;
            p += tied[d] * row.normal[d];
          }
        state.states[i].push_back(nodes[k].tied ? ContactState::stick
                                  : closed[k]   ? ContactState::slip
                                                : ContactState::open);
        state.gaps[i].push_back(gap[k]);
        state.pressures[i].push_back(p);
        state.tied_multipliers[i].push_back(tied);
      }

      const NewtonParameters                   &parameters;
      const LinearSolverParameters             &solver_parameters;
      const Discretization<dim>                &discretization;
      const ElasticityOperator<dim>            &elasticity;
      const std::vector<ContactInterface<dim>> &interfaces;
      const Constraints                        &supports;
      const LA::Vector                         &loads;
      SolutionState                            &state;
      TimerOutput                              &timer;
      const MPI_Comm                            communicator;

      Timer                            clock;
      const std::vector<CandidateNode> nodes;
      FloatingBodies<dim>              floating;
      CondensedSystem                  system;
      LinearSolver        solver; // its factorisation refers to the matrix, which must outlive it
      ActiveSetUpdate     active_set;
      NewtonReport        report;
      LA::Vector          springs, pins, u, du, internal, raw;
      std::vector<bool>   closed;
      std::vector<double> pressure, gap, multipliers;
      std::unique_ptr<ContactConstraints> constraints;
      std::vector<unsigned int>           first_equation;  // of node k among those of the closed nodes
      std::string                         unheld;          // motions that the closed nodes leave
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
                               SolutionState                            &state,
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

#include <amontons/contact/supported_nodes.h>
#include <amontons/solver/augmented_lagrangian.h>
#include <amontons/solver/contact_region.h>
#include <amontons/solver/diagnosis.h>
#include <amontons/solver/eliminated_step.h>
#include <amontons/solver/fixed_contact.h>
#include <amontons/solver/fixed_point_friction.h>
#include <amontons/solver/pseudo_transient.h>
#include <amontons/solver/row_step.h>
#include <amontons/solver/seed_iteration.h>
#include <amontons/solver/solve_contact.h>
#include <amontons/solver/symmetry_planes.h>

#include <deal.II/grid/grid_tools.h>

namespace Amontons
{
  namespace
  {
    // Of a converged increment. Damped motion takes bodies farther than an increment does: what was opposite
    // of each other before says nothing then.
    template <int dim>
    void
    check_crossing(const MovingContact<dim>  &contact,
                   const Discretization<dim> &discretization,
                   const SolutionState<dim>  &state,
                   NewtonReport              &report)
    {
      using Kind      = Failure::Kind;
      const auto fail = [&](const Kind kind, const std::vector<Point<dim>> &nodes) {
        if (!report.failure && !nodes.empty())
          report.failure = Diagnosis::surfaces_cross(kind, nodes);
      };
      if (!report.moved)
        {
          fail(Kind::passed_through, contact.passed_through(state));
          fail(Kind::entered, contact.entered());
        }
      fail(Kind::beyond_symmetry, beyond_symmetry_planes(discretization, state.displacement));
      report.converged = !report.failure;
    }

    // What holds bodies that slide freely would bear its force then.
    template <int dim>
    bool
    touches_wall(const Discretization<dim>                &discretization,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const SolutionState<dim>                 &state)
    {
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        if (discretization.walls.count(interfaces[i].pair->name) > 0)
          for (const auto &node : state.contact[i])
            if (node.has_multiplier && node.state != ContactStatus::open)
              return true;
      return false;
    }

    template <int dim>
    void
    check_supported(const ContactEquilibrium<dim> &problem, NewtonReport &report)
    {
      if (!report.converged)
        return;
      if (touches_wall(problem.discretization, problem.interfaces, problem.state))
        {
          report.failure   = Failure{Failure::Kind::wall_touched};
          report.converged = false;
          return;
        }
      const auto nodes = driven_through(
          problem.discretization, problem.supports, problem.state.displacement, problem.interfaces);
      if (nodes.empty())
        return;
      report.failure   = Diagnosis::surfaces_cross(Failure::Kind::driven_through, nodes);
      report.converged = false;
    }

    bool
    is_by_friction(const std::optional<Failure> &failure)
    {
      using Kind = Failure::Kind;
      return failure && (failure->kind == Kind::friction_beyond_limit ||
                         failure->kind == Kind::friction_exceeded || failure->kind == Kind::friction_slides);
    }

    // Where the bodies are now.
    template <int dim>
    FloatingBodies<dim>
    floating_bodies(const ContactEquilibrium<dim> &problem)
    {
      FloatingBodies<dim> floating(
          problem.discretization, problem.supports, problem.interfaces, &problem.state.displacement);
      floating.set_loads(problem.mechanics.loads());
      floating.choose_pins(holding_equations(problem.contact.nodes()));
      return floating;
    }

    // Bodies that are held by contact alone may be in an equilibrium that there is only on this mesh; and
    // where friction cannot hold them, perhaps no friction could. at_start: of the solve.
    template <int dim>
    void
    check_region(const ContactEquilibrium<dim> &problem,
                 const FloatingBodies<dim>     &at_start,
                 NewtonReport                  &report)
    {
      const bool moves  = problem.contact.moves();
      const auto region = report.converged ? ContactRegion::closed : ContactRegion::anywhere;
      if (!at_start.any() || !(report.converged || (!moves && is_by_friction(report.failure))) ||
          !ends_at_an_edge(problem, region))
        return;
      const auto motion = moves ? motion_beyond_region(problem, floating_bodies(problem), region)
                                : motion_beyond_region(problem, at_start, region);
      if (motion.empty())
        return;
      report.converged       = false;
      report.failure         = Failure{Failure::Kind::beyond_edge};
      report.failure->motion = at_start.describe(motion);
    }

    // By Newton's method, or by one that calls it again and again. follow_motion: see PseudoTransient.
    template <int dim>
    NewtonReport
    run_method(const ContactEquilibrium<dim> &problem,
               NewtonStep<dim>               &step,
               Newton<dim>                   &newton,
               Penalty<dim>                  *penalty,
               const FollowMotion             follow_motion)
    {
      const auto &method = problem.parameters.method;
      if (method == "augmented Lagrangian")
        // NOLINTNEXTLINE(clang-analyzer-core.NonNullParamChecker): that method has one
        return AugmentedLagrangian<dim>(problem, newton, *penalty).run();
      if (method == "fixed-point friction")
        return FixedPointFriction<dim>(problem, newton).run();
      if (method == "seed")
        return SeedIteration<dim>(problem, newton).run();
      if (problem.contact.moves())
        return PseudoTransient<dim>(problem, step, newton).run(follow_motion);
      newton.prepare();
      newton.iterate();
      return newton.finish();
    }

    template <int dim>
    ContactEquilibrium<dim>
    equilibrium(const ContactSolver<dim>           &solver,
                Mechanics<dim>                     &mechanics,
                ContactKinematics<dim>             &contact,
                std::vector<ContactInterface<dim>> &interfaces,
                const Constraints                  &supports,
                SolutionState<dim>                 &state,
                Penalty<dim>                       *penalty)
    {
      return {solver.parameters,
              solver.solver_parameters,
              solver.discretization,
              mechanics,
              contact,
              interfaces,
              supports,
              state,
              solver.timer,
              penalty,
              solver.gives_up};
    }
  } // namespace

  //! [solve]
  template <int dim>
  NewtonReport
  ContactSolver<dim>::solve(Mechanics<dim>                       &mechanics,
                            std::vector<ContactInterface<dim>>   &interfaces,
                            const Constraints                    &supports,
                            SolutionState<dim>                   &state,
                            const typename Newton<dim>::Observer &observer,
                            const FollowMotion                    follow_motion) const
  {
    TimerOutput::Scope          scope(timer, "contact iteration");
    std::optional<Penalty<dim>> penalty;
    const auto problem_with = [&](ContactKinematics<dim> &contact) -> ContactEquilibrium<dim> {
      if (parameters.has_penalty())
        penalty.emplace(parameters.penalty, parameters.scaling, contact, state);
      return equilibrium(
          *this, mechanics, contact, interfaces, supports, state, penalty ? &*penalty : nullptr);
    };
    const double smallest_cell = GridTools::minimal_cell_diameter(discretization.geometry.triangulation);
    if (mechanics.is_linear())
      {
        FixedContact<dim>   contact(discretization, supports, interfaces, state, parameters.scaling);
        const auto          problem = problem_with(contact);
        KeptSystem<dim>     own;
        EliminatedStep<dim> step(problem, kept != nullptr ? *kept : own);
        Newton<dim>         newton(problem, step, smallest_cell, observer);
        auto                report =
            run_method(problem, step, newton, penalty ? &*penalty : nullptr, FollowMotion::from_unstable);
        check_supported(problem, report);
        check_region(problem, newton.floating_bodies(), report);
        return report;
      }
    MovingContact<dim> contact(discretization, supports, interfaces, state, parameters.scaling);
    const auto         problem = problem_with(contact);
    RowStep<dim>       step(problem, contact, smallest_cell);
    Newton<dim>        newton(problem, step, smallest_cell, observer);
    auto report = run_method(problem, step, newton, penalty ? &*penalty : nullptr, follow_motion);
    if (report.converged)
      check_crossing(contact, discretization, state, report);
    check_supported(problem, report);
    check_region(problem, newton.floating_bodies(), report);
    return report;
  }
  //! [solve]

  template <int dim>
  std::optional<double>
  ContactSolver<dim>::stress_stiffening(Mechanics<dim>                     &mechanics,
                                        std::vector<ContactInterface<dim>> &interfaces,
                                        const Constraints                  &supports,
                                        SolutionState<dim>                  state,
                                        const double                        most_strain) const
  {
    TimerOutput::Scope scope(timer, "contact iteration");
    FixedContact<dim>  contact(discretization, supports, interfaces, state, parameters.scaling);
    const auto problem = equilibrium<dim>(*this, mechanics, contact, interfaces, supports, state, nullptr);
    const typename Newton<dim>::Observer observer = [](const auto &) {};
    KeptSystem<dim>                      own; // which no step leaves to what it knows of other states
    EliminatedStep<dim>                  step(problem, own);
    Newton<dim>                          newton(
        problem, step, GridTools::minimal_cell_diameter(discretization.geometry.triangulation), observer);
    if (!newton.prepare())
      return {};
    newton.linearise();
    if (!newton.now().free_modes.empty())
      return {};
    return step.stress_stiffening(newton.now(), most_strain);
  }

  template struct ContactSolver<2>;
  template struct ContactSolver<3>;
} // namespace Amontons

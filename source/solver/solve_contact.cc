#include <amontons/solver/diagnosis.h>
#include <amontons/solver/eliminated_step.h>
#include <amontons/solver/fixed_contact.h>
#include <amontons/solver/pseudo_transient.h>
#include <amontons/solver/row_step.h>
#include <amontons/solver/solve_contact.h>

#include <deal.II/grid/grid_tools.h>

namespace Amontons
{
  //! [solve]
  template <int dim>
  NewtonReport
  ContactSolver<dim>::solve(Mechanics<dim>                       &mechanics,
                            std::vector<ContactInterface<dim>>   &interfaces,
                            const Constraints                    &supports,
                            SolutionState<dim>                   &state,
                            const typename Newton<dim>::Observer &observer,
                            const bool                            follow_motion) const
  {
    TimerOutput::Scope          scope(timer, "contact iteration");
    std::optional<Penalty<dim>> penalty;
    const auto problem_with = [&](ContactKinematics<dim> &contact) -> ContactEquilibrium<dim> {
      if (parameters.method == "penalty")
        penalty.emplace(parameters.penalty, parameters.scaling, contact, state);
      return {parameters,
              solver_parameters,
              discretization,
              mechanics,
              contact,
              interfaces,
              supports,
              state,
              timer,
              penalty ? &*penalty : nullptr};
    };
    const double smallest_cell = GridTools::minimal_cell_diameter(discretization.geometry.triangulation);
    if (mechanics.is_linear())
      {
        FixedContact<dim>   contact(discretization, interfaces, state, parameters.scaling);
        const auto          problem = problem_with(contact);
        EliminatedStep<dim> step(problem);
        Newton<dim>         newton(problem, step, smallest_cell, observer);
        newton.prepare();
        newton.iterate();
        return newton.finish();
      }
    MovingContact<dim> contact(discretization, supports, interfaces, state, parameters.scaling);
    const auto         problem = problem_with(contact);
    RowStep<dim>       step(problem, contact, smallest_cell);
    Newton<dim>        newton(problem, step, smallest_cell, observer);
    auto               report = PseudoTransient<dim>(problem, step, newton).run(follow_motion);
    if (const auto nodes = contact.passed_through(state); report.converged && !report.moved && !nodes.empty())
      {
        report.converged = false;
        report.failure   = Diagnosis::passed_through(nodes);
      }
    return report;
  }
  //! [solve]

  template struct ContactSolver<2>;
  template struct ContactSolver<3>;
} // namespace Amontons

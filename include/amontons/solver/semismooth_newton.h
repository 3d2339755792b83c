// One loop for geometry and contact: solve with the present closed nodes, see which nodes pull or penetrate,
// change them.
#pragma once

#include <amontons/algebra/condensed_system.h>
#include <amontons/algebra/contact_constraints.h>
#include <amontons/algebra/linear_solver.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/solver/floating_bodies.h>
#include <amontons/solver/newton_report.h>
#include <amontons/solver/solution_state.h>

#include <deal.II/base/timer.h>

namespace Amontons
{
  struct NewtonParameters : ParameterGroup
  {
    unsigned int max_iterations = 60;
    double       tolerance      = 1e-9; // residual relative to the internal forces
    double       scaling        = 1;    // multiplies the complementarity parameter c = E / h

    void
    declare(ParameterHandler &prm) override;
  };

  template <int dim>
  class SemismoothNewton
  {
  public:
    SemismoothNewton(const NewtonParameters       &parameters,
                     const LinearSolverParameters &solver_parameters,
                     const Discretization<dim>    &discretization,
                     TimerOutput                  &timer);

    using Observer = std::function<void(const NewtonReport::Iteration &)>;

    // state: displacement is the start and the result; states (if they fit the rows) the first guess of the
    // closed nodes.
    NewtonReport
    solve(const ElasticityOperator<dim>            &elasticity,
          const std::vector<ContactInterface<dim>> &interfaces,
          const Constraints                        &supports,
          const LA::Vector                         &loads,
          SolutionState<dim>                       &state,
          const Observer                           &observer);

  private:
    const NewtonParameters       &parameters;
    const LinearSolverParameters &solver_parameters;
    const Discretization<dim>    &discretization;
    TimerOutput                  &timer;
  };
} // namespace Amontons

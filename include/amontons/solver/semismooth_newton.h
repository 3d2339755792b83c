// One loop for geometry and contact: solve with the present closed nodes, see which nodes pull or penetrate,
// change them.
#pragma once

#include <amontons/algebra/condensed_system.h>
#include <amontons/algebra/contact_constraints.h>
#include <amontons/algebra/linear_solver.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/solver/floating_bodies.h>
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

  // What one solve did; failure is a value.
  struct NewtonReport
  {
    struct Iteration
    {
      unsigned int n_open, n_slip, n_stick, n_changes, krylov;
      double       residual;
    };
    bool                   converged = false;
    std::string            message; // a diagnosis if not
    std::vector<Iteration> iterations;
    double                 one_linear_solve_seconds = 0;
    double                 start_residual =
        0; // of the first guess, moved on to the constraints, relative to the final forces
    double      regularisation_force = 0; // carried by the proximal term in the end, relative to the load
    bool        safeguarded          = false;
    bool        frozen               = false; // bounds of friction were held for a while, see NodeStates
    bool        moved                = false; // a damped motion was followed, see FiniteNewton
    bool        unstable             = false; // from an equilibrium that was not stable
    std::string note;
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
          SolutionState                            &state,
          const Observer                           &observer);

  private:
    const NewtonParameters       &parameters;
    const LinearSolverParameters &solver_parameters;
    const Discretization<dim>    &discretization;
    TimerOutput                  &timer;
  };
} // namespace Amontons

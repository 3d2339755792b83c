/// From bodies, surfaces and supports to a state in equilibrium: doc/introduction.md, (2) and (3).
#pragma once

#include <amontons/solver/damped_motion.h>
#include <amontons/solver/kept_system.h>
#include <amontons/solver/newton.h>

namespace Amontons
{
  template <int dim>
  struct ContactSolver
  {
    const NewtonParameters       &parameters;
    const LinearSolverParameters &solver_parameters;
    const Discretization<dim>    &discretization;
    TimerOutput                  &timer;
    GivesUp                       gives_up = {};
    KeptSystem<dim>              *kept = nullptr; // of the discretization, from the solves before; or null

    /// state: displacement is the start and the result, committed the last converged one; contact (if known)
    /// the first guess. interfaces: coupled; at finite strain in the end at the result. follow_motion (finite
    /// strain): see PseudoTransient.
    NewtonReport
    solve(Mechanics<dim>                       &mechanics,
          std::vector<ContactInterface<dim>>   &interfaces,
          const Constraints                    &supports,
          SolutionState<dim>                   &state,
          const typename Newton<dim>::Observer &observer,
          const FollowMotion                    follow_motion = FollowMotion::from_unstable) const;

    /// Small strain, at a state in equilibrium: EliminatedStep::stress_stiffening(); nothing where a rigid
    /// motion is free. Collective.
    std::optional<double>
    stress_stiffening(Mechanics<dim>                     &mechanics,
                      std::vector<ContactInterface<dim>> &interfaces,
                      const Constraints                  &supports,
                      SolutionState<dim>                  state,
                      const double                        most_strain) const;
  };
} // namespace Amontons

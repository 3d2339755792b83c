// The semismooth Newton iteration with large deformation and sliding.
#pragma once

#include <amontons/elasticity/finite_mechanics.h>
#include <amontons/solver/moving_contact.h>
#include <amontons/solver/semismooth_newton.h>

namespace Amontons
{
  // As SemismoothNewton, for
  //   internal forces(u) - contact forces(u, p, q) = loads(u),   gaps(u) >= 0, ...
  // Each iteration integrates surfaces and bodies where they are, takes the multipliers from the residual of
  // the rows that test functions of closed nodes leave, and linearises everything else: quadratic convergence
  // once the states are found. Steps that invert a cell are halved; if that does not help, the report says
  // where.
  //
  // Where no equilibrium is near (snap-through, buckling), the motion  D du/dtau + internal - contact forces
  // = loads  at fixed t is followed to the next one that is stable (DampedSteps); nodes close and open as in
  // the iteration. Equilibria are checked for stability where this is cheap (one direct solver, nothing
  // rubs), and left by the same motion if they are not.
  template <int dim>
  class FiniteNewton
  {
  public:
    FiniteNewton(const NewtonParameters       &parameters,
                 const LinearSolverParameters &solver_parameters,
                 const Discretization<dim>    &discretization,
                 TimerOutput                  &timer);

    // interfaces: in the end coupled at the result. state: displacement is the start and the result,
    // committed the last converged one; states (if they fit the couplings) the first guess. damped: start
    // with the damped motion.
    NewtonReport
    solve(FiniteMechanics<dim>                           &mechanics,
          std::vector<ContactInterface<dim>>             &interfaces,
          const Constraints                              &supports,
          SolutionState<dim>                             &state,
          const typename SemismoothNewton<dim>::Observer &observer,
          const bool                                      damped = false);

  private:
    const NewtonParameters       &parameters;
    const LinearSolverParameters &solver_parameters;
    const Discretization<dim>    &discretization;
    TimerOutput                  &timer;
  };
} // namespace Amontons

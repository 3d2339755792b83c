/// Newton's method where no equilibrium is near (snap-through, buckling): a caller of it.
#pragma once

#include <amontons/solver/damped_motion.h>
#include <amontons/solver/newton.h>
#include <amontons/solver/stability.h>

namespace Amontons
{
  /// The motion  D du/dtau + internal - contact forces = loads  at fixed t is followed to the next
  /// equilibrium that is stable (DampedSteps); nodes close and open as in the iteration. Equilibria are
  /// checked for stability where this is cheap (one direct solver, nothing rubs), and left by the same motion
  /// if they are not.
  template <int dim>
  class PseudoTransient
  {
  public:
    PseudoTransient(const ContactEquilibrium<dim> &problem, NewtonStep<dim> &step, Newton<dim> &newton);

    NewtonReport
    run(const FollowMotion when);

  private:
    void
    follow_motion(const double first_step);
    bool
    move_on();
    void
    go_back(const LA::Vector &start);
    std::optional<UnstableMode>
    unstable_mode();
    void
    leave_along(const UnstableMode &mode);

    const ContactEquilibrium<dim> &problem;
    NewtonStep<dim>               &step;
    Newton<dim>                   &newton;
    Damping                        damping;
    Drag                           drag;
    std::optional<DampedSteps>     steps; // of the motion that is being followed
  };
} // namespace Amontons

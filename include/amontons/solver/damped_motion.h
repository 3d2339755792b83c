// Motion through states without equilibrium: a snap, followed as if in a viscous medium.
#pragma once

#include <amontons/discretization/discretization.h>

#include <algorithm>

namespace Amontons
{
  // D of the overdamped motion  D du/dtau + internal - contact forces = loads (doc/introduction.md, (27)), by
  // degree of freedom:
  //   D = E/L^2 int N dV, L the size of the body,
  // so that tau = 1 is the time that a stretched body takes; bending of slender ones takes (length/height)^2.
  struct Damping
  {
    LA::Vector values;
    double     length = 0; // largest L
  };

  template <int dim>
  Damping
  lumped_damping(const Discretization<dim> &discretization);

  // Where it is followed: not at all (an equilibrium that is not stable is none then); from one that is not
  // stable; from the start, as what the change of loads and supports sets off.
  enum class FollowMotion
  {
    never,
    from_unstable,
    from_start
  };

  // Steps of implicit Euler in tau: grown while they go well and as the residual falls (switched evolution
  // relaxation; Kelley and Keyes, SIAM J. Numer. Anal. 35 (1998) 508), so that the last ones are Newton
  // steps.
  class DampedSteps
  {
  public:
    explicit DampedSteps(const double size) : dtau(size) {}

    double
    size() const
    {
      return dtau;
    }
    void
    accept(const double fall_of_residual) // old over new
    {
      dtau *= std::clamp(fall_of_residual, 2., 100.);
    }
    // False: not even a tiny step is possible.
    bool
    reject()
    {
      dtau /= 4;
      return dtau > 1e-10;
    }

  private:
    double dtau;
  };
} // namespace Amontons

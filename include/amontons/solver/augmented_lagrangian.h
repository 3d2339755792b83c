/// Contact by augmented Lagrangian with Uzawa's update, to compare with: a caller of Newton's method.
#pragma once

#include <amontons/solver/newton.h>

namespace Amontons
{
  /// Springs of finite stiffness eps beside multipliers that are known: Newton's method solves with
  ///   p = lambda_n - eps g,   trial = lambda_t + eps v,   |q| <= phi(p)
  /// (Penalty; closed where p > 0), then the multipliers become what the contact bears,
  ///   lambda_n <- max(0, lambda_n - eps g),   lambda_t <- min(1, phi(lambda_n)/|trial|) trial,
  /// until that changes nothing: then g = 0, v = 0 where nodes stick and along lambda_t where they slip,
  /// whatever eps (doc/introduction.md, (33); Simo and Laursen, Computers & Structures 42 (1992) 97; Alart
  /// and Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353). Each update leaves about the part 1/(1 +
  /// eps/stiffness of the bodies) of the error. Slip is that since the start of the increment, as everywhere
  /// here, so that the multipliers are no history. Finite strain: without damped motion.
  template <int dim>
  class AugmentedLagrangian
  {
  public:
    /// penalty: that of the problem.
    AugmentedLagrangian(const ContactEquilibrium<dim> &problem, Newton<dim> &newton, Penalty<dim> &penalty)
        : problem(problem), newton(newton), penalty(penalty)
    {
    }

    /// `Maximum iterations` updates at most, each after as many of Newton's steps at most.
    NewtonReport
    run();

  private:
    double
    update_multipliers();

    const ContactEquilibrium<dim>                 &problem;
    Newton<dim>                                   &newton;
    Penalty<dim>                                  &penalty;
    std::vector<typename Penalty<dim>::Multiplier> multipliers;
  };
} // namespace Amontons

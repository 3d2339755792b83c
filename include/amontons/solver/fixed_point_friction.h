/// Coulomb's friction as a sequence of problems with given bounds, to compare with: a caller of Newton's
/// method.
#pragma once

#include <amontons/solver/newton.h>

namespace Amontons
{
  /// Newton's method solves with Tresca's bounds by node, |q_i| <= s_i, and the bounds become
  ///   s_i <- phi(p_i) = mu p_i
  /// of that solution, until their forces change no more (doc/introduction.md, (34); Panagiotopoulos,
  /// Ingenieur-Archiv 44 (1975) 421; Raous, Chabrand and Lebon, J. Theor. Appl. Mech. 7, suppl. 1 (1988)
  /// 111). Each of the problems is convex, but for nodes that open, which have no shear here: where no states
  /// are found with some bounds (in `Maximum iterations`), those of the last ones follow. The fixed point
  /// attracts where friction is small, by a factor that grows with mu; else bounds swing, and the report says
  /// so. First bounds: of the pressures of the first guess; without one none, or, where friction must hold a
  /// body, beyond all shears.
  template <int dim>
  class FixedPointFriction
  {
  public:
    FixedPointFriction(const ContactEquilibrium<dim> &problem, Newton<dim> &newton)
        : problem(problem), newton(newton)
    {
    }

    /// `Maximum iterations` bounds at most, each with as many of Newton's steps at most.
    NewtonReport
    run();

  private:
    bool
    needs_friction() const;
    double
    update_bounds();

    const ContactEquilibrium<dim> &problem;
    Newton<dim>                   &newton;
    std::vector<double>            bounds; // by node
  };
} // namespace Amontons

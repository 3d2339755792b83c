/// When Newton's step may go on with the tangent of another place.
#pragma once

#include <amontons/base/linear_algebra.h>

#include <algorithm>
#include <optional>

namespace Amontons
{
  /// Newton's residuals get smaller by a factor that goes like the strain of the step: between 0.1 and 5 of
  /// it, more where faces turn as they slide over edges. It is measured in each solve of an increment.
  class TangentReuse
  {
  public:
    /// smallest_cell: its diameter; a displacement over it is a strain.
    explicit TangentReuse(const double smallest_cell) : smallest_cell(smallest_cell) {}

    /// A tangent was made at u.
    void
    made_at(const LA::Vector &u)
    {
      place = u;
    }

    /// A linear system was solved: the norm of its right hand side, and what is left of it.
    void
    solved(const double norm, const double rest)
    {
      before      = norm;
      linear_rest = rest;
    }

    /// The step has led to u, with this residual (a force). Not to be called after the first step, whose
    /// residual is large and local; steps that the linear solve ended do not count.
    void
    measure(const LA::Vector &u, const double residual)
    {
      if (linear_rest < 0.1 * residual)
        by_strain = std::max(by_strain.value_or(0), residual / (before * strain_since(u)));
    }

    /// Of the next residual by this one, if the tangent stays: it is twice as far off as that of Newton's own
    /// step is in its mean. 1.25: where nothing is measured yet, more than blocks under pressure have.
    double
    expected_contraction(const LA::Vector &u) const
    {
      return 2 * by_strain.value_or(1.25) * strain_since(u);
    }

    double
    strain_since(const LA::Vector &u) const
    {
      LA::Vector way(u);
      way -= place;
      return way.linfty_norm() / smallest_cell;
    }

  private:
    const double          smallest_cell;
    LA::Vector            place;
    std::optional<double> by_strain;
    double                before = 0, linear_rest = 0;
  };
} // namespace Amontons

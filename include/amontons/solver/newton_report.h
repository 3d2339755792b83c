/// What one solve on one mesh did; failure is a value.
#pragma once

#include <amontons/solver/failure.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace Amontons
{
  struct NewtonReport
  {
    struct Iteration
    {
      unsigned int n_open, n_slip, n_stick, n_changes, krylov;
      double       residual;
    };
    bool                   converged = false;
    std::optional<Failure> failure; // if it has not converged
    std::vector<Iteration> iterations;
    double                 one_linear_solve_seconds = 0;
    double                 start_residual =
        0; // of the first guess, moved on to the constraints, relative to the final forces
    bool         safeguarded = false;
    bool         frozen      = false; // bounds of friction were held for a while, see NodeStates
    bool         pivoted     = false; // states were found by NewtonStep::settle
    bool         moved       = false; // a damped motion was followed, see PseudoTransient
    bool         unstable    = false; // from an equilibrium that was not stable
    unsigned int n_outer     = 0;     // solves of the methods that call Newton's again and again; else 0
    std::string  note;

    /// After those that are there.
    void
    add_note(const std::string &text)
    {
      note += (note.empty() ? "" : "; ") + text;
    }
    /// How hard it was.
    unsigned int
    iterations_per_solve() const
    {
      return iterations.size() / std::max(1u, n_outer);
    }
    bool
    goes_on() const
    {
      return !converged && !failure;
    }
    /// No node changes, and four steps have not halved a residual of at most `small`: rounding of stiff or
    /// nearly incompressible bodies, or at finite strain of their places.
    bool
    has_stalled(const double small) const;
    /// Finite strain: a shorter increment helps more than further iterations, unless bounds of friction were
    /// held or bodies are in equilibrium: states settle slowly then, but they do.
    bool
    stagnates(const double tolerance) const;
  };
} // namespace Amontons

/// Whether small strain was enough: what it leaves out, and what finite strain would change.
#pragma once

#include <amontons/adaptivity/model_selection.h>
#include <amontons/model.h>
#include <amontons/run_parameters.h>

namespace Amontons
{
  template <int dim>
  class SmallStrainCheck
  {
  public:
    SmallStrainCheck(const Scene &scene, const Parameters &parameters);

    /// What the load program collects.
    NeglectedTermsOfHistory<dim> neglected;

    /// After the load program, at its last state. Finite strain is tried where small strain leaves out more
    /// than is allowed, or, if the scene insists on small strain, more than any answer may. Not after a
    /// failure, nor where the bodies have been much farther before: what finite strain changes in the end
    /// says nothing of the way then, and what is left out decides. gives_up: of the try. Collective.
    void
    look(Model<dim>               &model,
         const SolutionState<dim> &state,
         const bool                converged,
         TimerOutput              &timer,
         const GivesUp            &gives_up);

    /// Of the relative error: the target, or 1 %; and what an answer may have at most.
    double
                            allowed_error() const;
    static constexpr double too_much = 0.1;

    /// After look(). What finite strain changes, where that was tried; else what small strain leaves out.
    double
    error() const;
    bool
    is_harmless() const;
    /// No rotation is free: finite strain needs them given or held.
    bool
    has_alternative() const
    {
      return rotations_are_held;
    }
    /// For sentences.
    std::string
    description() const;
    std::string
    allowance() const;
    /// neglected_strain, neglected_contact, neglected_stiffening(, change_of_answer): when it was looked.
    const std::map<std::string, double> &
    checks() const
    {
      return what_was_seen;
    }

  private:
    std::optional<double>
    change_by_finite_strain(Model<dim>               &model,
                            const SolutionState<dim> &state,
                            TimerOutput              &timer,
                            const GivesUp            &gives_up) const;

    const Scene                  &scene;
    const Parameters             &parameters;
    bool                          rotations_are_held = true;
    bool                          tried              = false; // finite strain, and
    std::optional<double>         change;                     // by it, if it converged
    std::map<std::string, double> what_was_seen;
  };
} // namespace Amontons

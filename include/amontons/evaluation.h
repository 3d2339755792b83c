/// What is derived from a solved state: contact fields, recovered stress, estimated error.
#pragma once

#include <amontons/adaptivity/error_estimator.h>
#include <amontons/model.h>

namespace Amontons
{
  /// Of one mesh: its refinement leaves no recovery, and fields and error of the mesh before until the next
  /// solve.
  template <int dim>
  struct Evaluation
  {
    std::vector<SurfaceFields<dim>>      fields; // by pair
    std::unique_ptr<StressRecovery<dim>> recovery;
    ErrorEstimate<dim>                   error;

    bool
    touches() const
    {
      return n_closed_nodes() > 0;
    }
    /// Enough nodes are closed that errors fall as they do in the end.
    bool
    resolves_contact() const
    {
      return n_closed_nodes() >= (dim == 2 ? 12 : 60);
    }

    void
    collect_fields(const Model<dim> &model, const SolutionState<dim> &state);

    /// After collect_fields(). worst_so_far: indicators do not fall below those of the last estimate on this
    /// mesh (what a load history needs is the worst of its increments).
    void
    estimate(const Model<dim> &model, const SolutionState<dim> &state, const bool worst_so_far);

    /// In the end of an increment of a history. A state with less than a twentieth of the largest pressure so
    /// far (unloaded, or open) is not what a target is about: the largest errors so far count, against that
    /// pressure.
    void
    judge_by_history();

  private:
    double pressure_norm = 0, shear_norm = 0; // of the state, what its errors count against

    /// Of the pair that has most.
    unsigned int
    n_closed_nodes() const;
  };
} // namespace Amontons

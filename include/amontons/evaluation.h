/// What is derived from a solved state: contact fields, recovered stress, estimated error.
#pragma once

#include <amontons/output/target_quantity.h>
#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/quantity_sequence.h>
#include <amontons/adaptivity/refined_pairs.h>
#include <amontons/model.h>

namespace Amontons
{
  /// Of one mesh: its refinement leaves no recovery, and fields and error of the mesh before until the next
  /// solve.
  template <int dim>
  struct Evaluation
  {
    /// of_history: the answer depends on the path of the load, so that the worst of its increments counts.
    explicit Evaluation(const bool of_history) : of_history(of_history) {}

    std::vector<SurfaceFields<dim>>      fields; // by pair
    std::unique_ptr<StressRecovery<dim>> recovery;
    ErrorEstimate<dim>                   error;
    RefinedPairs<dim>                    refined; // with a target

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

    /// A zone that the target looks at, or all of the contact of a pair, may be smaller than the faces of the
    /// first meshes; or its sides may be nearer than displacements are known. target: what error is allowed;
    /// is_zero: the quantity, on all meshes so far. Collective.
    bool
    may_hide(const Model<dim>         &model,
             const SolutionState<dim> &state,
             const std::string        &quantity,
             const double              target,
             const bool                is_zero) const;

    void
    collect_fields(const Model<dim> &model, const SolutionState<dim> &state);

    /// After collect_fields(). Of a history: indicators and norms do not fall below those of the increments
    /// that were kept on this mesh.
    void
    estimate(const Model<dim> &model, const SolutionState<dim> &state);

    /// After the estimate of a state that converged. Of a history: one with less than a twentieth of the
    /// largest pressure so far (unloaded, or open) is not what a target is about: the largest errors so far
    /// count, against that pressure. So with the stress, against the largest energy.
    void
    judge_by_history();
    bool
    is_judged_by_history() const
    {
      return of_history && pressure_norm < unloaded_part * error.pressure_norm;
    }
    bool
    presses_most() const
    {
      return pressure_norm > 0 && pressure_norm >= error.pressure_norm;
    }

    /// The error of the target quantity, by its values on the meshes so far and by what the fields say;
    /// at_least: what is known of it.
    void
    judge_quantity(const std::string &name, const QuantitySequence &values, const double at_least);

    /// Of the target quantity, that some mesh reaches.
    bool
    has_limit(const std::string &name) const
    {
      return always_converges(name) || is_size(name) || name == "dissipation" ||
             (name == "peak pressure" && !error.cusp_grows);
    }

    /// The increment is over: its error counts from now on; or it failed: back to that of the last one.
    void
    keep(const std::vector<ContactInterface<dim>> &interfaces);
    /// Where the pressure of the kept increments was largest, see small_contacts_are_resolved().
    bool
    saw_small_contacts() const
    {
      return has_seen_small;
    }
    void
    go_back()
    {
      error = kept;
    }
    /// The load program starts.
    void
    restart()
    {
      error = kept = ErrorEstimate<dim>();
      has_touched = has_seen_small = false;
    }
    /// It goes on on another mesh: norms stay, indicators do not.
    void
    leave_mesh();

  private:
    const bool         of_history;
    ErrorEstimate<dim> kept;                   // of the last increment
    bool               has_touched    = false; // in any increment so far
    bool               has_seen_small = false; // see saw_small_contacts()
    // Of the state, what its errors count against.
    double pressure_norm = 0, shear_norm = 0, energy_norm = 0;

    /// Of the pair that has most.
    unsigned int
    n_closed_nodes() const;
  };
} // namespace Amontons

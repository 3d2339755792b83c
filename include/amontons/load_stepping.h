/// The load of a scene on meshes that follow its solution, with retries where it is hard to find.
#pragma once

#include <amontons/failed_increment.h>
#include <amontons/adaptivity/increment_choice.h>
#include <amontons/load_path.h>
#include <amontons/small_strain_check.h>

namespace Amontons
{
  /// An increment is solved on one mesh after the other; where the answer depends on the path of the load,
  /// meshes are refined on the way, or the whole load program is repeated on refined ones.
  template <int dim>
  class LoadStepping : public LoadPath<dim>
  {
  public:
    using LoadPath<dim>::model;
    using LoadPath<dim>::history;
    using LoadPath<dim>::evaluation;
    using LoadPath<dim>::answer;
    using LoadPath<dim>::begins_in_two;
    using LoadPath<dim>::load_program;

    /// start: at rest. small_strain: sees what that leaves out, over the increments; null: finite strain.
    LoadStepping(const Parameters           &parameters,
                 std::unique_ptr<Model<dim>> start,
                 RunReport<dim>             &report,
                 SmallStrainCheck<dim>      *small_strain);

    /// False: not to the end. Why not is in the report, or in the request to stop; the state is the last one
    /// that converged, where there is one. to_facets: no further than to a mesh that wants_arcs().
    bool
    run(const bool to_facets = false);

    /// The error of the increments: where.
    struct Measurement
    {
      unsigned int        mesh;
      LoadRecord::Closing closing; // of the program there
    };

    /// What the meshes and increments of another run of the load program have shown, which ended on the
    /// present mesh: how wrong recovery is there, which increments the target takes, first guesses.
    struct Experience
    {
      std::vector<typename LoadHistory<dim>::PathPoint> path;
      std::optional<std::vector<double>>                growing; // see LoadHistory
      RecoveryFactors                                   pressure, shear;
      QuantitySequence                                  quantity;
      RefinedPairs<dim>                                 refined;
      IncrementChoice                                   increments;
      std::optional<Measurement>                        measurement;
      std::optional<IncrementErrors>                    errors;
    };
    /// Of this run, which ends with it.
    Experience
    take_experience();
    /// Before run().
    void
    go_on_from(Experience &&others);

    /// Friction: no more of that than it takes to know the error of the increments.
    void
    run_to_measure_increments();

    /// Linear elements that the program has chosen: most of the error is what facets of round bodies leave
    /// out, and more than half of the target, where quadratic ones would have next to nothing.
    bool
    wants_arcs() const;

    /// After run(): the mesh that the state is of. is_carried(): another one than the present, which was not
    /// solved: not in equilibrium.
    unsigned int
    mesh_of_state() const
    {
      return falls_back ? history.fallback_mesh : model->mesh->n_refinements;
    }
    bool
    is_carried() const
    {
      return mesh_of_state() != model->mesh->n_refinements;
    }
    /// The state is that before an increment that failed.
    bool
    ends_early() const
    {
      return ended_early;
    }

    /// Friction, after run(): what the increments do to the answer, for the report.
    void
    measure_increments();
    bool
    has_measured_increments() const
    {
      return measurement.has_value();
    }

  private:
    using LoadPath<dim>::scene;
    using LoadPath<dim>::parameters;
    using LoadPath<dim>::timer;
    using LoadPath<dim>::control;
    using LoadPath<dim>::has_history;
    using LoadPath<dim>::set_time;
    using LoadPath<dim>::start_increment;
    using LoadPath<dim>::forget_guess;
    using LoadPath<dim>::iterate;
    using LoadPath<dim>::must_stop;
    using LoadPath<dim>::go_back;
    using LoadPath<dim>::commit;
    using LoadPath<dim>::begin_next;
    using LoadPath<dim>::repeat;
    using LoadPath<dim>::store_contact;
    using LoadPath<dim>::restore_contact;

    // What becomes of an increment.
    enum class Result
    {
      converged,
      failed, // a shorter one may converge
      lost,   // none does: where it starts from has no equilibrium on the refined mesh
      stopped // before it had converged
    };

    bool
    run_load_program();
    Result
    solve_increment(const LoadProgram &program);
    bool
    solve_on_mesh(const LoadProgram &program);
    bool
    couple_better();
    void
    judge(const LoadProgram &program);
    // The error that `Target error` is asked for.
    void
    follow_target();
    // is_resolved: every contact, see small_contacts_are_resolved().
    void
    follow_quantity(const bool is_resolved);
    bool
    follows_work() const
    {
      return parameters.refinement.target_quantity == "dissipation";
    }
    void
    commit_increment(LoadProgram &program);

    struct Failures
    {
      unsigned int         in_a_row = 0;
      FailedIncrement<dim> last;
    };
    bool
    try_again(LoadProgram &program, Failures &failures);
    bool
    starts_before(LoadProgram &program);
    bool
    may_snap(const LoadProgram &program, Failures &failures) const;
    void
    roll_back();
    void
    return_to_last_converged();
    void
    return_to_last_known();
    void
    end_early(const Result why, const LoadProgram &program);
    void
    restore_shears();

    bool
    may_refine() const;
    // What the increments, chosen for the target, leave of it.
    double
    target_of_mesh() const;
    bool
    wants_refinement() const;
    // No force of a pair has changed from the mesh before as if another part of it touched.
    bool
    forces_stand() const;
    bool
    refine_now(const LoadProgram &program) const;
    bool
    replay_refined();
    // The load program with other increments.
    void
    repeat_on_mesh()
    {
      history.quantity.repeat();
      report.replay();
    }
    bool
    replay_with_all_increments()
    {
      if (must_stop() || !increments.take_all())
        return false;
      repeat_on_mesh();
      return true;
    }
    bool
    increments_are_due() const;
    bool
    increments_are_due_again() const;
    bool
    choose_increments();
    // Fewer in some pieces of the path, by a trial; of_record: length of those that left the record.
    void
    save_increments(const double of_record, const IncrementChoice::Repeat &try_these);
    bool
    may_transfer() const;
    bool
    refine();
    bool
    rebalance(const LoadProgram &program);
    bool
    sees_slip() const;
    void
    remember_path();
    CoarserTractions<dim>
    tractions_now() const;
    void
    remember_tractions();

    // When meshes are refined.
    enum class Refinement
    {
      in_last_increment,
      on_the_way,     // and the history goes on there
      between_replays // of the load program
    };

    RunReport<dim>            &report;
    SmallStrainCheck<dim>     *small_strain;
    const Refinement           refinement;
    IncrementChoice            increments;
    std::optional<Measurement> measurement;
    bool                       stops_at_facets = false; // refines no more where it wants_arcs()
    bool                       falls_back      = false; // stopped: the state is history.fallback
    bool                       ended_early     = false;
  };
} // namespace Amontons

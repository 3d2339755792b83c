/// What a run tells its user: lines on the screen while it goes on, pictures of its increments, files at its
/// end.
#pragma once

#include <amontons/evaluation.h>
#include <amontons/load_history.h>
#include <amontons/output/body_history.h>
#include <amontons/output/reference.h>
#include <amontons/output/terminal.h>
#include <amontons/output/vtu_output.h>
#include <amontons/run_control.h>
#include <amontons/solver/load_program.h>

#include <deal.II/base/timer.h>

namespace Amontons
{
  struct OutputParameters : ParameterGroup
  {
    bool        vtu              = true;
    bool        report           = true;
    bool        contact_tables   = false;
    std::string checkpoint_every = "10 minutes";

    void
    declare(ParameterHandler &prm) override;
    void
    check() const override;
    /// After check().
    Checkpoint::Intervals
    checkpoint_intervals() const;
  };

  /// Gathers the summary of one run; nothing that the run decides on is here. Methods that take an answer are
  /// collective.
  template <int dim>
  class RunReport
  {
  public:
    /// make_reference: not needed for scenes without `reference`.
    RunReport(const Scene              &scene,
              const OutputParameters   &parameters,
              const std::string        &folder,
              const bool                quiet,
              RunControl               &control,
              const MakeReference<dim> &make_reference);

    /// Introduces the scene; throws InputError where its reference cannot be made.
    void
    start();

    /// The folder is there: all that is on the screen is in amontons.log, too.
    void
    open_log();

    /// The load program starts again, on a refined mesh; with another model, whose solves alone count.
    void
    replay();
    void
    restart();
    /// On a coarser mesh, since the last one failed.
    void
    restart_coarser()
    {
      finer_mesh_failed = true;
      restart();
    }

    TimerOutput &
    timer()
    {
      return phases;
    }

    /// On the screen only; in the summary only; both.
    void
    say(const std::string &text);
    void
    note(const std::string &text);
    void
    announce(const std::string &text);
    /// How much of the load program is done.
    void
    progress(const LoadProgram &program);

    /// Whether any solve counts: there is an answer.
    bool
    has_answer() const
    {
      return !summary.meshes.empty();
    }

    /// Of all solves.
    double
    largest_pressure() const;

    /// Why the run is not converged, until the next solve. The last one counts. `kind`: where the last solve
    /// did not fail.
    void
    fail(const std::string &message, const std::string &kind = "");
    const std::string &
    message() const
    {
      return summary.message;
    }

    /// One solve on one mesh; `mesh`: number of refinements so far.
    void
    begin_solve(const LoadProgram         &program,
                const unsigned int         mesh,
                const Discretization<dim> &discretization);
    /// Of its iterations: a line each.
    std::function<void(const NewtonReport::Iteration &)>
    observer();
    void
    add_estimate(const ErrorEstimate<dim> &error);
    struct Solve
    {
      const LoadProgram     &program;
      unsigned int           mesh;
      const NewtonReport    &newton;
      const Evaluation<dim> &evaluation;
      double                 seconds;
    };
    void
    end_solve(const Answer<dim> &answer, const Solve &solve);

    /// The last solve is an increment of the load program: what was done so far, pictures.
    void
    commit(const Answer<dim> &answer, const WorkDone<dim> &work, const Evaluation<dim> &evaluation);
    /// A state that is no increment: pictures alone.
    void
    show(const Answer<dim> &answer, const Evaluation<dim> &evaluation)
    {
      write_increment(answer, evaluation);
    }
    /// The stored energy of the last solve.
    double
    energy() const
    {
      return summary.meshes.back().energy;
    }
    /// The last solve is none: it failed.
    void
    drop_last_solve();
    /// All snaps so far, of which the last is new.
    void
    add_snap(const std::vector<Diagnosis::Snap> &snaps);

    /// Friction: what the increments do to the answer, if that is known.
    void
    set_error_of_increments(const std::optional<IncrementErrors> &errors)
    {
      summary.increments = errors;
    }
    const std::optional<IncrementErrors> &
    error_of_increments() const
    {
      return summary.increments;
    }
    /// Of that quantity; 0: not known.
    double
    error_by_increments(const std::string &quantity) const
    {
      return summary.increments ? summary.increments->of(quantity) : 0.;
    }

    /// Ends the summary, and writes the files.
    struct Ending
    {
      bool                          converged;
      const Evaluation<dim>        &evaluation;
      const LoadHistory<dim>       &history;
      const RefinementParameters   &refinement;
      KinematicsErrors              kinematics;
      std::map<std::string, double> checks; // of the physics, and what small strain leaves out
    };
    const RunSummary &
    finish(const Answer<dim> &answer, const Ending &ending);

    RunControl &control;

  private:
    NewtonSummary
    summarise(const Solve &solve, const Discretization<dim> &discretization) const;
    void
    announce_checkpoint();
    void
    add_notes(const NewtonReport &newton, const Answer<dim> &answer);
    void
    add_answer(const Answer<dim> &answer, const Ending &ending);
    void
    add_energy_checks(const Ending &ending, const bool finite_strain);
    // run_notes.cc
    void
    note_untouched_pairs();
    void
    note_facets(const std::vector<ContactInterface<dim>> &interfaces, const ErrorEstimate<dim> &error);
    void
    note_sums_of_work(const Ending &ending);
    void
    note_rough_pressure(const Ending &ending);
    void
    note_small_tractions(const Answer<dim> &answer, const Ending &ending);
    std::string
    missed_target(const Discretization<dim> &discretization, const Ending &ending) const;
    void
    note_corner_forces(const Ending &ending);
    void
    note_free_motions(const Discretization<dim> &discretization);
    void
    note_what_adds_to_the_mesh(const ErrorEstimate<dim>   &error,
                               const RefinementParameters &refinement,
                               const KinematicsErrors     &kinematics);
    void
    note_limits(const Answer<dim> &answer, const Ending &ending);
    // run_files.cc
    void
    write_increment(const Answer<dim> &answer, const Evaluation<dim> &evaluation);
    void
    keep_picture(const Answer<dim> &answer, const StressRecovery<dim> &recovery);
    void
    write_progress(const std::string &state) const;
    void
    write_files_without_answer() const;
    void
    write_files(const Answer<dim> &answer, const StressRecovery<dim> *recovery) const;

    const Scene                          &scene;
    const OutputParameters               &parameters;
    const std::string                     folder;
    const MPI_Comm                        communicator;
    const MakeReference<dim>              make_reference;
    bool                                  finer_mesh_failed = false;
    Terminal                              terminal;
    TimerOutput                           phases;
    std::unique_ptr<const Reference<dim>> reference;
    VtuOutput                             vtu;
    BodyHistory<dim>                      bodies;
    unsigned int                          n_tables   = 0;
    double                                fraction   = 0; // of the load program on this mesh
    double                                last_write = -1, cost_of_write = 0; // seconds
    RunSummary                            summary;
  };
} // namespace Amontons

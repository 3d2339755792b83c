/// What a run has solved so far, for a later process to go on from.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/output/checkpoint_files.h>
#include <amontons/solver/solution_state.h>

#include <chrono>
#include <deque>
#include <utility>

namespace Amontons
{
  /// A run does the same whenever its input is the same, and nearly all of its time goes into the solution of
  /// equations. So the states that have converged are all that is kept, in the order in which they were asked
  /// for; a process that resumes the run takes the same way and finds them, each without an iteration, until
  /// there are no more. Nothing else has to be stored, wherever the run is (in the load program, in its
  /// repetition with other increments, on which mesh, with which kinematics).
  ///
  /// Files in FOLDER/checkpoint, each written aside and renamed and never written again, with length and
  /// checksum: run (what to resume), mesh_K (cells and numbers of their DoFs), states_N (up to the N-th solve
  /// of the run). States are of global vectors, so that any number of ranks may go on. Parts that are
  /// damaged, of another way than this run takes, or behind one that is missing become states_N.unused, and
  /// what they had is solved again.
  class Checkpoint
  {
  public:
    using Run   = StoredRun;
    using State = StoredSolve;

    /// How often files are written; 0: not for that reason.
    struct Intervals
    {
      double       seconds = 0;
      unsigned int solves  = 0;

      bool
      never() const
      {
        return seconds == 0 && solves == 0;
      }
    };

    explicit Checkpoint(const MPI_Comm communicator) : communicator(communicator) {}

    /// Throws InputError where there is none.
    static Run
    read_run(const std::string &folder);
    static bool
    exists(const std::string &folder);

    /// From now on states are kept in the folder of the run, which may be made later.
    void
    start(const std::string &folder, const Run &run, const Intervals &intervals);
    /// With those that are there already. Throws InputError if they are of other entries, or of the same in
    /// another order: states belong to bodies and pairs by their numbers.
    void
    resume(const std::string &folder, const Run &run, const Intervals &intervals);

    /// Also where no part of it can be used.
    bool
    resumes() const
    {
      return is_resumed;
    }
    /// What happened to it that the user should know, once.
    std::vector<std::string>
    take_notes()
    {
      return std::exchange(notes, {});
    }

    /// The last of the solves that are known at first, and whether more are.
    unsigned int
    n_known() const
    {
      return parts.empty() ? 0 : parts.back();
    }
    bool
    is_replaying() const
    {
      return next_known() != nullptr;
    }

    /// The folder is there and ours: before, nothing in it is changed.
    void
    open();

    /// Of the next solve, at state.t: its displacement and contact, if they are known. Collective.
    template <int dim>
    std::optional<NewtonReport>
    recall(const Discretization<dim>                &discretization,
           const std::vector<ContactInterface<dim>> &interfaces,
           SolutionState<dim>                       &state);

    /// The solve that was not known has converged. Collective; throws InputError on rank 0.
    template <int dim>
    void
    keep(const Discretization<dim>                &discretization,
         const std::vector<ContactInterface<dim>> &interfaces,
         const SolutionState<dim>                 &state,
         const NewtonReport                       &report);

    /// Writes what has not been written yet, after open(). Not collective; throws InputError.
    void
    flush();

    /// The run has ended: there is nothing to resume.
    void
    remove();

  private:
    const State *
    next_known() const;
    void
    forget_known(const std::string &why);
    void
    load_next_part();
    void
    set_unused_aside();
    bool
    is_due() const;
    std::string
    file(const std::string &name, const unsigned long long number) const;
    template <int dim>
    void
    find_new_numbers(const Discretization<dim> &discretization, const State &known);

    const MPI_Comm communicator;
    std::string    folder; // empty: nothing is kept
    bool           is_open = false, is_resumed = false;
    Run            run;
    Intervals      intervals;

    unsigned int              n_solves = 0;
    std::deque<State>         known;  // of the parts that have been read
    std::vector<unsigned int> parts;  // found at first: the last solve of each
    std::vector<unsigned int> unused; // of them, not renamed yet
    unsigned int              n_read = 0;
    std::vector<std::string>  notes;

    // Rank 0: not written yet.
    StoredPart                               pending;
    std::map<unsigned long long, StoredMesh> pending_meshes;
    std::size_t                              pending_bytes = 0;
    unsigned int                             last_written  = 0; // solve
    std::chrono::steady_clock::time_point    last_flush    = std::chrono::steady_clock::now();

    unsigned long long                   kept_numbering = 0, known_numbering = 0; // the last ones
    std::vector<types::global_dof_index> numbers;                                 // of the latter's DoFs now
  };
} // namespace Amontons

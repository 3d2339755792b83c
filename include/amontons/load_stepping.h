/// The load of a scene, increment by increment, on meshes that follow the solution.
#pragma once

#include <amontons/adaptivity/model_selection.h>
#include <amontons/adaptivity/state_transfer.h>
#include <amontons/failed_increment.h>
#include <amontons/run_parameters.h>
#include <amontons/solver/solve_contact.h>

namespace Amontons
{
  /// One kinematics throughout. An increment is solved on one mesh after the other; where the answer depends
  /// on the path of the load, meshes are refined on the way, or the whole load program is repeated on refined
  /// ones.
  template <int dim>
  class LoadStepping
  {
  public:
    /// neglected: small strain: collects what that leaves out, over the increments; null: nothing does.
    LoadStepping(const Scene                          &scene,
                 const Parameters                     &parameters,
                 const std::shared_ptr<BodyMesh<dim>> &mesh,
                 const bool                            finite_strain,
                 RunReport<dim>                       &report,
                 NeglectedTermsOfHistory<dim>         *neglected);

    /// False: not to the end. Why not is in the report; the state is the last one that converged, where there
    /// is one. until_measured: no more than it takes to know the error of the increments.
    bool
    run(const bool until_measured = false);

    /// Friction, after run(): what the increments do to the answer, for the report.
    void
    measure_increments();
    bool
    has_measured_increments() const
    {
      return measured;
    }

    Answer<dim>
    answer() const
    {
      return {model.discretization(),
              model.elasticity,
              model.interfaces,
              evaluation.fields,
              model.supports,
              model.loads,
              history.state};
    }

    Model<dim>       model;
    LoadHistory<dim> history;
    Evaluation<dim>  evaluation;

  private:
    LoadStepping(const LoadStepping &original, const double coarser);

    // What becomes of an increment.
    enum class Result
    {
      converged,
      failed, // a shorter one may converge
      lost    // nothing is to be tried again
    };

    bool
    run_load_program();
    void
    start_increment(const double t);
    void
    set_time(const double t);
    Result
    solve_increment(const LoadProgram &program);
    bool
    solve_on_mesh(const LoadProgram &program);
    NewtonReport
    iterate();

    void
    commit(LoadProgram &program);
    void
    keep_record(const LoadProgram &program);
    void
    remember_path();
    void
    note_snap(const double duration);

    struct Failures
    {
      unsigned int         in_a_row = 0;
      FailedIncrement<dim> last;
    };
    bool
    try_again(LoadProgram &program, Failures &failures);
    void
    roll_back();
    void
    go_back();
    void
    return_to_last_converged();

    bool
    may_refine() const;
    bool
    wants_refinement() const;
    bool
    refine_now(const LoadProgram &program) const;
    bool
    replay_refined();
    bool
    may_transfer() const;
    void
    store_contact();
    bool
    refine();
    bool
    rebalance(const LoadProgram &program);

    bool
    is_repeat() const
    {
      return coarser != 1;
    }
    // The answer depends on the path of the load; the load is applied in increments.
    bool
    has_history() const
    {
      return scene.has_friction();
    }
    bool
    is_incremental() const
    {
      return has_history() || model.finite_strain();
    }

    // When meshes are refined.
    enum class Refinement
    {
      never,
      in_last_increment,
      on_the_way,     // and the history goes on there
      between_replays // of the load program
    };

    const Scene                  &scene;
    const Parameters             &parameters;
    RunReport<dim>               &report;
    NeglectedTermsOfHistory<dim> *neglected;
    const Refinement              refinement;
    const double                  coarser  = 1; // how many times longer increments are than the scene says
    bool                          measured = false; // the increments, once
  };
} // namespace Amontons

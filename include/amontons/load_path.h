/// The load of a scene along its path, increment by increment, on the present mesh.
#pragma once

#include <amontons/evaluation.h>
#include <amontons/load_history.h>
#include <amontons/run_control.h>
#include <amontons/run_parameters.h>
#include <amontons/solver/load_program.h>
#include <amontons/solver/solve_contact.h>

namespace Amontons
{
  template <int dim>
  class LoadPath
  {
  public:
    /// start: at rest, at the time of the first increment. timer, control: of the run.
    LoadPath(const Parameters           &parameters,
             std::unique_ptr<Model<dim>> start,
             TimerOutput                &timer,
             RunControl                 &control);

    /// The load program on this mesh, if every increment converges, some of them cut at most so often, and
    /// nothing stops it; nobody is told. is_enough (may be empty): asked after each; no further.
    bool
    run(LoadProgram                 &program,
        const unsigned int           most_cut_backs = 0,
        const std::function<bool()> &is_enough      = {});

    /// Increments of these lengths; where these do not say which pieces begin in two, those of
    /// begins_in_two().
    LoadProgram
    load_program(IncrementLengths lengths) const
    {
      if (!lengths.begins_in_two)
        lengths.begins_in_two = begins_in_two(lengths);
      LoadProgram program(scene, has_history() || (model->finite_strain() && !history.at_once), lengths);
      if (history.starts_before)
        program.start_before();
      return program;
    }
    /// Where contact with friction grows, if the scene does not say how many increments there are, and their
    /// path matters: fewer than three are taken where it hardly does.
    std::vector<double>
    begins_in_two(const IncrementLengths &lengths) const
    {
      if (!has_history() || scene.n_increments > 0 ||
          3 * lengths.times > LoadProgram::increments_by_default * (1 + 1e-9))
        return {};
      return history.growing ? *history.growing
                             : std::vector<double>{LoadProgram(scene, true).first_breakpoint()};
    }

    Answer<dim>
    answer() const;

    std::unique_ptr<Model<dim>> model;
    LoadHistory<dim>            history;
    Evaluation<dim>             evaluation;

  protected:
    void
    set_time(const double t);
    void
    start_increment(const double t);
    /// What the mesh before found at t is not to be started from again; false: there is nothing (any more).
    bool
    forget_guess(const double t);
    NewtonReport
    iterate(const typename Newton<dim>::Observer &observer);
    bool
    must_stop();
    // To the last converged state, or to rest; on a refined mesh its contact states are those that the field
    // of its tractions tells.
    void
    go_back();
    void
    commit(const LoadProgram &program);
    void
    begin_next(const LoadProgram &program);
    /// What a load program leaves on this mesh; nothing if it fails or has as many increments. is_guided: by
    /// the states of `path`. Where states are several these lead longer increments to an answer that they do
    /// not find on another mesh: what is to be taken must find its way alone. (What only measures may cut
    /// some increments back: their number hardly changes.)
    std::optional<LoadRecord>
    repeat(LoadProgram program, const bool is_guided);
    void
    store_contact();
    void
    restore_contact();

    // The answer depends on the path of the load.
    bool
    has_history() const
    {
      return scene.has_friction();
    }

    const Scene      &scene;
    const Parameters &parameters;
    TimerOutput      &timer;
    RunControl       &control;

  private:
    // What the load program found on the mesh before; null if it was not there, or that is forgotten.
    typename LoadHistory<dim>::PathPoint *
    guess_at(const double t);
    // Whether tractions rest until then on the mesh before; if so the state goes on as bodies do there.
    bool
    goes_on_at_rest(const typename LoadHistory<dim>::PathPoint &point);
    // The states as first guess of those at state.t, see move_states_on().
    void
    move_states();
    // At history.state.t, with the surfaces coupled as the answer wants it.
    bool
    equilibrate();
    bool
    turn_along();
    void
    stick_first();
    // Throws InputError where a bound of friction is negative at a closed node.
    void
    check_bounds() const;
    NewtonReport
    solve(Mechanics<dim> &mechanics, const typename Newton<dim>::Observer &observer);

    // Where the increment before the present one began; empty: loads have turned since, or there was none.
    std::vector<NodalContacts<dim>> before;
    double                          before_t = 0;
  };
} // namespace Amontons

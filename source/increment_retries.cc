// LoadStepping: what is tried where an increment fails.
#include <amontons/load_stepping.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    bool
    surfaces_cross(const std::optional<Failure> &failure)
    {
      using Kind = Failure::Kind;
      return failure && (failure->kind == Kind::passed_through || failure->kind == Kind::entered ||
                         failure->kind == Kind::beyond_symmetry || failure->kind == Kind::driven_through);
    }
  } // namespace

  // An increment that fails from what the mesh before found is tried from the one before it, then cut; where
  // that does not help, damped motion is tried.
  template <int dim>
  bool
  LoadStepping<dim>::try_again(LoadProgram &program, Failures &failures)
  {
    using Kind = Failure::Kind;
    if (const auto &failure = history.last_report.failure;
        failure && (failure->kind == Kind::no_memory || failure->kind == Kind::wall_touched))
      return false; // as shorter ones would
    if (!history.at_once && forget_guess(program.next()))
      {
        report.drop_last_solve();
        go_back();
        return true;
      }
    if (starts_before(program))
      return true;
    if (may_snap(program, failures))
      {
        history.follow_motion = true;
        roll_back();
        return true;
      }
    const bool has_other_answer = history.most_cut_backs < std::numeric_limits<unsigned int>::max();
    const bool has_moved        = history.follow_motion || history.last_report.unstable;
    if (history.n_cut_backs >= history.most_cut_backs || (has_moved && has_other_answer))
      return false;
    FailedIncrement<dim> failed(*model, history.last_report);
    const bool           from_rest = history.last_converged.displacement.size() == 0;
    if (failed.is_alike(failures.last, from_rest) || !program.cut_back())
      return false;
    failures.last         = std::move(failed);
    history.follow_motion = false;
    roll_back();
    return true;
  }

  // Loads that are there at t = 0 come whole in the first increment, however short; where that fails by its
  // length they grow before.
  template <int dim>
  bool
  LoadStepping<dim>::starts_before(LoadProgram &program)
  {
    using Kind          = Failure::Kind;
    const auto &kind    = history.last_report.failure->kind;
    const bool  by_size = surfaces_cross(history.last_report.failure) || kind == Kind::inverted_cell ||
                         kind == Kind::no_states || kind == Kind::not_a_number;
    if (!by_size || !scene.is_loaded_at_start || history.starts_before || program.number() > 1 ||
        !program.is_incremental())
      return false;
    history.starts_before = true;
    program               = load_program(increments.lengths());
    std::ostringstream text;
    text << "what is there at t = 0 was not found in one increment (" << report.message()
         << "): it is applied before, from t = " << program.time() << " on";
    report.announce(text.str());
    report.drop_last_solve();
    history.restart(program.time());
    go_back();
    return true;
  }

  // Bodies that deform may, where several increments in a row find no equilibrium: with friction mostly
  // states that are hard to find. Surfaces that cross tell of increments that are too long.
  template <int dim>
  bool
  LoadStepping<dim>::may_snap(const LoadProgram &program, Failures &failures) const
  {
    const unsigned int patience = has_history() ? 5 : 3;
    if (!model->finite_strain() || history.follow_motion || surfaces_cross(history.last_report.failure))
      return false;
    return ++failures.in_a_row == patience || program.is_smallest();
  }

  template bool
  LoadStepping<2>::try_again(LoadProgram &, Failures &);
  template bool
  LoadStepping<3>::try_again(LoadProgram &, Failures &);
} // namespace Amontons

// How the load goes on, and what is kept of its history.
#include <amontons/contact_problem.h>

#include <sstream>

namespace Amontons
{
  // An increment that fails is cut; where that does not help, the bodies may snap: damped motion is tried.
  template <int dim>
  bool
  ContactProblem<dim>::run_load_program()
  {
    LoadProgram        program(scene, incremental, coarser);
    FailedIncrement    failure;
    unsigned int       n_failures = 0;                   // in a row
    const unsigned int patience   = has_history ? 5 : 3; // friction: mostly states that are hard to find
    start_history();
    //! [load program]
    while (!program.finished())
      {
        set_time(program.next());
        guess_from_path();
        const Increment result = solve_increment(program);
        if (result == Increment::converged)
          {
            note_snaps(program.next() - program.time());
            program.accept(history.last_report.moved ? 0 : history.last_report.iterations.size());
            commit(program);
            //! [load program]
            failure               = FailedIncrement();
            n_failures            = 0;
            history.follow_motion = false;
          }
        else if (is_repeat || result == Increment::lost)
          return false;
        else if (finite_strain && !history.follow_motion &&
                 (++n_failures == patience || program.is_smallest()))
          {
            history.follow_motion = true;
            roll_back(history.state.t);
          }
        //! [load program]
        else if (incremental && (finite_strain || !failed_alike(failure)) && program.cut_back())
          {
            failure               = {history.last_report, loads, prescribed_values(), growing_gaps()};
            history.follow_motion = false;
            roll_back(history.state.t);
          }
        //! [load program]
        else
          {
            if (incremental && program.number() > 1)
              return_to_last_converged();
            return false;
          }
        if (!program.finished())
          report.progress(program.time() / scene.end_time);
      }
    return true;
  }

  template <int dim>
  void
  ContactProblem<dim>::start_history()
  {
    history.restart();
    error = ErrorEstimate<dim>();
    if (!finite_strain && !is_repeat)
      neglected = NeglectedTermsOfHistory<dim>();
  }

  // The increment becomes history. Where the load path turns, slip stops: the next guess is stick.
  template <int dim>
  void
  ContactProblem<dim>::commit(const LoadProgram &program)
  {
    if (incremental)
      {
        history.work.add(answer());
        keep_record(program);
        remember_path();
      }
    if (!finite_strain && !is_repeat)
      neglected.add(*discretization, *recovery, history.state, interfaces, report.energy());
    report.commit(answer(), history.work, *recovery, error);
    if (program.finished())
      return;
    history.state.committed         = history.state.displacement;
    history.state.committed_t       = history.state.t;
    history.state.committed_contact = history.state.contact;
    if (may_transfer())
      make_traction_field();
    history.last_converged = history.state;
    for (unsigned int i = 0; program.at_corner() && i < interfaces.size(); ++i)
      for (auto &node : history.state.contact[i])
        if (interfaces[i].pair->has_friction() && node.state == ContactState::slip)
          node.state = ContactState::stick;
  }

  template <int dim>
  void
  ContactProblem<dim>::note_snaps(const double duration)
  {
    LA::Vector moved = discretization->make_owned_vector(), before = moved;
    moved = history.state.displacement;
    if (history.state.committed.size() == history.state.displacement.size())
      before = history.state.committed;
    moved -= before;
    const double distance = moved.linfty_norm(), expected = history.last_speed * duration;
    if (!history.last_report.moved)
      {
        history.last_speed = distance / duration;
        return;
      }
    history.snaps.push_back(
        {history.state.t, distance, distance > 3 * expected, history.last_report.unstable});
    report.add_snap(history.snaps);
  }

  template <int dim>
  void
  ContactProblem<dim>::roll_back(const double failed_time)
  {
    std::ostringstream text;
    text << "increments were cut back first before t = " << failed_time << ": " << report.message();
    if (history.n_cut_backs++ == 0)
      report.note(text.str());
    report.drop_last_solve();
    go_back();
  }

  // To the last converged state, or to rest; on a refined mesh its contact states are those that the field
  // of its tractions tells.
  template <int dim>
  void
  ContactProblem<dim>::go_back()
  {
    history.state = history.last_converged;
    if (history.state.displacement.size() == 0)
      history.state.displacement = discretization->make_relevant_vector();
    move_surfaces();
    if (history.last_converged.displacement.size() > 0 && history.last_converged.contact.empty())
      carry_active_set();
  }

  // Values that supports prescribe, on the owned DoFs.
  template <int dim>
  LA::Vector
  ContactProblem<dim>::prescribed_values() const
  {
    LA::Vector values = discretization->make_owned_vector();
    for (const auto dof : discretization->locally_owned)
      if (supports.is_constrained(dof))
        values(dof) = supports.get_inhomogeneity(dof);
    values.compress(VectorOperation::insert);
    return values;
  }

  template <int dim>
  std::vector<double>
  ContactProblem<dim>::growing_gaps() const
  {
    std::vector<double> gaps;
    for (const auto &interface : interfaces)
      if (gap_grows(interface))
        for (const auto &row : interface.coupling.rows)
          gaps.push_back(row.gap);
    return gaps;
  }

  // A smaller increment is the same problem again if neither loads, supports nor declared gaps depend on t;
  // or, from rest, if they all grow alike and the iteration went the same way.
  template <int dim>
  bool
  ContactProblem<dim>::failed_alike(const FailedIncrement &before) const
  {
    if (before.report.iterations.empty() || before.loads.size() != loads.size())
      return false;
    const auto   values = prescribed_values();
    const auto   gaps   = growing_gaps();
    const auto   square = [](const auto &a) { return std::inner_product(a.begin(), a.end(), a.begin(), 0.); };
    const double old    = before.loads.norm_sqr() + before.values.norm_sqr() + square(before.gaps),
                 now    = loads.norm_sqr() + values.norm_sqr() + square(gaps);
    const double scale  = old > 0 ? std::sqrt(now / old) : 1;
    const auto   differs = [&](const LA::Vector &a, LA::Vector b) {
      b.sadd(-scale, 1, a);
      return b.l2_norm() > 1e-10 * a.l2_norm();
    };
    auto change = gaps;
    for (unsigned int i = 0; i < change.size(); ++i)
      change[i] -= scale * before.gaps[i];
    if (differs(loads, before.loads) || differs(values, before.values) ||
        square(change) > 1e-20 * square(gaps))
      return false;
    if (std::abs(scale - 1) < 1e-10)
      return true;
    const auto &a = before.report.iterations, &b = history.last_report.iterations;
    return history.last_converged.displacement.size() == 0 && a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const auto &x, const auto &y) {
             return x.n_open == y.n_open && x.n_slip == y.n_slip && x.n_changes == y.n_changes;
           });
  }

  // What is written and reported is the last increment that converged; the message says how the next one
  // failed.
  template <int dim>
  void
  ContactProblem<dim>::return_to_last_converged()
  {
    const double failed_time = history.state.t;
    report.drop_last_solve();
    const bool is_transferred = history.last_converged.contact.empty();
    go_back();
    const double t = history.state.t;
    set_time(t);
    if (is_transferred)
      iterate();
    loads = assemble_loads(
        *discretization, t, covered_points(), finite_strain ? &history.state.displacement : nullptr);
    collect_fields();
    recovery->recover(history.state.displacement);
    std::ostringstream text;
    text << "the increment from t = " << t << " to " << failed_time
         << " failed (results are those of t = " << t << "): " << report.message();
    report.fail(text.str());
  }

  template <int dim>
  bool
  ContactProblem<dim>::wants_refinement() const
  {
    const auto &refinement = parameters.refinement;
    // What facets do refinement does not mend.
    const double mendable =
        std::sqrt(std::max(0., std::pow(error.decisive(), 2) - std::pow(error.facets, 2)));
    return cycle < refinement.cycles && !(refinement.target_error > 0 && mendable <= refinement.target_error);
  }

  // With history, `Replay`: the whole load program on the refined mesh.
  template <int dim>
  bool
  ContactProblem<dim>::replay_refined()
  {
    if (!has_history || parameters.refinement.history != "replay" || !wants_refinement() || !refine())
      return false;
    report.replay();
    return true;
  }

  // Without history: in the last increment. With one, unless it is replayed: evenly over the load program.
  template <int dim>
  bool
  ContactProblem<dim>::refine_now(const LoadProgram &program) const
  {
    const auto &refinement = parameters.refinement;
    if (has_history && (is_repeat || refinement.history == "replay"))
      return false;
    const bool due = has_history
                         ? cycle < std::ceil(refinement.cycles * program.next() / scene.end_time - 1e-9)
                         : program.is_last();
    return due && wants_refinement();
  }

  // Meshes may be refined between increments, and the history goes on there.
  template <int dim>
  bool
  ContactProblem<dim>::may_transfer() const
  {
    return cycle < parameters.refinement.cycles &&
           (has_history ? parameters.refinement.history == "transfer" : finite_strain);
  }

  // After a refinement on the way: the state that the increment starts from is not in equilibrium on the new
  // mesh. It is solved again there, without a change of the load; what that changes is reported.
  template <int dim>
  bool
  ContactProblem<dim>::rebalance(const LoadProgram &program)
  {
    const double t = history.state.t;
    set_time(program.time());
    const LA::Vector traction_at_end = history.state.traction;
    const auto       peaks_at_end    = history.state.peaks;
    history.state.displacement       = history.state.committed;
    move_surfaces();
    history.state.traction = history.last_converged.traction;
    history.state.peaks    = history.last_converged.peaks;
    carry_active_set();
    report.say("equilibrium of the transferred state at t = " + std::to_string(history.state.t));
    const auto result = iterate();
    if (!result.converged)
      {
        collect_fields();
        report.fail("after refinement at t = " + std::to_string(history.state.t) + ": " +
                    Diagnosis::sentence(*result.failure));
        return false;
      }
    history.transfer_residual = std::max(history.transfer_residual, result.start_residual);
    history.work.rebase(answer());
    history.state.committed   = history.state.displacement;
    history.state.committed_t = history.state.t;
    history.last_converged    = history.state;
    history.state.traction    = traction_at_end;
    history.state.peaks       = peaks_at_end;
    set_time(t);
    carry_active_set();
    return true;
  }

  template <int dim>
  void
  ContactProblem<dim>::remember_path()
  {
    if (!has_history || is_repeat || parameters.refinement.history != "replay" ||
        cycle >= parameters.refinement.cycles)
      return;
    make_traction_field();
    history.path.push_back(
        {history.state.t, history.state.displacement, history.state.traction, history.state.peaks});
  }

  template <int dim>
  void
  ContactProblem<dim>::guess_from_path()
  {
    for (const auto &point : history.path)
      if (std::abs(point.t - history.state.t) <= 1e-12 * scene.end_time &&
          point.displacement.size() == discretization->dof_handler.n_dofs())
        {
          history.state.displacement = point.displacement;
          history.state.traction     = point.traction;
          history.state.peaks        = point.peaks;
          move_surfaces();
          carry_active_set();
        }
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace Amontons

#include <amontons/adaptivity/smallest_cells.h>
#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/adaptivity/zone_ends.h>
#include <amontons/base/independent_errors.h>
#include <amontons/load_stepping.h>
#include <amontons/output/physics_checks.h>
#include <amontons/output/target_quantity.h>

namespace Amontons
{
  template <int dim>
  LoadStepping<dim>::LoadStepping(const Parameters           &parameters,
                                  std::unique_ptr<Model<dim>> start,
                                  RunReport<dim>             &report,
                                  SmallStrainCheck<dim>      *small_strain)
      : LoadPath<dim>(parameters, std::move(start), report.timer(), report.control), report(report),
        small_strain(small_strain),
        refinement(!has_history()                              ? Refinement::in_last_increment
                   : parameters.refinement.history == "replay" ? Refinement::between_replays
                                                               : Refinement::on_the_way),
        increments(parameters.refinement,
                   // of scenes that do not say how many, and where their error is known before the last mesh
                   scene.n_increments == 0 && parameters.refinement.target_error > 0 &&
                       refinement == Refinement::between_replays)
  {
  }

  template <int dim>
  bool
  LoadStepping<dim>::run(const bool to_facets)
  {
    stops_at_facets = to_facets;
    bool again;
    do
      {
        if (!run_load_program())
          return false;
        again = refinement == Refinement::between_replays && increments_are_due() && choose_increments();
      }
    while (again || replay_refined() || replay_with_all_increments());
    return !control.stop.is_there();
  }

  template <int dim>
  void
  LoadStepping<dim>::run_to_measure_increments()
  {
    do
      if (!run_load_program())
        return;
    while (!sees_slip() && replay_refined());
    if (!control.stop.is_there())
      measure_increments();
  }

  template <int dim>
  bool
  LoadStepping<dim>::run_load_program()
  {
    auto       program = load_program(increments.lengths());
    Failures   failures;
    const auto n_known = history.path.size(); // on the mesh before
    history.restart(program.time());
    evaluation.restart();
    if (small_strain != nullptr)
      small_strain->neglected = NeglectedTermsOfHistory<dim>();
    //! [load program]
    while (!program.finished())
      {
        start_increment(program.next());
        const Result result = solve_increment(program);
        if (result == Result::converged)
          {
            commit_increment(program);
            if (!program.finished() && must_stop())
              return false;
            failures = Failures();
          }
        else if (result != Result::failed || !try_again(program, failures))
          {
            end_early(result, program);
            return false;
          }
        report.progress(program);
      }
    //! [load program]
    history.path.erase(history.path.begin(), history.path.begin() + n_known);
    history.growing = history.record.growing();
    return true;
  }

  template <int dim>
  typename LoadStepping<dim>::Result
  LoadStepping<dim>::solve_increment(const LoadProgram &program)
  {
    //! [increment]
    for (;;)
      {
        do
          if (!solve_on_mesh(program))
            return control.stop.is_there() ? Result::stopped : Result::failed;
        while (couple_better());
        if (!refine_now(program) || must_stop() || !refine())
          return Result::converged;
        if (refinement == Refinement::on_the_way && program.number() > 1 && !rebalance(program))
          return control.stop.is_there() ? Result::stopped : Result::lost;
        //! [increment]
      }
  }

  template <int dim>
  bool
  LoadStepping<dim>::couple_better()
  {
    if (!model->couple_better(history.state))
      return false;
    history.fallback      = history.state;
    history.fallback_mesh = model->mesh->n_refinements;
    return true;
  }

  template <int dim>
  bool
  LoadStepping<dim>::solve_on_mesh(const LoadProgram &program)
  {
    Timer              seconds;
    const unsigned int mesh = model->mesh->n_refinements;
    report.begin_solve(program, mesh, model->discretization());
    history.last_report        = iterate(report.observer());
    const double solve_seconds = seconds.wall_time();
    if (!history.last_report.converged && must_stop()) // no estimate of what is no answer
      return false;
    evaluation.collect_fields(*model, history.state);
    if (parameters.refinement.target_error > 0)
      evaluation.refined.look(model->interfaces, evaluation.fields, mesh);
    {
      TimerOutput::Scope scope(timer, "error estimate");
      evaluation.estimate(*model, history.state);
      if (history.last_report.converged)
        {
          judge(program);
          history.fallback = {};
        }
    }
    report.add_estimate(evaluation.error);
    report.end_solve(answer(), {program, mesh, history.last_report, evaluation, solve_seconds});
    return history.last_report.converged;
  }

  // The estimate by what other meshes and increments say.
  template <int dim>
  void
  LoadStepping<dim>::judge(const LoadProgram &program)
  {
    combine_with_difference(model->discretization(),
                            model->interfaces,
                            evaluation.fields,
                            {history.state.t, increments.lengths().times},
                            history.coarser,
                            evaluation.error);
    evaluation.judge_by_history();
    // Meshes are compared where they may be refined.
    if (!follows_work() && (program.is_last() || refinement == Refinement::on_the_way))
      follow_target();
  }

  template <int dim>
  void
  LoadStepping<dim>::follow_quantity(const bool is_resolved)
  {
    const std::string &name       = parameters.refinement.target_quantity;
    const double       target     = parameters.refinement.target_error;
    auto              &error      = evaluation.error;
    const auto        &interfaces = model->interfaces;
    auto               values     = target_quantity(name, answer(), history.work);
    if ((name == "energy" ? error.energy_norm : error.pressure_norm) == 0) // no more than rounding
      std::fill(values.begin(), values.end(), 0.);
    const double rest       = rest_of_value(name, history.work.largest_work, history.record.largest_force),
                 noteworthy = noteworthy_value(name, answer(), history.work);
    std::replace_if(
        values.begin(), values.end(), [&](const double v) { return std::abs(v) <= rest; }, 0.);
    const double enough_to_stick =
        noteworthy > 0 ? target * noteworthy : std::numeric_limits<double>::infinity();
    std::vector<double> doubts;
    if (is_size(name))
      doubts = doubts_of_sizes(name, interfaces, evaluation.fields);
    if (is_resolved && (!is_size(name) || sizes_are_seen(interfaces, evaluation.fields, enough_to_stick)))
      history.quantity.add(model->discretization().dof_handler.n_dofs(), values, noteworthy, doubts);
    else
      history.quantity.add_unseen(values);
    evaluation.judge_quantity(name, history.quantity, name == "total force" ? corner_forces(answer()) : 0);
    if (is_size(name))
      add_ends_of_sizes(name,
                        model->discretization(),
                        interfaces,
                        evaluation.fields,
                        history.quantity.doubt() > target,
                        error);
  }

  template <int dim>
  void
  LoadStepping<dim>::follow_target()
  {
    const double       n_dofs      = model->discretization().dof_handler.n_dofs();
    const std::string &name        = parameters.refinement.target_quantity;
    auto              &error       = evaluation.error;
    const bool         is_resolved = follows_work()
                                         ? evaluation.saw_small_contacts()
                                         : small_contacts_are_resolved(model->interfaces, evaluation.fields);
    if (name != "contact pressure")
      follow_quantity(is_resolved);
    // Where error.data is 1 what touches is unseen.
    const bool is_known =
        evaluation.touches() ? evaluation.resolves_contact() && is_resolved : error.data < 1;
    history.meshes.add(n_dofs,
                       is_known ? error.of_target() : std::numeric_limits<double>::infinity(),
                       error.quantity ? 4 : 2,
                       evaluation.has_limit(name));
    const bool is_peak = error.quantity && name == "peak pressure" && error.cusp_grows;
    if (is_peak || (!error.quantity && error.contact > 0))
      history.meshes.add_lasting(
          n_dofs,
          error_of_smallest_cells(model->discretization(),
                                  is_peak ? error.quantity_indicators : error.indicators_for(0)),
          parameters.refinement.target_error);
  }

  template <int dim>
  void
  LoadStepping<dim>::commit_increment(LoadProgram &program)
  {
    if (history.snapped(program.next() - program.time(), model->discretization().make_owned_vector()))
      report.add_snap(history.snaps);
    program.accept(history.last_report.moved ? 0 : history.last_report.iterations_per_solve());
    history.follow_motion = false;
    evaluation.keep(model->interfaces);
    commit(program);
    // Of the work this increment is a part now.
    if (follows_work() && (program.finished() || refinement == Refinement::on_the_way))
      follow_target();
    if (refinement == Refinement::between_replays && may_refine())
      {
        remember_path();
        if (evaluation.presses_most())
          history.pressed_most = tractions_now();
      }
    if (small_strain != nullptr)
      small_strain->neglected.add(model->discretization(),
                                  *evaluation.recovery,
                                  model->elasticity,
                                  history.state,
                                  model->interfaces,
                                  report.energy());
    report.commit(answer(), history.work, evaluation);
    if (program.finished())
      return;
    if (refinement == Refinement::on_the_way &&
        !history.meshes.is_hopeless(parameters.refinement.target_error, parameters.refinement.max_dofs))
      history.meshes = {}; // of another answer
    if (may_transfer())
      store_contact();
    begin_next(program);
  }

  template <int dim>
  CoarserTractions<dim>
  LoadStepping<dim>::tractions_now() const
  {
    CoarserTractions<dim> result;
    result.place     = {history.state.t, increments.lengths().times};
    result.traction  = surface_tractions(model->discretization(), model->interfaces, evaluation.fields);
    result.n_nodes   = numbers_of_nodes(model->interfaces);
    result.recovered = evaluation.error.recovered;
    return result;
  }

  // What the next mesh compares itself with: the end, or, where that is unloaded, the largest pressure.
  template <int dim>
  void
  LoadStepping<dim>::remember_tractions()
  {
    const bool            is_unloaded = evaluation.is_judged_by_history() && history.pressed_most.place.t > 0;
    CoarserTractions<dim> kept        = is_unloaded ? std::move(history.pressed_most) : tractions_now();
    kept.pressure                     = history.coarser.pressure;
    kept.shear                        = history.coarser.shear;
    history.coarser                   = std::move(kept);
    history.pressed_most              = {};
    history.coarser_forces            = target_quantity("total force", answer(), history.work);
  }

  template <int dim>
  void
  LoadStepping<dim>::remember_path()
  {
    store_contact();
    const auto &state = history.state;
    history.path.push_back({state.t, state.displacement, state.traction, state.peaks});
  }

  template <int dim>
  bool
  LoadStepping<dim>::may_refine() const
  {
    if (small_strain != nullptr && evaluation.recovery &&
        small_strain->gives_way(*evaluation.recovery, report.energy()))
      return false;
    if (stops_at_facets && evaluation.recovery && wants_arcs())
      return false;
    return model->mesh->n_refinements < parameters.refinement.most_cycles();
  }

  template <int dim>
  bool
  LoadStepping<dim>::wants_arcs() const
  {
    const auto &discretization = model->discretization();
    const auto &error          = evaluation.error;
    return discretization.degree_is_chosen && discretization.fe.degree == 1 &&
           error.sections > std::max(parameters.refinement.target_error, error.decisive()) / 2;
  }

  template <int dim>
  double
  LoadStepping<dim>::target_of_mesh() const
  {
    const double whole = parameters.refinement.target_error;
    return increments.by_target()
               ? std::max(whole / 2,
                          left_of(whole, report.error_by_increments(parameters.refinement.target_quantity)))
               : whole;
  }

  template <int dim>
  bool
  LoadStepping<dim>::wants_refinement() const
  {
    const auto  &error    = evaluation.error;
    const auto  &quantity = parameters.refinement.target_quantity;
    const double target   = target_of_mesh();
    // What facets do refinement does not mend.
    const double mendable = error.quantity.value_or(
        std::sqrt(std::max(0., std::pow(error.decisive(), 2) - std::pow(error.facets, 2))));
    // A first mesh may be too coarse to see how wrong it is (a pin in its hole: by 5 %, estimated 1.2 %), not
    // least where the pressure is even and the rest is not (a pad below a beam: by 19 %, estimated 0.1 %).
    const bool   is_first = model->mesh->n_refinements == 0;
    const double believed = is_first ? target / RefinedPairs<dim>::doubt : target,
                 estimate = is_first ? std::max(mendable, error.bulk) : mendable;
    const bool may_hide =
        evaluation.may_hide(*model, history.state, quantity, target, history.quantity.is_zero());
    const bool may_appear = is_size(quantity) && error.contact > target;
    const bool is_enough =
        target > 0 &&
        ((estimate <= believed && !may_hide) ||
         (history.meshes.is_hopeless(target, parameters.refinement.max_dofs) && forces_stand()));
    return may_refine() && !is_enough && (may_hide || may_appear || !history.quantity.is_zero());
  }

  template <int dim>
  bool
  LoadStepping<dim>::forces_stand() const
  {
    constexpr double part = 0.1; // of the largest
    if (history.coarser_forces.empty() || history.coarser.place.t != history.state.t)
      return true;
    const auto   forces  = target_quantity("total force", answer(), history.work);
    const double largest = *std::max_element(forces.begin(), forces.end());
    return std::equal(
        forces.begin(),
        forces.end(),
        history.coarser_forces.begin(),
        [&](const double now, const double before) { return std::abs(now - before) <= part * largest; });
  }

  // On the way: evenly over the load program, or whenever the target asks for it.
  template <int dim>
  bool
  LoadStepping<dim>::refine_now(const LoadProgram &program) const
  {
    if (refinement == Refinement::in_last_increment)
      return program.is_last() && wants_refinement();
    const int    cycles = parameters.refinement.cycles;
    const double part   = cycles * program.next() / scene.end_time;
    return refinement == Refinement::on_the_way &&
           (cycles < 0 || model->mesh->n_refinements < std::ceil(part - 1e-9)) && wants_refinement();
  }

  template <int dim>
  bool
  LoadStepping<dim>::replay_refined()
  {
    if (refinement != Refinement::between_replays || !wants_refinement() || must_stop() || !refine())
      return false;
    report.replay();
    return true;
  }

  // The last converged state goes along to the refined mesh: the next increment starts from it there.
  template <int dim>
  bool
  LoadStepping<dim>::may_transfer() const
  {
    return may_refine() && refinement != Refinement::between_replays;
  }

  template <int dim>
  bool
  LoadStepping<dim>::refine()
  {
    TimerOutput::Scope scope(timer, "mesh");
    // Numbers are compared between meshes: where corners are all that is refined these are hardly others.
    const double step = history.quantity.is_empty() ? 0 : 0.3;
    // (Without a history meshes on the way are cheap.)
    const bool small_contacts = has_history() && parameters.refinement.target_error > 0 &&
                                model->mark_small_contacts(parameters.refinement, evaluation.fields);
    if (!small_contacts &&
        !model->mark_cells(parameters.refinement, evaluation.error, target_of_mesh(), step))
      {
        report.say("no further refinement: the limit of 'Maximum DoFs' is reached");
        return false;
      }
    if (const double target = parameters.refinement.target_error;
        refinement == Refinement::on_the_way && target > 0 && !evaluation.error.quantity)
      model->coarsen(evaluation.error, target);
    store_contact();
    history.work.leave_mesh(answer());
    remember_tractions();
    if (small_strain != nullptr)
      small_strain->leave_mesh(*model, *evaluation.recovery, history.state, report.energy(), timer, control);
    if (parameters.refinement.target_error > 0) // else the answer is that of this mesh
      history.most_cut_backs = 2 * history.n_cut_backs + history.many_cut_backs;
    if (!may_transfer()) // there is none, or the history starts anew on the refined mesh
      history.last_converged = SolutionState<dim>();
    model->refine(history.fields());
    evaluation.leave_mesh();
    history.last_converged.contact.clear(); // of the nodes before, see go_back()
    history.state.was_open.clear();
    history.state.committed_contact.clear();
    model->move_to(history.state);
    restore_contact();
    history.fallback      = history.state;
    history.fallback_mesh = model->mesh->n_refinements - 1;
    if (small_contacts)
      {
        if (always_converges(parameters.refinement.target_quantity)) // sizes and peaks were none
          history.quantity.compare_with_unseen();
        history.path.clear(); // what large faces touched says nothing of what touches now
      }
    return true;
  }

  // After a refinement on the way: the state that the increment starts from is not in equilibrium on the new
  // mesh. It is solved again there, without a change of the load; what that changes is reported.
  template <int dim>
  bool
  LoadStepping<dim>::rebalance(const LoadProgram &program)
  {
    auto        &state           = history.state;
    const double t               = state.t;
    const auto   traction_at_end = state.traction;
    const auto   peaks_at_end    = state.peaks;
    set_time(program.time());
    state.displacement = state.committed;
    model->move_to(state);
    state.traction = history.last_converged.traction;
    state.peaks    = history.last_converged.peaks;
    restore_contact();
    report.say("equilibrium of the transferred state at t = " + std::to_string(state.t));
    const auto result = iterate(report.observer());
    if (!result.converged && must_stop())
      return false;
    if (!result.converged)
      {
        evaluation.collect_fields(*model, state);
        report.fail("after refinement at t = " + std::to_string(state.t) + ": " +
                        Diagnosis::sentence(*result.failure),
                    Diagnosis::kind(*result.failure));
        return false;
      }
    history.transfer_residual = std::max(history.transfer_residual, result.start_residual);
    history.work.rebase(answer());
    state.committed         = state.displacement;
    state.committed_t       = state.t;
    state.committed_contact = state.contact;
    history.last_converged  = state;
    state.traction          = traction_at_end;
    state.peaks             = peaks_at_end;
    set_time(t);
    restore_contact();
    return true;
  }

  template class LoadStepping<2>;
  template class LoadStepping<3>;
} // namespace Amontons

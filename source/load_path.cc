#include <amontons/adaptivity/load_record.h>
#include <amontons/adaptivity/state_transfer.h>
#include <amontons/base/points.h>
#include <amontons/contact/moving_states.h>
#include <amontons/discretization/common_turn.h>
#include <amontons/friction/shear_law.h>
#include <amontons/load_path.h>

namespace Amontons
{
  template <int dim>
  LoadPath<dim>::LoadPath(const Parameters           &parameters,
                          std::unique_ptr<Model<dim>> start,
                          TimerOutput                &timer,
                          RunControl                 &control)
      : model(std::move(start)), evaluation(model->discretization().scene.has_friction()),
        scene(model->discretization().scene), parameters(parameters), timer(timer), control(control)
  {
    history.state.t = model->time();
  }

  template <int dim>
  Answer<dim>
  LoadPath<dim>::answer() const
  {
    return {model->discretization(),
            model->elasticity,
            model->interfaces,
            evaluation.fields,
            model->supports,
            model->loads,
            history.state};
  }

  template <int dim>
  bool
  LoadPath<dim>::run(LoadProgram                 &program,
                     const unsigned int           most_cut_backs,
                     const std::function<bool()> &is_enough)
  {
    history.restart(program.time());
    while (!program.finished())
      {
        start_increment(program.next());
        const bool converged = equilibrate();
        if (must_stop())
          return false;
        if (!converged)
          {
            if (history.n_cut_backs++ == most_cut_backs || !program.cut_back())
              return false;
            go_back();
            continue;
          }
        evaluation.collect_fields(*model, history.state);
        program.accept(history.last_report.moved ? 0 : history.last_report.iterations_per_solve());
        commit(program);
        if (is_enough && is_enough())
          return true;
        if (!program.finished())
          begin_next(program);
      }
    return true;
  }

  template <int dim>
  bool
  LoadPath<dim>::equilibrate()
  {
    do
      {
        history.last_report = iterate([](const auto &) {});
        if (!history.last_report.converged)
          return false;
      }
    while (!must_stop() && model->couple_better(history.state));
    return true;
  }

  template <int dim>
  void
  LoadPath<dim>::go_back()
  {
    evaluation.go_back();
    history.state = history.last_converged;
    if (history.state.displacement.size() == 0)
      history.state.displacement = model->discretization().make_relevant_vector();
    model->move_to(history.state);
    if (history.last_converged.displacement.size() > 0 && history.last_converged.contact.empty())
      restore_contact();
  }

  template <int dim>
  void
  LoadPath<dim>::set_time(const double t)
  {
    history.state.t = t;
    model->set_time(t);
  }

  // Where the load program was run on the mesh before: from what it found there. Where that says that the
  // tractions rest, they do so here, as they are: those of the mesh before, taken as first guesses, may lead
  // to another state that friction could hold, or to none of contact (a wedge jumped out of its groove).
  template <int dim>
  void
  LoadPath<dim>::start_increment(const double t)
  {
    set_time(t);
    if (model->finite_strain() && turn_along())
      return;
    if (const auto *point = guess_at(t); point && !goes_on_at_rest(*point))
      {
        history.state.displacement = point->displacement;
        history.state.traction     = point->traction;
        history.state.peaks        = point->peaks;
        model->move_to(history.state);
        restore_contact();
      }
    else if (point == nullptr)
      move_states();
  }

  template <int dim>
  void
  LoadPath<dim>::move_states()
  {
    auto &state = history.state;
    if (state.contact.empty() || state.contact.size() != before.size() || !(state.committed_t > before_t))
      return;
    for (unsigned int i = 0; i < before.size(); ++i)
      if (const auto &interface = model->interfaces[i];
          !interface.pair->tied && before[i].size() == state.contact[i].size())
        if (auto moved =
                move_states_on(interface, before[i], before_t, state.contact[i], state.committed_t, state.t))
          state.contact[i] = std::move(*moved);
  }

  // Where everything that is given turns as one body, from the state turned likewise: it is the answer unless
  // loads change. What the first step would make of the old state are stretched cells.
  template <int dim>
  bool
  LoadPath<dim>::turn_along()
  {
    auto &state = history.state;
    if (state.displacement.size() != model->discretization().dof_handler.n_dofs())
      return false;
    const auto motion = common_turn(model->discretization(), model->supports, state.displacement);
    if (!motion)
      return false;
    auto displacement = moved(model->discretization(), model->supports, *motion, state.displacement);
    if (!displacement)
      return false;
    state.displacement = std::move(*displacement);
    for (auto &nodes : state.contact)
      for (auto &node : nodes)
        for (auto *const along : {&node.shear, &node.trial})
          *along = motion->rotation * *along;
    stick_first();
    model->move_to(state);
    return true;
  }

  template <int dim>
  typename LoadHistory<dim>::PathPoint *
  LoadPath<dim>::guess_at(const double t)
  {
    for (auto &point : history.path)
      if (std::abs(point.t - t) <= 1e-12 * scene.end_time &&
          point.displacement.size() == model->discretization().dof_handler.n_dofs())
        return &point;
    return nullptr;
  }

  template <int dim>
  bool
  LoadPath<dim>::goes_on_at_rest(const typename LoadHistory<dim>::PathPoint &point)
  {
    const auto *previous = guess_at(history.state.committed_t);
    if (!scene.has_friction() || !previous || history.state.committed_contact.empty() ||
        previous->traction.size() != point.traction.size())
      return false;
    LA::Vector change = model->discretization().make_owned_vector(), old = change;
    const auto subtract = [&](const LA::Vector &now, const LA::Vector &before) {
      change = now;
      old    = before;
      change -= old;
    };
    subtract(point.traction, previous->traction);
    if (old.linfty_norm() == 0 || change.linfty_norm() > 1e-8 * old.linfty_norm())
      return false;
    subtract(point.displacement, previous->displacement);
    old = history.state.displacement;
    old += change;
    history.state.displacement = old;
    model->move_to(history.state);
    return true;
  }

  template <int dim>
  bool
  LoadPath<dim>::forget_guess(const double t)
  {
    auto *point = guess_at(t);
    if (point != nullptr)
      point->displacement = LA::Vector();
    return point != nullptr;
  }

  template <int dim>
  bool
  LoadPath<dim>::must_stop()
  {
    // What is known already takes no time, and an earlier stop would leave less than there was.
    return !control.checkpoint.is_replaying() && control.stop.look(model->mesh->geometry.communicator);
  }

  // At state.t on the present mesh.
  template <int dim>
  NewtonReport
  LoadPath<dim>::iterate(const typename Newton<dim>::Observer &observer)
  {
    if (history.state.displacement.size() != model->discretization().dof_handler.n_dofs())
      history.state.displacement = model->discretization().make_relevant_vector();
    const auto                  mechanics = model->mechanics(history.state);
    std::optional<NewtonReport> result;
    if (!control.stop.is_there()) // else this solve is not on the way that a resumed run takes
      result = control.checkpoint.recall(model->discretization(), model->interfaces, history.state);
    if (result && !mechanics->is_linear())
      {
        model->move_to(history.state);
        mechanics->evaluate(history.state.displacement, {}, false);
      }
    else if (!result)
      result = solve(*mechanics, observer);
    if (!mechanics->is_linear())
      model->update_loads(history.state);
    return *result;
  }

  template <int dim>
  NewtonReport
  LoadPath<dim>::solve(Mechanics<dim> &mechanics, const typename Newton<dim>::Observer &observer)
  {
    bool                     given_up = false;
    const ContactSolver<dim> solver   = {
          parameters.newton,
          parameters.linear_solver,
          model->discretization(),
          timer,
          [&]() { return given_up = given_up || control.gives_up(model->mesh->geometry.communicator); },
          model->kept_system.get()};
    const auto save_if_urgent = [&](const NewtonReport::Iteration &iteration) {
      observer(iteration);
      if (StopRequest::is_urgent()) // whoever sends signals may not wait for the end of the increment
        control.try_to([&]() { control.checkpoint.flush(); });
    };
    auto report =
        solver.solve(mechanics,
                     model->interfaces,
                     model->supports,
                     history.state,
                     save_if_urgent,
                     history.follow_motion ? FollowMotion::from_start : FollowMotion::from_unstable);
    if (given_up) // whatever it had found by then
      {
        report.converged = false;
        report.failure   = Failure{Failure::Kind::given_up};
      }
    if (report.converged && !control.stop.is_there())
      {
        TimerOutput::Scope scope(timer, "output");
        control.try_to([&]() {
          control.checkpoint.keep(model->discretization(), model->interfaces, history.state, report);
        });
      }
    return report;
  }

  template <int dim>
  void
  LoadPath<dim>::check_bounds() const
  {
    for (unsigned int i = 0; i < model->interfaces.size(); ++i)
      for (unsigned int k = 0; k < history.state.contact[i].size(); ++k)
        if (const auto &node = history.state.contact[i][k]; node.state != ContactStatus::open)
          refuse_negative_bound(*model->interfaces[i].pair,
                                as_3d(model->interfaces[i].slave->nodes[k].X),
                                history.state.t,
                                std::max(0., node.pressure));
  }

  // The increment becomes history.
  template <int dim>
  void
  LoadPath<dim>::commit(const LoadProgram &program)
  {
    check_bounds();
    if (program.is_incremental())
      history.work.add(answer());
    history.record.times.push_back(program.time());
    history.record.n_increments += program.is_beginning() ? 0 : 1;
    history.record.n_of_few += program.is_of_few() ? 1 : 0;
    history.record.largest_work = history.work.largest_work;
    for (const auto &fields : evaluation.fields)
      history.record.largest_force =
          std::max(history.record.largest_force, (fields.normal_force + fields.tangential_force).norm());
    if (note_closed(model->interfaces, history.state, history.record.closed))
      history.record.closing.push_back({{history.state.committed_t, program.time()}});
    if (!program.is_at_breakpoint())
      return;
    history.record.breakpoints.push_back(
        {record_pairs(model->interfaces, evaluation.fields, history.state, history.record.closed),
         history.work.dissipation,
         program.time()});
    history.record.closed.clear();
  }

  // Where the load path turns, slip stops: the first guess is stick.
  template <int dim>
  void
  LoadPath<dim>::begin_next(const LoadProgram &program)
  {
    auto &was_open = history.state.was_open;
    was_open.resize(model->interfaces.size());
    for (unsigned int i = 0; i < was_open.size(); ++i)
      {
        was_open[i].resize(history.state.contact[i].size(), false);
        for (unsigned int n = 0; n < was_open[i].size(); ++n)
          was_open[i][n] = was_open[i][n] || history.state.contact[i][n].state == ContactStatus::open;
      }
    history.state.before_earlier = program.at_corner() ? LA::Vector() : history.state.earlier;
    history.state.earlier        = LA::Vector();
    history.state.earlier_t      = history.state.committed_t;
    if (!program.at_corner() && history.state.committed.size() == history.state.displacement.size())
      history.state.earlier = history.state.committed;
    else if (!program.at_corner())
      history.state.earlier.reinit(history.state.displacement);
    before   = program.at_corner() ? std::vector<NodalContacts<dim>>() : history.state.committed_contact;
    before_t = history.state.committed_t;
    history.state.committed         = history.state.displacement;
    history.state.committed_t       = history.state.t;
    history.state.committed_contact = history.state.contact;
    history.last_converged          = history.state;
    if (program.at_corner())
      stick_first();
  }

  template <int dim>
  void
  LoadPath<dim>::stick_first()
  {
    for (unsigned int i = 0; i < history.state.contact.size(); ++i)
      for (auto &node : history.state.contact[i])
        if (model->interfaces[i].pair->has_friction() && node.state == ContactStatus::slip)
          node.state = ContactStatus::stick;
  }

  template <int dim>
  std::optional<LoadRecord>
  LoadPath<dim>::repeat(LoadProgram program, const bool is_guided)
  {
    TimerOutput::Scope scope(timer, "error of the increments");
    LoadPath<dim>      repeat(parameters, model->at_rest(program.next()), timer, control);
    if (is_guided) // first guesses for both
      repeat.history.path.swap(history.path);
    const bool success = repeat.run(program, is_guided ? std::max(2u, history.record.n_increments / 20) : 0);
    if (is_guided)
      repeat.history.path.swap(history.path);
    if (!success || repeat.history.record.n_increments == history.record.n_increments)
      return {};
    return repeat.history.record;
  }

  // As a field, which outlives the mesh; and the states that it tells on the present one.
  template <int dim>
  void
  LoadPath<dim>::store_contact()
  {
    make_traction_field(model->discretization(), model->interfaces, evaluation.fields, history.state);
  }

  template <int dim>
  void
  LoadPath<dim>::restore_contact()
  {
    carry_active_set(model->interfaces, history.state);
  }

  template class LoadPath<2>;
  template class LoadPath<3>;
} // namespace Amontons

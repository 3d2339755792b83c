#include <amontons/solver/diagnosis.h>
#include <amontons/solver/newton.h>
#include <amontons/solver/newton_residual.h>

#include <sstream>

namespace Amontons
{
  template <int dim>
  Newton<dim>::Newton(const ContactEquilibrium<dim> &problem,
                      NewtonStep<dim>               &step,
                      const double                   smallest_cell,
                      const Observer                &observer)
      : problem(problem), step(step), smallest_cell(smallest_cell), observer(observer),
        statuses(problem, step, smallest_cell),
        floating(problem.discretization,
                 problem.supports,
                 problem.interfaces,
                 problem.contact.moves() ? &problem.state.displacement : nullptr),
        at{problem.discretization.make_owned_vector(),
           NodeStates<dim>(problem.contact.nodes(), problem.interfaces, floating, problem.state.t)}
  {
    at.answers.resize(problem.contact.nodes().size());
    at.u = problem.state.displacement;
  }

  template <int dim>
  bool
  Newton<dim>::prepare()
  {
    auto &u = problem.state.displacement;
    if (!problem.contact.moves()) // else the first step does it, and the bodies follow
      distribute(problem.supports, at.u, u);
    start_distance = u.linfty_norm();
    problem.contact.move(u);
    {
      TimerOutput::Scope scope(problem.timer, "assemble stiffness");
      if (const auto inverted = problem.mechanics.start(u))
        {
          at.report.failure = Diagnosis::inverted(problem.discretization, *inverted);
          return false;
        }
    }
    const auto equations = holding_equations(problem.contact.nodes());
    floating.set_loads(problem.mechanics.loads());
    try
      {
        at.report.note = floating.check_loads(equations);
      }
    catch (const InputError &) // later than at rest it is no fault of the input
      {
        if (!problem.contact.moves() || u.linfty_norm() == 0)
          throw;
        at.report.failure = Diagnosis::moves_apart(at.states, floating.free_rigid_modes(equations));
        return false;
      }
    floating.choose_pins(equations);
    guess_states();
    for (unsigned int k = 0; k < at.answers.size(); ++k) // for the first tangent
      if (const auto *known =
              problem.state.contact_of(problem.contact.nodes()[k].interface, problem.contact.nodes()[k].node);
          known != nullptr && at.states[k] != ContactStatus::open)
        {
          at.answers[k].pressure = known->pressure;
          at.answers[k].shear    = known->shear;
        }
    stabilisation = stabilise_rigid_modes(problem.discretization, problem.mechanics.bodies(), floating);
    step.prepare(floating.any() ? &stabilisation.springs : nullptr);
    return true;
  }

  template <int dim>
  void
  Newton<dim>::guess_states()
  {
    // Where a surface turns away from the other, projected gaps change their sign: far nodes are open.
    const auto         &nodes = problem.contact.nodes();
    const auto         &u     = problem.state.displacement;
    std::vector<double> gaps, nearest(problem.interfaces.size(), std::numeric_limits<double>::max());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        at.states.open(k);
        nearest[nodes[k].interface] = std::min(nearest[nodes[k].interface], problem.contact.open_gap(k, u));
      }
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int i    = nodes[k].interface;
        const double       open = problem.contact.open_gap(k, u);
        gaps.push_back(
            open > nearest[i] + problem.interfaces[i].slave->mean_size ? open : problem.contact.gap(k, u));
      }
    at.states.start(problem.state,
                    first_guess_of_closed_nodes(problem.contact.nodes(), problem.interfaces, floating, gaps));
    open_lonely_nodes();
  }

  template <int dim>
  void
  Newton<dim>::guess_again(const NodalContacts<dim> &answers)
  {
    guess_states();
    at.answers = answers;
  }

  template <int dim>
  void
  Newton<dim>::open_lonely_nodes()
  {
    for (unsigned int k = 0; k < at.answers.size(); ++k)
      if (at.states[k] != ContactStatus::open && !problem.contact.is_opposite(k))
        at.states.open(k);
  }

  template <int dim>
  bool
  Newton<dim>::put(const LA::Vector &where)
  {
    at.u                       = where;
    problem.state.displacement = at.u;
    if (!evaluate())
      return false;
    problem.contact.move(problem.state.displacement);
    open_lonely_nodes();
    return true;
  }

  // At the state's displacement; dilatations: empty for those of the displacement.
  template <int dim>
  bool
  Newton<dim>::evaluate(const std::vector<double> &dilatations, const bool with_stiffness)
  {
    TimerOutput::Scope scope(problem.timer,
                             problem.mechanics.is_linear() ? "internal forces" : "assemble stiffness");
    const auto inverted = problem.mechanics.evaluate(problem.state.displacement, dilatations, with_stiffness);
    if (inverted)
      inversion = Diagnosis::inverted(problem.discretization, *inverted);
    return !inverted;
  }

  template <int dim>
  void
  Newton<dim>::iterate()
  {
    //! [newton]
    const auto most = at.report.iterations.size() + problem.parameters.max_iterations;
    while (at.report.iterations.size() < most)
      {
        if (!turn())
          return;
        stop_or_go_on();
        if (!at.report.goes_on())
          return;
      }
    //! [newton]
  }

  //! [turn]
  template <int dim>
  bool
  Newton<dim>::turn(const unsigned int                                                   n_tries,
                    const std::function<bool(const typename NewtonStep<dim>::Solved &)> &try_it,
                    const std::function<bool()>                                         &stay)
  {
    linearise();
    const auto solved = solve();
    if (!solved || (try_it && !try_it(*solved)) || !advance(solved->change, n_tries) || (stay && !stay()))
      return false;
    last_change = solved->change;
    NewtonReport::Iteration line{};
    line.krylov = solved->linear.iterations;
    recover_contact();
    count_states(problem, at.states, line);
    line.residual = residual();
    update_states(line);
    if (at.states.exhausted() && settle())
      line.n_changes = std::max(1u, line.n_changes);
    at.report.iterations.push_back(line);
    observer(line);
    return true;
  }
  //! [turn]

  // Small strain: loads carry off what weak springs alone hold, through all that is in the way; only as far
  // as the first nodes that touch, which are closed then.
  template <int dim>
  void
  Newton<dim>::shorten_flight(LA::Vector &change)
  {
    flight.reset();
    if (!problem.mechanics.is_linear() || at.is_first() || at.free_modes.empty())
      return;
    flight = flight_to_contact(problem, at, change);
    if (flight)
      change *= flight->part;
  }

  template <int dim>
  void
  Newton<dim>::update_states(NewtonReport::Iteration &line)
  {
    if (!flight)
      return statuses.update(at, line, drag != nullptr);
    for (const unsigned int k : flight->nodes)
      at.states.close(k);
    line.n_changes = flight->nodes.size();
  }

  template <int dim>
  void
  Newton<dim>::linearise()
  {
    if (!at.set_changed() && !problem.contact.any_friction() && !problem.contact.moves())
      return; // the same system again
    at.laws.clear();
    for (unsigned int k = 0; k < at.answers.size(); ++k)
      at.laws.push_back(at.states.law(k));
    update_constraints();
    at.free_modes = at.states.free_rigid_modes();
    if (!at.free_modes.empty())
      springs = stabilisation.springs_on(floating.moved_by(at.free_modes), floating);
    step.linearise(at,
                   !at.free_modes.empty() ? &springs
                   : !pins().empty()      ? &stabilisation.pins
                                          : nullptr,
                   drag);
  }

  template <int dim>
  void
  Newton<dim>::update_constraints()
  {
    at.constraints = std::make_shared<ContactConstraints>(
        constraints_of(problem, step.supports(), at.states, &at.first_equation));
  }

  template <int dim>
  std::optional<typename NewtonStep<dim>::Solved>
  Newton<dim>::solve()
  {
    auto solved = step.solve(at, drag);
    if (const auto &linear = solved.linear; !linear.success)
      {
        at.report.failure = Failure{linear.given_up    ? Failure::Kind::given_up
                                    : linear.no_memory ? Failure::Kind::no_memory
                                                       : Failure::Kind::linear_solver,
                                    linear.iterations};
        return {};
      }
    if (at.is_first())
      {
        at.report.one_linear_solve_seconds = clock.wall_time();
        at.report.start_residual           = solved.push.l2_norm();
        push                               = solved.push;
      }
    shorten_flight(solved.change);
    return solved;
  }

  template <int dim>
  bool
  Newton<dim>::advance(const LA::Vector &change, const unsigned int n_tries)
  {
    if (!std::isfinite(change.l2_norm()))
      {
        at.report.failure = Failure{Failure::Kind::not_a_number};
        return false;
      }
    const LA::Vector start(at.u);
    LA::Vector       relevant = problem.discretization.make_relevant_vector();
    relevant                  = change;
    const auto dilatations    = problem.mechanics.change_of_dilatations(relevant);
    const bool with_stiffness = drag != nullptr || change.linfty_norm() > 1e-3 * smallest_cell;
    double     factor         = 1;
    for (unsigned int n = 0; n < n_tries; ++n, factor /= 2)
      {
        at.u = start;
        at.u.add(factor, change);
        problem.state.displacement = at.u;
        if (evaluate(dilatations.after(factor), with_stiffness))
          {
            TimerOutput::Scope scope(problem.timer, "contact surfaces");
            problem.contact.move(problem.state.displacement);
            open_lonely_nodes();
            for (unsigned int k = 0; problem.contact.moves() && k < at.answers.size(); ++k)
              if (at.states[k] == ContactStatus::slip && problem.contact.nodes()[k].frictional)
                {
                  at.states.turn(k);
                  at.laws[k] = at.states.law(k);
                }
            return true;
          }
      }
    at.u                       = start;
    problem.state.displacement = at.u;
    at.report.failure          = inversion;
    return false;
  }

  template <int dim>
  LA::Vector
  Newton<dim>::balance_with_drag() const
  {
    LA::Vector result(balance);
    if (drag != nullptr)
      result += drag->force(at.u);
    return result;
  }

  // Multipliers from the residual at the pivots, where the surfaces are now; gaps of the open nodes.
  template <int dim>
  void
  Newton<dim>::recover_contact()
  {
    if (problem.contact.moves())
      update_constraints();
    balance = problem.mechanics.unbalanced();
    if (problem.contact.any_friction() || problem.penalty != nullptr)
      balance -= known_contact_forces(problem, at);
    at.answers = nodal_answers(problem, at, step.supports(), balance_with_drag());
  }

  // In effect: where springs hold all motions that the present equations leave free, pins are not needed.
  template <int dim>
  std::vector<types::global_dof_index>
  Newton<dim>::pins() const
  {
    return at.free_modes.empty() ? floating.pins() : std::vector<types::global_dof_index>();
  }

  // Of equilibrium, relative to the forces, and of the closed nodes' equations, relative to the faces.
  template <int dim>
  double
  Newton<dim>::residual()
  {
    at.force_scale =
        problem.mechanics.force_scale(what_rounding_sees(problem, at), problem.parameters.tolerance);
    return std::max({relative_residual(problem, at, balance, pins()),
                     largest_violation(problem, at),
                     relative_excess(problem, at)});
  }

  template <int dim>
  double
  Newton<dim>::error_with_drag() const
  {
    return relative_residual(problem, at, balance_with_drag(), pins());
  }

  template <int dim>
  void
  Newton<dim>::stop_or_go_on()
  {
    const auto &last  = at.report.iterations.back();
    const bool  stays = !at.set_changed(), rests = stays && last.residual <= problem.parameters.tolerance,
               is_linear = problem.mechanics.is_linear();
    auto &failure        = at.report.failure;
    if (!std::isfinite(last.residual))
      failure = Failure{Failure::Kind::not_a_number};
    else if (const auto far = flown())
      failure = Failure{Failure::Kind::flown, 0, *far};
    else if (rests && at.states.n_held_beyond_friction() == 0)
      at.report.converged = true;
    else if (drag == nullptr && at.free_modes.empty() && at.states.n_held_beyond_friction() == 0 &&
             !at.states.frozen() && at.report.has_stalled(std::min(1e3 * problem.parameters.tolerance, 1e-6)))
      {
        std::ostringstream text;
        // (A power of ten: else each increment would say it anew.)
        text << "the residual stays below " << std::pow(10, std::ceil(std::log10(last.residual)))
             << " of the forces where " << problem.parameters.tolerance
             << " is asked for: rounding leaves no more";
        at.report.add_note(text.str());
        at.report.converged = true;
      }
    else if (rests || (is_linear && stays && at.states.n_held_beyond_friction() > 0))
      {
        if (settle())
          at.report.iterations.back().n_changes = 1;
        else
          failure = Diagnosis::friction_exceeded(at.states);
      }
    else if (stays && moves_apart() && !reach_contact())
      failure = Diagnosis::moves_apart(at.states, at.free_modes);
    else if (is_linear && at.report.iterations.size() == 1)
      failure = Diagnosis::friction_beyond_limit(at.states);
    else if (drag == nullptr && !is_linear && at.report.stagnates(problem.parameters.tolerance))
      failure = Diagnosis::no_states_found(at.report, at.states, problem.contact.any_friction());
  }

  // Once: where all else has failed, or will.
  template <int dim>
  bool
  Newton<dim>::settle()
  {
    if (!may_settle)
      return false;
    may_settle = false;
    LA::Vector springs;
    if (floating.any())
      {
        springs = stabilisation.springs;
        springs *= 1e3; // else the motions that they leave are so large that nothing is left of the strains
      }
    at.report.pivoted = step.settle(at, floating.any() ? &springs : nullptr);
    return at.report.pivoted;
  }

  // Small strain: weak springs are all that holds a motion, and they are not coming to rest. In the first
  // solution of a set they resist what its nodes have let go.
  template <int dim>
  bool
  Newton<dim>::moves_apart() const
  {
    const auto        &lines = at.report.iterations;
    const unsigned int n     = lines.size();
    return problem.mechanics.is_linear() && n > 1 && !at.free_modes.empty() && lines[n - 2].n_changes == 0 &&
           lines[n - 1].residual > 0.5 * lines[n - 2].residual;
  }

  // Finite strain: how many times their size, if that is far beyond what any increment does and supports
  // prescribe.
  template <int dim>
  std::optional<double>
  Newton<dim>::flown() const
  {
    constexpr double far   = 1e4;
    const auto      &sizes = problem.discretization.geometry.body_sizes;
    const double     size = *std::max_element(sizes.begin(), sizes.end()), moved = at.u.linfty_norm();
    if (problem.mechanics.is_linear() || moved < far * size)
      return {};
    double prescribed = 0;
    for (const auto &line : problem.supports.get_lines())
      prescribed = std::max(prescribed, std::abs(line.inhomogeneity));
    prescribed = Utilities::MPI::max(prescribed, problem.discretization.geometry.communicator);
    return moved < 10 * std::max(start_distance, prescribed) ? std::optional<double>() : moved / size;
  }

  template <int dim>
  bool
  Newton<dim>::reach_contact()
  {
    const auto turns = turns_to_contact(problem, at, last_change);
    if (!turns)
      return false;
    at.u.add(*turns, last_change);
    problem.state.displacement            = at.u;
    at.report.iterations.back().n_changes = 1;
    return evaluate();
  }

  template <int dim>
  NewtonReport
  Newton<dim>::finish()
  {
    at.report.start_residual = at.force_scale > 0 ? at.report.start_residual / at.force_scale : 0;
    for (unsigned int k = 0; k < at.answers.size(); ++k)
      if (at.states[k] != ContactStatus::open && !problem.by_equations(k))
        at.answers[k].gap = problem.contact.gap(k, problem.state.displacement);
    problem.state.contact = at.states.by_slave_node(at.answers);
    if (at.report.goes_on())
      at.report.failure = Diagnosis::no_states_found(at.report, at.states, problem.contact.any_friction());
    return at.report;
  }

  template class Newton<2>;
  template class Newton<3>;
} // namespace Amontons

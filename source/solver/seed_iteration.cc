#include <amontons/solver/seed_iteration.h>

namespace Amontons
{
  template <int dim>
  NewtonReport
  SeedIteration<dim>::run()
  {
    if (!newton.prepare())
      return newton.report();
    start();
    newton.status_update().set_rule([this](auto &states, const auto &answers, const double rounding) {
      return update(states, answers, rounding);
    });
    auto &report = newton.report();
    while (report.goes_on() && report.iterations.size() < problem.parameters.max_iterations)
      if (newton.turn())
        stop_or_go_on();
    if (report.goes_on())
      {
        report.failure            = Failure{Failure::Kind::seed_unsettled,
                                 static_cast<unsigned int>(report.iterations.size()),
                                 change / newton.now().force_scale};
        report.failure->n_changes = report.iterations.back().n_changes;
      }
    return newton.finish();
  }

  // The previous increment's states, directions of slip and forces of friction.
  template <int dim>
  void
  SeedIteration<dim>::start()
  {
    const auto &now = newton.now();
    for (unsigned int k = 0; k < now.answers.size(); ++k)
      if (problem.contact.nodes()[k].frictional && now.states[k] == ContactStatus::slip)
        {
          SlipLaw<dim> law;
          law.direction = now.states.law(k).direction;
          law.constant  = bound(k, now.answers[k].pressure);
          newton.states().impose(k, ContactStatus::slip, law);
        }
  }

  template <int dim>
  double
  SeedIteration<dim>::bound(const unsigned int k, const double pressure) const
  {
    const auto &node = problem.contact.nodes()[k];
    return shear_bound(*problem.interfaces[node.interface].pair, node.X, problem.state.t, pressure).value;
  }

  // Rules (a), (b) and (c.1).
  template <int dim>
  ContactStatus
  SeedIteration<dim>::next_state(const unsigned int       k,
                                 const ContactStatus      state,
                                 const NodalContact<dim> &answer) const
  {
    const auto &node = problem.contact.nodes()[k];
    if (node.tied)
      return ContactStatus::stick;
    if (state == ContactStatus::open && node.c * answer.gap >= -tolerance)
      return ContactStatus::open;
    if (state == ContactStatus::open)
      return node.frictional ? ContactStatus::stick : ContactStatus::slip;
    if (answer.pressure < -tolerance)
      return ContactStatus::open;
    return state == ContactStatus::stick && answer.shear.norm() > bound(k, answer.pressure) + tolerance
               ? ContactStatus::slip
               : state;
  }

  // Rule (c.2) for the forces of the next iteration: q = mu p d with p of this one, d of the traction that
  // stick could not bear.
  template <int dim>
  unsigned int
  SeedIteration<dim>::update(NodeStates<dim>          &states,
                             const NodalContacts<dim> &answers,
                             const double              rounding)
  {
    const auto  &nodes   = problem.contact.nodes();
    double       largest = 0, sum = 0;
    unsigned int n_changes = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (!nodes[k].tied)
        largest = std::max(largest, std::abs(answers[k].pressure));
    tolerance = std::max(1e-9 * largest, rounding);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const auto   old = states[k], next = next_state(k, old, answers[k]);
        SlipLaw<dim> law;
        if (nodes[k].frictional && next == ContactStatus::slip)
          {
            const auto q  = answers[k].shear;
            law.direction = old == ContactStatus::slip ? states.law(k).direction : q / q.norm();
            law.constant  = bound(k, answers[k].pressure);
            sum += std::pow(nodes[k].area, 2) * (law.constant * law.direction - q).norm_square();
          }
        states.impose(k, next, law);
        n_changes += next != old;
      }
    change = std::sqrt(sum);
    return n_changes;
  }

  template <int dim>
  void
  SeedIteration<dim>::stop_or_go_on()
  {
    const auto &now    = newton.now();
    auto       &report = newton.report();
    if (!std::isfinite(change) || !std::isfinite(now.force_scale))
      report.failure = Failure{Failure::Kind::not_a_number};
    if (report.iterations.back().n_changes > 0 || change > problem.parameters.tolerance * now.force_scale)
      return;
    if (!now.free_modes.empty())
      {
        report.failure         = Failure{Failure::Kind::seed_unsettled};
        report.failure->motion = now.states.describe(now.free_modes);
        return;
      }
    report.converged         = true;
    unsigned int n_backwards = 0;
    for (unsigned int k = 0; k < now.answers.size(); ++k)
      if (problem.contact.nodes()[k].frictional && now.states[k] == ContactStatus::slip &&
          problem.contact.nodes()[k].c * (now.answers[k].slip * now.states.law(k).direction) < -tolerance)
        ++n_backwards;
    if (n_backwards > 0)
      report.add_note(
          std::to_string(n_backwards) +
          " nodes slip against their friction: the seed's rules let no slipping node stick again");
  }

  template class SeedIteration<2>;
  template class SeedIteration<3>;
} // namespace Amontons

#include <amontons/solver/status_update.h>

namespace Amontons
{
  template <int dim>
  StatusUpdate<dim>::StatusUpdate(const ContactEquilibrium<dim> &problem,
                                  NewtonStep<dim>               &step,
                                  const double                   smallest_cell)
      : problem(problem), step(step), smallest_cell(smallest_cell)
  {
  }

  // Far from equilibrium, what would only take back the last change is not believed: near the edge of the
  // contact a node may pull when closed and penetrate when open, until the others have followed.
  template <int dim>
  void
  StatusUpdate<dim>::update(Iterate<dim> &now, NewtonReport::Iteration &line, const bool damped)
  {
    const double rounding = rounding_of_pressures(problem.contact.nodes(), now.u.linfty_norm());
    if (rule)
      {
        line.n_changes = rule(now.states, now.answers, rounding);
        return;
      }
    const bool is_far = !damped && !problem.mechanics.is_linear() && line.residual > 1e-3,
               waits  = is_far && n_waits < 6 && takes_back_the_last_change(now, rounding);
    n_waits           = waits ? n_waits + 1 : 0;
    if (waits)
      return;
    previous = now.states.all();
    Neutral neutral;
    if (const double tolerance = problem.parameters.tolerance; line.residual <= tolerance)
      // (Of all forces a small part may be a large one of a node's.)
      neutral = {std::min(tolerance, 1e-8) * now.force_scale,
                 tolerance * std::min(now.u.linfty_norm(), smallest_cell)};
    line.n_changes = now.states.update(now.answers, rounding, neutral);
    if (line.n_changes > 0)
      look_ahead(now, line, rounding);
    now.report.safeguarded = now.report.safeguarded || now.states.safeguarded();
    now.report.frozen      = now.report.frozen || now.states.frozen();
  }

  template <int dim>
  bool
  StatusUpdate<dim>::takes_back_the_last_change(const Iterate<dim> &now, const double rounding) const
  {
    if (previous.empty())
      return false;
    NodeStates<dim> next(now.states);
    return next.update(now.answers, rounding) > 0 && next.all() == previous;
  }

  // As far as the contact nodes alone can tell.
  template <int dim>
  void
  StatusUpdate<dim>::look_ahead(Iterate<dim> &now, NewtonReport::Iteration &line, const double rounding)
  {
    const unsigned int n = step.look_ahead(now, previous, rounding);
    if (n == 0)
      return;
    unsigned int n_changes = 0;
    for (unsigned int k = 0; k < previous.size(); ++k)
      n_changes += now.states[k] != previous[k];
    line.krylov += n;
    line.n_changes = std::max(1u, n_changes);
  }

  template class StatusUpdate<2>;
  template class StatusUpdate<3>;
} // namespace Amontons

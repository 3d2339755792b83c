/// Which nodes open, close, stick or slip after a solve, and when it is too early to believe that.
#pragma once

#include <amontons/solver/newton_step.h>

namespace Amontons
{
  template <int dim>
  class StatusUpdate
  {
  public:
    /// What may change the states instead of NodeStates::update; returns how many changed.
    using Rule = std::function<unsigned int(
        NodeStates<dim> &, const NodalContacts<dim> &answers, const double rounding)>;

    StatusUpdate(const ContactEquilibrium<dim> &problem, NewtonStep<dim> &step, const double smallest_cell);

    void
    set_rule(const Rule &new_rule)
    {
      rule = new_rule;
    }

    /// After the solve of this line, which gets the number of changes. damped: with drag.
    void
    update(Iterate<dim> &now, NewtonReport::Iteration &line, const bool damped);

  private:
    bool
    takes_back_the_last_change(const Iterate<dim> &now, const double rounding) const;
    void
    look_ahead(Iterate<dim> &now, NewtonReport::Iteration &line, const double rounding);

    const ContactEquilibrium<dim> &problem;
    NewtonStep<dim>               &step;
    const double                   smallest_cell;
    Rule                           rule;
    std::vector<ContactStatus>     previous; // before the last change
    unsigned int                   n_waits = 0;
  };
} // namespace Amontons

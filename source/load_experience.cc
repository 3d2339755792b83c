// LoadStepping: what a run leaves to another one.
#include <amontons/load_stepping.h>

namespace Amontons
{
  template <int dim>
  typename LoadStepping<dim>::Experience
  LoadStepping<dim>::take_experience()
  {
    history.quantity.repeat();
    return {std::move(history.path),
            history.growing,
            history.coarser.pressure,
            history.coarser.shear,
            history.quantity,
            evaluation.refined,
            increments,
            measurement,
            report.error_of_increments()};
  }

  template <int dim>
  void
  LoadStepping<dim>::go_on_from(Experience &&others)
  {
    if (!history.at_once)
      history.path = std::move(others.path);
    history.growing          = others.growing;
    history.coarser.pressure = others.pressure;
    history.coarser.shear    = others.shear;
    history.quantity         = std::move(others.quantity);
    evaluation.refined       = others.refined;
    increments.take_lengths(others.increments);
    measurement = std::move(others.measurement);
    if (others.errors)
      report.set_error_of_increments(*others.errors);
  }

  template LoadStepping<2>::Experience
  LoadStepping<2>::take_experience();
  template LoadStepping<3>::Experience
  LoadStepping<3>::take_experience();
  template void
  LoadStepping<2>::go_on_from(Experience &&);
  template void
  LoadStepping<3>::go_on_from(Experience &&);
} // namespace Amontons

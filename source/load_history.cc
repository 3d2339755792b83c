#include <amontons/load_history.h>

namespace Amontons
{
  template <int dim>
  std::vector<LA::Vector *>
  LoadHistory<dim>::fields()
  {
    std::vector<LA::Vector *> all;
    for (auto *const known : {&state, &last_converged})
      for (auto *const field : {&known->displacement,
                                &known->traction,
                                &known->committed,
                                &known->earlier,
                                &known->before_earlier})
        all.push_back(field);
    all.push_back(&coarser.traction);
    for (auto &point : path)
      for (auto *const field : {&point.displacement, &point.traction})
        all.push_back(field);
    return all;
  }

  template <int dim>
  bool
  LoadHistory<dim>::snapped(const double duration, LA::Vector owned)
  {
    LA::Vector moved(owned);
    moved = state.displacement;
    if (state.committed.size() == state.displacement.size())
      owned = state.committed;
    moved -= owned;
    const double distance = moved.linfty_norm(), expected = last_speed * duration;
    if (last_report.moved)
      snaps.push_back({state.t, distance, distance > 3 * expected, last_report.unstable});
    else
      last_speed = distance / duration;
    return last_report.moved;
  }

  template <int dim>
  void
  LoadHistory<dim>::restart(const double t)
  {
    work.restart();
    record = LoadRecord();
    snaps.clear();
    state.committed   = LA::Vector();
    state.committed_t = t;
    state.committed_contact.clear();
    state.earlier        = LA::Vector();
    state.before_earlier = LA::Vector();
    state.was_open.clear();
    last_converged = SolutionState<dim>();
  }

  template struct LoadHistory<2>;
  template struct LoadHistory<3>;
} // namespace Amontons

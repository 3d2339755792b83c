// LoadStepping: where a load program goes back to, or ends, that fails or is stopped.
#include <amontons/base/points.h>
#include <amontons/friction/shear_law.h>
#include <amontons/load_stepping.h>

#include <sstream>

namespace Amontons
{
  template <int dim>
  void
  LoadStepping<dim>::roll_back()
  {
    std::ostringstream text;
    text << "increments were cut back first before t = " << history.state.t << ": " << report.message();
    if (history.n_cut_backs++ == 0)
      report.note(text.str());
    report.drop_last_solve();
    go_back();
  }

  // What is written and reported is the last increment that converged; the message says how the next one
  // failed.
  template <int dim>
  void
  LoadStepping<dim>::return_to_last_converged()
  {
    const double failed_time = history.state.t;
    report.drop_last_solve();
    const bool is_transferred = history.last_converged.contact.empty();
    go_back();
    const double t = history.state.t;
    set_time(t);
    if (is_transferred)
      iterate(report.observer());
    model->update_loads(history.state);
    evaluation.collect_fields(*model, history.state);
    evaluation.recovery->recover(history.state.displacement);
    ended_early = true;
    std::ostringstream text;
    text << "the increment from t = " << t << " to " << failed_time << " failed: " << report.message();
    report.fail(text.str());
  }

  template <int dim>
  void
  LoadStepping<dim>::end_early(const Result why, const LoadProgram &program)
  {
    if (why == Result::stopped)
      return_to_last_known();
    else if (why == Result::failed && program.number() > 1)
      return_to_last_converged();
  }

  // Stopped while it solves. What is written and reported is the last state that converged; that of another
  // mesh is carried to this one.
  template <int dim>
  void
  LoadStepping<dim>::return_to_last_known()
  {
    falls_back = history.fallback.displacement.size() > 0;
    if (falls_back)
      {
        history.state = history.fallback;
        set_time(history.state.t);
        model->move_to(history.state);
        if (is_carried())
          {
            restore_shears();
            evaluation.error = ErrorEstimate<dim>(); // that of the mesh before is in its row
            evaluation.error.cell_indicators.reinit(
                model->discretization().geometry.triangulation.n_active_cells());
          }
      }
    else if (history.last_converged.displacement.size() > 0)
      go_back();
    else
      return;
    set_time(history.state.t);
    if (model->finite_strain()) // stresses are those of the place that was evaluated last
      model->mechanics(history.state)->evaluate(history.state.displacement, {}, false);
    model->update_loads(history.state);
    evaluation.collect_fields(*model, history.state);
    if (!evaluation.recovery)
      evaluation.recovery = std::make_unique<StressRecovery<dim>>(model->discretization(), model->elasticity);
    evaluation.recovery->recover(history.state.displacement);
    if (falls_back)
      report.show(answer(), evaluation);
  }

  // From the field of tractions, which knows them over their bounds.
  template <int dim>
  void
  LoadStepping<dim>::restore_shears()
  {
    for (unsigned int i = 0; i < model->interfaces.size(); ++i)
      for (unsigned int k = 0; k < history.state.contact[i].size(); ++k)
        if (auto &node = history.state.contact[i][k];
            node.state != ContactStatus::open && model->interfaces[i].pair->has_friction())
          {
            const auto   X = as_3d(model->interfaces[i].slave->nodes[k].X);
            const double bound =
                shear_bound(*model->interfaces[i].pair, X, history.state.t, node.pressure).value;
            node.shear = bound / std::max(1., node.trial.norm()) * node.trial;
          }
  }

  template void
  LoadStepping<2>::roll_back();
  template void
  LoadStepping<3>::roll_back();
  template void
  LoadStepping<2>::end_early(const Result, const LoadProgram &);
  template void
  LoadStepping<3>::end_early(const Result, const LoadProgram &);
} // namespace Amontons

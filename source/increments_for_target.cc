// LoadStepping: how wrong the increments are, and which ones are taken.
#include <amontons/adaptivity/load_record.h>
#include <amontons/load_stepping.h>

#include <sstream>

namespace Amontons
{
  // Their error is measured on the first mesh that sees slip. It may be too large by far there (rings that
  // are no wider than cells: 22 % where it was 1.5 %), so that it is measured again where nothing else stands
  // between the answer and the target.
  template <int dim>
  bool
  LoadStepping<dim>::increments_are_due() const
  {
    return measurement ? increments_are_due_again()
                       : sees_slip() || (increments.by_target() && !wants_refinement());
  }

  template <int dim>
  bool
  LoadStepping<dim>::increments_are_due_again() const
  {
    if (measurement->mesh == model->mesh->n_refinements)
      return false;
    if (history.record.closes_beyond(measurement->closing))
      return increments.by_target() || !wants_refinement();
    const double target = parameters.refinement.target_error;
    if (!report.error_of_increments() || target == 0)
      return false;
    return increments.by_target()
               ? increments.wants_more() && (evaluation.error.of_target() <= target || !wants_refinement())
               : report.error_of_increments()->of(parameters.refinement.target_quantity) > target &&
                     !wants_refinement();
  }

  // Measures their error; then others for the target. True: the load program is to be run with them on this
  // mesh, as it is the last one, or to know what of a number changes by them, and what by a finer mesh.
  template <int dim>
  bool
  LoadStepping<dim>::choose_increments()
  {
    const bool again = measurement.has_value();
    if (increments.divide(history.record))
      {
        report.announce("contact grows on finer meshes where few increments were taken: they are divided");
        repeat_on_mesh();
        return true;
      }
    measure_increments();
    if (!increments.by_target() || !report.error_of_increments())
      return false;
    const bool mesh_is_last = !wants_refinement();
    if (again && mesh_is_last && increments.keep(*report.error_of_increments(), evaluation.error.of_target()))
      return false;
    const double before    = increments.lengths().times;
    const auto   try_these = [&](const IncrementLengths &lengths) {
      return repeat(load_program(lengths), false);
    };
    const auto errors =
        increments.choose(*report.error_of_increments(), history.record, mesh_is_last, try_these);
    if (!errors || control.stop.is_there())
      return false;
    report.set_error_of_increments(*errors);
    const bool are_others = increments.lengths().times != before;
    if (are_others) // the errors of meshes so far tell nothing of how they fall with these
      history.meshes.restart();
    if (!again)
      save_increments(before, try_these);
    if (!mesh_is_last && !(evaluation.error.quantity && are_others))
      return false;
    repeat_on_mesh();
    return true;
  }

  template <int dim>
  void
  LoadStepping<dim>::save_increments(const double of_record, const IncrementChoice::Repeat &try_these)
  {
    IncrementErrors change;
    if (!increments.try_fewer_in_pieces(history.record, of_record, try_these, change))
      return;
    report.set_error_of_increments(report.error_of_increments()->with(change));
    std::ostringstream text;
    const auto         lengths = increments.lengths();
    text << "where next to nothing closes, up to t =";
    for (const double end : lengths.few)
      text << (end == lengths.few.front() ? " " : ", ") << end;
    text << ", the load comes in ";
    if (lengths.n_of_each == 1)
      text << "single increments";
    else
      text << lengths.n_of_each << " increments each";
    text.precision(1);
    text << "; more of them change the answer by " << change.largest();
    report.announce(text.str());
  }

  template <int dim>
  bool
  LoadStepping<dim>::sees_slip() const
  {
    return resolves_friction(model->interfaces, history.state) &&
           (parameters.refinement.target_quantity != "stick size" || history.record.resolves_stick());
  }

  // The load program, which has converged on this mesh, once more with half as many increments, where they
  // are few with twice as many; if that fails, with halves of those that converged.
  template <int dim>
  void
  LoadStepping<dim>::measure_increments()
  {
    IncrementLengths lengths = increments.lengths();
    lengths.begins_in_two    = begins_in_two(lengths);
    auto         plan        = load_program(lengths);
    unsigned int n = 0, n_pieces = plan.n_breakpoints() - lengths.few.size();
    while (!plan.finished())
      {
        plan.accept(1);
        n += plan.is_beginning() || plan.is_of_few() ? 0 : 1;
      }
    const bool with_twice = n < 4 * n_pieces;
    lengths.times *= with_twice ? 0.5 : 2;
    lengths.n_of_each = with_twice || lengths.n_of_each == 1 ? 2 * lengths.n_of_each : lengths.n_of_each / 2;

    auto record = repeat(load_program(lengths), true);
    if (!record && !control.stop.is_there())
      {
        auto                halved = load_program({1, {}, 1, std::vector<double>()});
        std::vector<double> times;
        double              begin = halved.time();
        for (const double end : history.record.times)
          {
            times.insert(times.end(), {(begin + end) / 2, end});
            begin = end;
          }
        halved.follow(times);
        record = repeat(halved, true);
        if (record) // what begins the first one does not count
          {
            record->n_increments = 2 * history.record.n_increments;
            record->n_of_few     = 2 * history.record.n_of_few;
          }
      }
    if (record)
      report.set_error_of_increments(error_of_increments(history.record, *record));
    measurement = {model->mesh->n_refinements, history.record.closing};
  }

  template bool
  LoadStepping<2>::increments_are_due() const;
  template bool
  LoadStepping<3>::increments_are_due() const;
  template bool
  LoadStepping<2>::choose_increments();
  template bool
  LoadStepping<3>::choose_increments();
  template bool
  LoadStepping<2>::sees_slip() const;
  template bool
  LoadStepping<3>::sees_slip() const;
  template void
  LoadStepping<2>::measure_increments();
  template void
  LoadStepping<3>::measure_increments();
} // namespace Amontons

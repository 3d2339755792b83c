#include <amontons/adaptivity/increment_choice.h>
#include <amontons/base/independent_errors.h>

namespace Amontons
{
  namespace
  {
    // In each piece of the load path.
    constexpr double at_first   = LoadProgram::increments_at_first,
                     by_default = LoadProgram::increments_by_default;

    // After the first.
    std::vector<double>
    ends_of_pieces(const LoadRecord &record)
    {
      std::vector<double> ends;
      for (unsigned int l = 1; l < record.breakpoints.size(); ++l)
        ends.push_back(record.breakpoints[l].t);
      return ends;
    }

    // Of the allowed error: not all of the bound of what closes is wrong, as it slips much the same way.
    constexpr double part_that_closes = 2;

    // True: any.
    bool
    remove(const std::vector<double> &removed, std::vector<double> &ends)
    {
      const auto n = ends.size();
      ends.erase(std::remove_if(ends.begin(),
                                ends.end(),
                                [&](const double end) {
                                  return std::find(removed.begin(), removed.end(), end) != removed.end();
                                }),
                 ends.end());
      return ends.size() < n;
    }
  } // namespace

  IncrementChoice::IncrementChoice(const RefinementParameters &parameters, const bool by_target)
      : parameters(parameters), chooses(by_target), times(by_target ? by_default / at_first : 1),
        times_in_the_end(times)
  {
  }

  std::optional<IncrementErrors>
  IncrementChoice::choose(const IncrementErrors &errors,
                          const LoadRecord      &record,
                          const bool             mesh_is_last,
                          const Repeat          &repeat)
  {
    // In each piece; more than at first where some were cut.
    const double n_pieces          = std::max<double>(1, record.breakpoints.size() - double(few.size())),
                 taken             = std::max(at_first, (errors.n_increments - errors.n_of_few) / n_pieces);
    const IncrementErrors of_first = errors.scaled(taken / at_first);
    double                n        = wanted(of_first);
    if (n <= at_first && mesh_is_last)
      return {};
    std::optional<IncrementErrors> of_these = of_first.scaled(at_first / n);
    if (n < at_first)
      of_these = try_fewer(n, errors, record, repeat);
    if (!of_these)
      {
        n        = at_first;
        of_these = errors;
      }
    times_in_the_end = by_default / n;
    times            = mesh_is_last ? times_in_the_end : std::max(1., times_in_the_end);
    return of_these;
  }

  bool
  IncrementChoice::try_fewer_in_pieces(const LoadRecord &record,
                                       const double      of_record,
                                       const Repeat     &repeat,
                                       IncrementErrors  &change)
  {
    constexpr double part_of_allowed = 0.1, part_of_work = 0.1;
    auto             ends = ends_of_pieces(record);
    remove(record.closing_beyond(part_that_closes * allowed()), ends);
    const double most = by_default / times_in_the_end / 2;
    if (ends.empty())
      return false;
    for (unsigned int n = 1; n <= most;)
      {
        const auto tried = repeat({of_record, ends, n});
        if (!tried)
          return false;
        change = difference(record, *tried);
        const double too_large =
            std::max(counted(change) / (part_of_allowed * allowed()), change.own_dissipation / part_of_work);
        if (too_large <= 1)
          {
            few       = ends;
            n_of_each = n;
            return true;
          }
        if (n > 1)
          return false;
        n = std::ceil(too_large);
      }
    return false;
  }

  bool
  IncrementChoice::divide(const LoadRecord &record)
  {
    return remove(record.closing_beyond(part_that_closes * allowed()), few);
  }

  void
  IncrementChoice::take_lengths(const IncrementChoice &other)
  {
    times            = other.times;
    times_in_the_end = other.times_in_the_end;
    few              = other.few;
    n_of_each        = other.n_of_each;
  }

  bool
  IncrementChoice::take_all()
  {
    const bool more = wants_more();
    times           = times_in_the_end;
    return more;
  }

  bool
  IncrementChoice::keep(const IncrementErrors &errors, const double of_mesh)
  {
    const double error = counted(errors);
    const bool   do_so = error <= allowed() || together(error, of_mesh) <= parameters.target_error;
    if (do_so)
      times_in_the_end = times;
    return do_so;
  }

  // As many as make the error half of the target, but not without limit. One alone, which has no
  // shorter ones to compare with, takes ten times less.
  double
  IncrementChoice::wanted(const IncrementErrors &errors) const
  {
    const double error = counted(errors) * at_first; // of a single one
    const double n     = std::min(std::ceil(error / allowed()), parameters.most_increments());
    return n > 1 ? n : 10 * error <= allowed() ? 1 : 2;
  }

  // Fewer than at first only if they do where they are tried, where it shows how many that are: what begins a
  // piece is none of them.
  std::optional<IncrementErrors>
  IncrementChoice::try_fewer(const double           n,
                             const IncrementErrors &errors,
                             const LoadRecord      &record,
                             const Repeat          &repeat) const
  {
    constexpr double another_way = 0.1; // of the work
    const auto       tried       = repeat({by_default / n, few, n_of_each});
    if (!tried)
      return {};
    const auto found = error_of_increments(record, *tried).for_steps(*tried);
    if (counted(found) > allowed() || found.dissipation > another_way)
      return {};
    const auto expected = errors.for_steps(*tried);
    return counted(found) > counted(expected) ? found : expected;
  }

  double
  IncrementChoice::allowed() const
  {
    return parameters.target_error / 2;
  }

  double
  IncrementChoice::counted(const IncrementErrors &errors) const
  {
    return errors.of(parameters.target_quantity);
  }
} // namespace Amontons

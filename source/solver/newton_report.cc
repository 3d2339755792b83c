#include <amontons/solver/newton_report.h>

#include <algorithm>

namespace Amontons
{
  bool
  NewtonReport::has_stalled(const double small) const
  {
    const unsigned int last = 4;
    return iterations.size() > last && iterations.back().residual <= small &&
           std::all_of(iterations.end() - last, iterations.end(), [&](const auto &step) {
             return step.n_changes == 0 && step.residual > 0.5 * (iterations.end() - last - 1)->residual;
           });
  }

  bool
  NewtonReport::stagnates(const double tolerance) const
  {
    const unsigned int last = 12;
    if (iterations.size() < 25 || frozen || iterations.back().residual <= tolerance)
      return false;
    const auto   smaller = [](const auto &a, const auto &b) { return a.residual < b.residual; };
    const auto   middle  = iterations.end() - last;
    const double before  = std::min_element(iterations.begin(), middle, smaller)->residual,
                 now     = std::min_element(middle, iterations.end(), smaller)->residual;
    return now > 0.3 * before;
  }
} // namespace Amontons

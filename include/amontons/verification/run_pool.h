/// Several runs of a study at once.
#pragma once

#include <amontons/verification/run_process.h>

#include <functional>
#include <ostream>

namespace Amontons
{
  using RunProcess = std::function<RunEnd(const RunOrder &)>; // called by several threads at once

  /// Runs all orders, at most `n_jobs` at a time, in their order. `on_end` is called for each that was not
  /// stopped, one after another. After a signal (StopOnSignal), or where `run` or `on_end` throw, no further
  /// run starts; what was thrown first is thrown again in the end.
  void
  run_all(const std::vector<RunOrder>                                   &orders,
          const unsigned int                                             n_jobs,
          const RunProcess                                              &run,
          const std::function<void(const unsigned int, const RunEnd &)> &on_end);

  /// How far a study is, with the time that is left: on a terminal one line that changes, else a line every
  /// ten seconds.
  class StudyProgress
  {
  public:
    StudyProgress(const unsigned int n_known, const unsigned int n_points, std::ostream &out);

    void
    one_more();
    void
    finish();

  private:
    const unsigned int n_known, n_points;
    std::ostream      &out;
    const double       start;
    const bool         on_terminal;
    unsigned int       n_done = 0;
    double             last   = 0;
  };

  /// "12 s", "3 min", "2 h 5 min"
  std::string
  duration(const double seconds);
} // namespace Amontons

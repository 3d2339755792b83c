/// What ends a run before its time: a signal, a time limit, a file that cannot be written.
#pragma once

#include <deal.II/base/mpi.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace Amontons
{
  /// Asked in the middle of long work, by all ranks at the same place: true once, it is given up. Empty:
  /// never.
  using GivesUp = std::function<bool()>;

  /// One at a time.
  class StopRequest
  {
  public:
    /// time_limit: in seconds from now; 0: none. SIGINT and SIGTERM (unless they are ignored) are noted from
    /// now on, if `signals`; another one, a second later or more, ends the process as if nobody looked.
    explicit StopRequest(const double time_limit = 0, const bool signals = true);
    ~StopRequest();

    StopRequest(const StopRequest &) = delete;
    StopRequest &
    operator=(const StopRequest &) = delete;

    /// Of this rank; the others hear of it when all look. The first one counts.
    void
    because(const std::string &reason);

    /// A signal has come to this rank.
    static bool
    is_urgent();

    /// Whether any rank has a reason. Collective; true once is true ever after.
    bool
    look(const MPI_Comm communicator);
    /// Whether a signal or the time limit has waited so long for the end of a solve that this is given up.
    /// (Short ones end first: they leave more.) Collective; then look() is true, too.
    bool
                            gives_up(const MPI_Comm communicator);
    static constexpr double patience = 2; // seconds
    bool
    is_there() const
    {
      return stopped;
    }
    /// "stopped by SIGINT"; empty before look() has found one; then the same on all ranks.
    const std::string &
    reason() const
    {
      return why;
    }
    /// To be told when the run has ended: that of this rank, which nobody may have looked at.
    const std::string &
    own_reason() const
    {
      return own;
    }

  private:
    using Clock = std::chrono::steady_clock;

    // A signal or the time limit, of this rank.
    void
    note();

    const double                     time_limit;
    const bool                       notes_signals;
    const Clock::time_point          start;
    bool                             stopped = false;
    std::string                      own, why;
    std::optional<Clock::time_point> noted; // when it was, the first time
  };
} // namespace Amontons

/// What ends a run before its time: a signal, a time limit, a file that cannot be written.
#pragma once

#include <deal.II/base/mpi.h>

#include <chrono>
#include <string>

namespace Amontons
{
  /// One at a time.
  class StopRequest
  {
  public:
    /// time_limit: in seconds from now; 0: none. SIGINT and SIGTERM (unless they are ignored) are noted from
    /// now on, if `signals`; the second of a kind ends the process as if nobody looked.
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
    const double                                time_limit;
    const bool                                  notes_signals;
    const std::chrono::steady_clock::time_point start;
    bool                                        stopped = false;
    std::string                                 own, why;
  };
} // namespace Amontons

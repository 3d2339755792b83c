#include <amontons/base/stop_request.h>

#include <array>
#include <csignal>
#include <ctime>
#include <sstream>

namespace Amontons
{
  namespace
  {
    volatile std::sig_atomic_t signal_that_came = 0;
    struct timespec            time_of_signal   = {};

    // Whoever stops a process and its group may signal it twice at once (timeout of coreutils does). Later, a
    // second signal ends the process.
    extern "C" void
    note_signal_to_stop(const int number)
    {
      constexpr double at_once = 1; // seconds
      struct timespec  now     = {};
      clock_gettime(CLOCK_MONOTONIC, &now);
      if (signal_that_came == 0)
        time_of_signal = now;
      else if (now.tv_sec - time_of_signal.tv_sec + 1e-9 * (now.tv_nsec - time_of_signal.tv_nsec) > at_once)
        {
          std::signal(number, SIG_DFL);
          std::raise(number); // as this function returns
        }
      signal_that_came = number;
    }

    constexpr std::array<int, 2>    signals_to_note = {{SIGINT, SIGTERM}};
    std::array<struct sigaction, 2> actions_before;
  } // namespace

  StopRequest::StopRequest(const double time_limit, const bool signals)
      : time_limit(time_limit), notes_signals(signals), start(Clock::now())
  {
    signal_that_came        = 0;
    struct sigaction action = {};
    action.sa_handler       = note_signal_to_stop;
    action.sa_flags         = SA_RESTART;
    for (unsigned int i = 0; notes_signals && i < signals_to_note.size(); ++i)
      {
        sigaction(signals_to_note[i], &action, &actions_before[i]);
        if (actions_before[i].sa_handler == SIG_IGN)
          sigaction(signals_to_note[i], &actions_before[i], nullptr);
      }
  }

  StopRequest::~StopRequest()
  {
    for (unsigned int i = 0; notes_signals && i < signals_to_note.size(); ++i)
      sigaction(signals_to_note[i], &actions_before[i], nullptr);
  }

  void
  StopRequest::because(const std::string &reason)
  {
    if (own.empty())
      own = reason;
  }

  bool
  StopRequest::is_urgent()
  {
    return signal_that_came != 0;
  }

  void
  StopRequest::note()
  {
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const bool   is_late = time_limit > 0 && seconds > time_limit;
    if (!noted && (is_urgent() || is_late))
      noted = Clock::now();
    if (is_urgent())
      because(std::string("stopped by ") + (signal_that_came == SIGINT ? "SIGINT" : "SIGTERM"));
    if (is_late)
      {
        std::ostringstream text;
        text << "stopped by the time limit of " << time_limit << " s";
        because(text.str());
      }
  }

  bool
  StopRequest::gives_up(const MPI_Comm communicator)
  {
    note();
    const double waited = noted ? std::chrono::duration<double>(Clock::now() - *noted).count() : 0;
    return dealii::Utilities::MPI::max(waited, communicator) > patience && look(communicator);
  }

  bool
  StopRequest::look(const MPI_Comm communicator)
  {
    if (stopped)
      return true;
    note();
    using namespace dealii::Utilities::MPI;
    const unsigned int n_ranks = n_mpi_processes(communicator);
    const unsigned int first   = min(own.empty() ? n_ranks : this_mpi_process(communicator), communicator);
    if (first == n_ranks)
      return false;
    why            = broadcast(communicator, own, first);
    return stopped = true;
  }
} // namespace Amontons

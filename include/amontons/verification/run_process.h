/// One run of a study as a process of its own: this program starts itself, on one rank, and is killed with
/// all that it started when its time is over or the study is stopped.
#pragma once

#include <boost/property_tree/ptree.hpp>

#include <optional>
#include <string>
#include <vector>

namespace Amontons
{
  struct RunEnd
  {
    enum class Kind
    {
      ended,      // `code` is its exit code
      signal,     // `code` is the signal that it died of
      time_limit, // killed: too much processor time, or ten times as much on the clock and a minute
      stopped     // killed with the study
    };
    Kind        kind         = Kind::ended;
    int         code         = 0;
    double      wall_seconds = 0, processor_seconds = 0, megabytes = 0; // megabytes: the largest that it held
    std::string last_words;                                             // the last line on stderr

    std::optional<boost::property_tree::ptree> summary; // summary.json, where it was written
  };

  struct RunOrder
  {
    std::string              scene;
    std::vector<std::string> overrides;
    std::string              folder;          // for output; made, and removed in the end
    double                   time_limit = 60; // seconds of the processor, rounded up
    double                   patience   = 60; // on the clock: so many seconds, and ten times the time limit
    std::string              program    = "/proc/self/exe";
  };

  /// Not collective; several threads may call it at once. Throws std::runtime_error where no process can be
  /// started.
  RunEnd
  run_process(const RunOrder &order);

  /// While one lives, SIGINT, SIGTERM and SIGHUP end the runs and let the program go on; `signal()` is the
  /// one that came, or 0.
  class StopOnSignal
  {
  public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal &) = delete;

    static int
    signal();
  };
} // namespace Amontons

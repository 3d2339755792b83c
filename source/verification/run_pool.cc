#include <amontons/verification/run_pool.h>

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <mutex>
#include <thread>

namespace Amontons
{
  namespace
  {
    double
    now_in_seconds()
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    }
  } // namespace

  void
  run_all(const std::vector<RunOrder>                                   &orders,
          const unsigned int                                             n_jobs,
          const RunProcess                                              &run,
          const std::function<void(const unsigned int, const RunEnd &)> &on_end)
  {
    std::mutex         mutex;
    std::exception_ptr error;
    unsigned int       next = 0;
    const auto         work = [&] {
      for (;;)
        {
          unsigned int mine = 0;
          {
            const std::lock_guard<std::mutex> lock(mutex);
            if (error || next == orders.size() || StopOnSignal::signal() != 0)
              return;
            mine = next++;
          }
          try
            {
              const RunEnd                      end = run(orders[mine]);
              const std::lock_guard<std::mutex> lock(mutex);
              if (end.kind != RunEnd::Kind::stopped && !error)
                on_end(mine, end);
            }
          catch (const std::exception &)
            {
              const std::lock_guard<std::mutex> lock(mutex);
              if (!error)
                error = std::current_exception();
            }
        }
    };
    std::vector<std::thread> threads;
    for (unsigned int i = 0; i < std::min<std::size_t>(n_jobs, orders.size()); ++i)
      threads.emplace_back(work);
    for (std::thread &thread : threads)
      thread.join();
    if (error)
      std::rethrow_exception(error);
  }

  StudyProgress::StudyProgress(const unsigned int n_known, const unsigned int n_points, std::ostream &out)
      : n_known(n_known), n_points(n_points), out(out), start(now_in_seconds()),
        on_terminal(&out == &std::cout && isatty(1) != 0), last(start)
  {
  }

  void
  StudyProgress::one_more()
  {
    ++n_done;
    const double       now    = now_in_seconds();
    const unsigned int n_left = n_points - n_known - n_done;
    if (!on_terminal && (now - last < 10 || n_left == 0))
      return;
    last = now;
    out << (on_terminal ? "\r" : "") << n_known + n_done << " of " << n_points << " runs, about "
        << duration((now - start) / n_done * n_left) << " left" << (on_terminal ? "      " : "\n")
        << std::flush;
  }

  void
  StudyProgress::finish()
  {
    if (on_terminal && n_done > 0)
      out << "\r" << std::string(60, ' ') << "\r" << std::flush;
  }

  std::string
  duration(const double seconds)
  {
    const long long all = std::llround(seconds), minutes = (all + 30) / 60;
    if (all < 120)
      return std::to_string(all) + " s";
    return (minutes >= 120 ? std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60)
                           : std::to_string(minutes)) +
           " min";
  }
} // namespace Amontons

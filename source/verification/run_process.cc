#include <amontons/verification/run_process.h>
#include <amontons/scene/text.h>

#include <boost/property_tree/json_parser.hpp>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace Amontons
{
  namespace
  {
    namespace fs = std::filesystem;

    volatile std::sig_atomic_t signal_that_came = 0;

    extern "C" void
    note_signal(const int number)
    {
      signal_that_came = number;
    }

    constexpr std::array<int, 3>                             signals_to_stop = {{SIGINT, SIGTERM, SIGHUP}};
    std::array<struct sigaction, std::size(signals_to_stop)> actions_before;

    // What MPI has set in this process would make the new one look for a daemon. So: the environment that
    // this process was started with, less that of an mpirun; one thread; and a folder of its own, as the
    // session folders of single processes share a name.
    std::vector<std::string>
    environment_of_run(const std::string &temporary)
    {
      std::vector<std::string> result;
      std::ifstream            in("/proc/self/environ", std::ios::binary);
      for (std::string entry; std::getline(in, entry, '\0');)
        {
          bool is_kept = true;
          for (const char *const head : {"OMPI_",
                                         "PMIX_",
                                         "PMI_",
                                         "PRTE_",
                                         "ORTE_",
                                         "TMPDIR=",
                                         "OMP_NUM_THREADS=",
                                         "OPENBLAS_NUM_THREADS="})
            is_kept = is_kept && entry.rfind(head, 0) != 0;
          if (is_kept)
            result.push_back(entry);
        }
      for (const char *const entry : {"OMP_NUM_THREADS=1",
                                      "OPENBLAS_NUM_THREADS=1",
                                      "OMPI_MCA_ess_singleton_isolated=1",
                                      "OMPI_MCA_pml=ob1",
                                      "OMPI_MCA_btl=self"})
        result.emplace_back(entry);
      result.push_back("TMPDIR=" + temporary);
      return result;
    }

    std::vector<char *>
    pointers(std::vector<std::string> &texts)
    {
      std::vector<char *> result;
      result.reserve(texts.size() + 1);
      for (std::string &text : texts)
        result.push_back(text.data());
      result.push_back(nullptr);
      return result;
    }

    // Of processor time, in whole seconds: SIGXCPU ends what uses more.
    void
    limit_processor_time(const double seconds)
    {
      struct rlimit limit = {};
      limit.rlim_cur      = static_cast<rlim_t>(std::ceil(seconds));
      limit.rlim_max      = limit.rlim_cur + 1;
      setrlimit(RLIMIT_CPU, &limit);
    }

    // In a process group of its own. Between fork and exec only what is safe in a program with threads.
    pid_t
    start(const std::string       &program,
          std::vector<std::string> arguments,
          std::vector<std::string> environment,
          const std::string       &errors,
          const double             time_limit)
    {
      const auto  argv = pointers(arguments), envp = pointers(environment);
      const pid_t parent = getpid(), child = fork();
      if (child < 0)
        throw std::runtime_error(std::string("no process can be started: ") + std::strerror(errno));
      if (child > 0)
        {
          setpgid(child, child); // here too: whoever comes first
          return child;
        }
      setpgid(0, 0);
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      limit_processor_time(time_limit);
      const struct rlimit no_core = {};
      setrlimit(RLIMIT_CORE, &no_core);
      if (getppid() != parent)
        _exit(127);
      for (const int number : signals_to_stop)
        std::signal(number, SIG_DFL);
      const int nothing = open("/dev/null", O_RDWR);
      const int words   = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
      dup2(nothing, 0);
      dup2(nothing, 1);
      dup2(words >= 0 ? words : nothing, 2);
      execve(program.c_str(), argv.data(), envp.data());
      _exit(127);
    }

    // Looks every few milliseconds whether it has ended.
    RunEnd
    wait_for(const pid_t child, const double time_limit, const double clock_limit)
    {
      using Clock           = std::chrono::steady_clock;
      const auto    begin   = Clock::now();
      const auto    seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
      RunEnd        end;
      int           status = 0;
      struct rusage usage  = {};
      bool          killed = false;
      for (pid_t found = 0; (found = wait4(child, &status, WNOHANG, &usage)) != child;)
        {
          if (found < 0 && errno != EINTR)
            throw std::runtime_error(std::string("a run of the study was lost: ") + std::strerror(errno));
          if (!killed && (signal_that_came != 0 || seconds() > clock_limit))
            {
              end.kind = signal_that_came != 0 ? RunEnd::Kind::stopped : RunEnd::Kind::time_limit;
              killed   = true;
              kill(-child, SIGKILL);
            }
          std::this_thread::sleep_for(std::chrono::milliseconds(4));
        }
      kill(-child, SIGKILL); // what it started and left behind
      const auto in_seconds = [](const timeval &time) { return time.tv_sec + 1e-6 * time.tv_usec; };
      end.wall_seconds      = seconds();
      end.processor_seconds = in_seconds(usage.ru_utime) + in_seconds(usage.ru_stime);
      end.megabytes         = usage.ru_maxrss / 1024.;
      if (!killed)
        {
          end.kind = WIFSIGNALED(status) ? RunEnd::Kind::signal : RunEnd::Kind::ended;
          end.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
          if (end.kind == RunEnd::Kind::signal &&
              (end.code == SIGXCPU || (end.code == SIGKILL && end.processor_seconds > 0.8 * time_limit)))
            end.kind = RunEnd::Kind::time_limit;
        }
      return end;
    }

    std::string
    last_line(const std::string &file)
    {
      std::ifstream in(file);
      std::string   last;
      for (std::string line; std::getline(in, line);)
        if (!trim(line).empty())
          last = trim(line);
      return last;
    }

    struct TemporaryFolder
    {
      std::string path = (fs::temp_directory_path() / "amontons-XXXXXX").string();

      TemporaryFolder()
      {
        if (mkdtemp(path.data()) == nullptr)
          throw std::runtime_error("no folder can be made in " + fs::temp_directory_path().string());
      }
      ~TemporaryFolder()
      {
        std::error_code error;
        fs::remove_all(path, error);
      }
      TemporaryFolder(const TemporaryFolder &) = delete;
    };
  } // namespace

  RunEnd
  run_process(const RunOrder &order)
  {
    const TemporaryFolder temporary;
    std::error_code       error;
    fs::remove_all(order.folder, error);
    fs::create_directories(order.folder, error);
    const std::string        words = order.folder + "/stderr", output = order.folder + "/output";
    std::vector<std::string> arguments = {"amontons", order.scene, "--quiet", "--output", output};
    for (const std::string &text : order.overrides)
      {
        arguments.emplace_back("--set");
        arguments.push_back(text);
      }
    const pid_t child =
        start(order.program, arguments, environment_of_run(temporary.path), words, order.time_limit);
    RunEnd end     = wait_for(child, order.time_limit, order.patience + 10 * order.time_limit);
    end.last_words = last_line(words);
    if (std::ifstream in(output + "/summary.json"); end.kind == RunEnd::Kind::ended && in)
      try
        {
          read_json(in, end.summary.emplace());
        }
      catch (const boost::property_tree::json_parser_error &)
        {
          end.summary.reset();
        }
    fs::remove_all(order.folder, error);
    return end;
  }

  StopOnSignal::StopOnSignal()
  {
    signal_that_came        = 0;
    struct sigaction action = {};
    action.sa_handler       = note_signal;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < signals_to_stop.size(); ++i)
      sigaction(signals_to_stop[i], &action, &actions_before[i]);
  }

  StopOnSignal::~StopOnSignal()
  {
    for (std::size_t i = 0; i < signals_to_stop.size(); ++i)
      sigaction(signals_to_stop[i], &actions_before[i], nullptr);
  }

  int
  StopOnSignal::signal()
  {
    return signal_that_came;
  }
} // namespace Amontons

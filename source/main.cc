#include <amontons/base/blas_threads.h>
#include <amontons/base/temporary_folder.h>
#include <amontons/base/version.h>
#include <amontons/output/output_folder.h>
#include <amontons/run_parameters.h>
#include <amontons/scene/scene_reader.h>
#include <amontons/scene/text.h>
#include <amontons/verification/convergence_study.h>
#include <amontons/verification/process_study.h>
#include <amontons/verification/run_scene.h>

#include <deal.II/base/mpi.templates.h>

#include <boost/property_tree/json_parser.hpp>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <thread>

namespace
{
  using namespace Amontons;

  struct CommandLine
  {
    std::string              scene;
    std::vector<std::string> overrides;
    std::string              output, resume;
    double                   time_limit = 0; // seconds; 0: none
    unsigned int             n_jobs     = std::max(1u, std::thread::hardware_concurrency());
    bool parameters = false, quiet = false, help = false, version = false, is_study = false;
  };

  const char *usage =
      "usage: amontons SCENE.prm [--set \"Section/Name = value\"]... [--output DIR] [--time-limit TIME] "
      "[--quiet]\n"
      "       amontons --resume DIR [--time-limit TIME] [--quiet]\n"
      "       amontons study STUDY.prm [--jobs N] [--output DIR]\n"
      "       amontons --parameters\n"
      "       amontons --version\n"
      "       mpirun -np 4 amontons SCENE.prm\n";

  unsigned int
  number_of_jobs(const std::string &text)
  {
    const std::optional<double> number = as_number(text);
    if (!number || *number < 1 || *number > 1024 || *number != std::floor(*number))
      throw InputError(
          {"command line", 0, "--jobs"}, "found '" + text + "'", "a number of runs at once, 1 to 1024");
    return static_cast<unsigned int>(*number);
  }

  // 90, 90s, 5m, 2h: in seconds.
  double
  duration(const std::string &text)
  {
    const std::map<char, double> units = {{'s', 1}, {'m', 60}, {'h', 3600}};
    const auto                   unit  = text.empty() ? units.end() : units.find(text.back());
    const auto number = as_number(unit == units.end() ? text : text.substr(0, text.size() - 1));
    if (!number || !(*number > 0) || !std::isfinite(*number))
      throw InputError({"command line", 0, "--time-limit"},
                       "found '" + text + "'",
                       "a positive number, of seconds or with a unit: 90, 90s, 5m, 2h");
    return *number * (unit == units.end() ? 1 : unit->second);
  }

  void
  check_resume(const CommandLine &line)
  {
    if (!line.resume.empty() && (!line.scene.empty() || !line.overrides.empty() || !line.output.empty()))
      throw InputError({"command line", 0, "--resume"},
                       "more than the folder of the run",
                       "amontons --resume DIR; scene and entries are those that the run was started with");
  }

  void
  check_study(const CommandLine &line)
  {
    if (line.is_study && (line.time_limit > 0 || !line.resume.empty()))
      throw InputError({"command line", 0, "study"},
                       "--time-limit and --resume have no meaning for a study",
                       "they are for single runs");
    if (line.is_study && (!line.overrides.empty() || line.scene.empty()))
      throw InputError({"command line", 0, "study"},
                       line.scene.empty() ? "no study file is given" : "--set has no meaning for a study",
                       "amontons study STUDY.prm [--jobs N] [--output DIR]; what it varies is in the file");
  }

  [[noreturn]] void
  refuse(const std::string &argument)
  {
    const std::string found = argument[0] == '-' ? "unknown argument" + suggestion(argument,
                                                                                   {"--set",
                                                                                    "--output",
                                                                                    "--resume",
                                                                                    "--time-limit",
                                                                                    "--quiet",
                                                                                    "--jobs",
                                                                                    "--parameters",
                                                                                    "--version",
                                                                                    "--help"})
                                                 : "a second file";
    throw InputError({"command line", 0, argument}, found, "see 'amontons --help'");
  }

  CommandLine
  parse(const int argc, char **argv)
  {
    CommandLine line;
    for (int i = 1; i < argc; ++i)
      {
        const std::string argument = argv[i];
        const auto        next     = [&]() -> std::string {
          if (++i >= argc || std::string(argv[i]).empty() || std::string(argv[i]).rfind("--", 0) == 0)
            throw InputError({"command line", 0, argument}, "its value is missing", "see 'amontons --help'");
          return argv[i];
        };
        if (argument == "--set")
          line.overrides.push_back(next());
        else if (argument == "--output")
          line.output = next();
        else if (argument == "--resume")
          line.resume = next();
        else if (argument == "--time-limit")
          line.time_limit = duration(next());
        else if (argument == "--jobs")
          line.n_jobs = number_of_jobs(next());
        else if (argument == "--parameters")
          line.parameters = true;
        else if (argument == "--quiet")
          line.quiet = true;
        else if (argument == "study" && i == 1)
          line.is_study = true;
        else if (argument == "--help" || argument == "-h")
          line.help = true;
        else if (argument == "--version")
          line.version = true;
        else if (argument[0] == '-' || !line.scene.empty())
          refuse(argument);
        else
          line.scene = argument;
      }
    check_study(line);
    check_resume(line);
    return line;
  }

  // Output goes to the working directory: the scene's name without folder and ending.
  std::string
  default_output(const std::string &scene)
  {
    const auto slash = scene.find_last_of('/');
    const auto name  = slash == std::string::npos ? scene : scene.substr(slash + 1);
    return "output/" + name.substr(0, name.find_last_of('.'));
  }

  // A scene's summary.json as the study wants it, on every rank.
  boost::property_tree::ptree
  run_for_study(const std::string &file, const std::vector<std::string> &overrides, const std::string &output)
  {
    RunControl       control{StopRequest(0, false), Checkpoint(MPI_COMM_WORLD)};
    const RunSummary summary = run_scene({file, overrides, output, true}, control);
    if (!summary.converged)
      throw std::runtime_error(summary.message);
    MPI_Barrier(MPI_COMM_WORLD);
    std::ifstream               in(output + "/summary.json");
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(in, tree);
    return tree;
  }

  int
  run_study(const CommandLine &line)
  {
    const std::string &file = line.scene;
    if (const StudyEntries entries(file); entries.kind != StudyKind::convergence)
      {
        if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
          throw InputError(entries.where("", "Kind"),
                           "a study whose runs are processes of their own, on several ranks",
                           "one rank; --jobs N runs N scenes at once");
        return run_process_study(entries, {line.output, line.n_jobs}, run_process, std::cout);
      }
    const std::string output = line.output.empty() ? default_output(file) : line.output;
    unsigned int      n_runs = 0;
    return run_convergence_study(
        file,
        [&](const std::string &scene, const std::vector<std::string> &overrides) {
          return run_for_study(scene, overrides, output + "/run_" + std::to_string(n_runs++));
        },
        std::cout,
        MPI_COMM_WORLD);
  }

  // 2: it was stopped, or could not write its files.
  int
  run_single(const SceneRun &task, const double time_limit)
  {
    const bool       is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    RunControl       control{StopRequest(time_limit), Checkpoint(MPI_COMM_WORLD)};
    const RunSummary summary   = run_scene(task, control);
    const bool       unwritten = !control.stop.is_there() && !control.stop.own_reason().empty();
    if (unwritten)
      std::cerr << control.stop.own_reason() + "\n";
    else if (is_root && task.quiet && !summary.converged)
      std::cerr << task.scene + ": not converged: " + summary.message + "\n";
    if (control.stop.is_there() || unwritten)
      return 2;
    return summary.converged ? 0 : 1;
  }

  int
  run(const int argc, char **argv)
  {
    const bool        is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const CommandLine line    = parse(argc, argv);
    Parameters        parameters;
    if (line.version)
      {
        if (is_root)
          std::cout << "amontons " << version << (*commit == '\0' ? "" : " " + std::string(commit)) << "\n";
        return 0;
      }
    if (line.help || (line.scene.empty() && line.resume.empty() && !line.parameters))
      {
        if (is_root)
          (line.help ? std::cout : std::cerr) << usage;
        return line.help ? 0 : 1;
      }
    if (line.parameters)
      {
        if (is_root)
          print_parameters(std::cout, parameters.groups());
        return 0;
      }
    if (line.is_study)
      return run_study(line);
    SceneRun task = {line.scene, line.overrides, line.output, line.quiet, !line.resume.empty()};
    if (task.resumes)
      {
        const Checkpoint::Run run = Checkpoint::read_run(line.resume);
        task.scene                = run.scene;
        task.overrides            = run.overrides;
        task.folder               = line.resume;
      }
    else if (task.folder.empty())
      task.folder = default_output(task.scene);
    return run_single(task, line.time_limit);
  }

  // An error that all ranks meet is printed once, and they end in peace. Where others may wait for a rank in
  // vain, the lowest of those that failed says why, and all are stopped. `channel` is used for nothing else.
  int
  end_with(const int code, const std::string &message, const MPI_Comm channel)
  {
    const int rank    = Utilities::MPI::this_mpi_process(channel),
              n_ranks = Utilities::MPI::n_mpi_processes(channel);
    char nothing      = 0;
    for (int other = 0; other < n_ranks; ++other)
      if (other != rank)
        {
          MPI_Request request;
          MPI_Isend(&nothing, 1, MPI_CHAR, other, 0, channel, &request);
          MPI_Request_free(&request);
        }

    int        n_failed = 1, lowest = rank;
    const auto start = std::chrono::steady_clock::now();
    while (n_failed < n_ranks && std::chrono::steady_clock::now() - start < std::chrono::seconds(2))
      {
        int        found = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, 0, channel, &found, &status);
        if (found != 0)
          {
            MPI_Recv(&nothing, 1, MPI_CHAR, status.MPI_SOURCE, 0, channel, MPI_STATUS_IGNORE);
            lowest = std::min(lowest, status.MPI_SOURCE);
            ++n_failed;
          }
        else
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
      }
    if (rank == lowest)
      {
        remove_new_output_folder();
        std::cout << std::flush;
        std::cerr << message + "\n"; // one write: what mpirun says of the abort may not come between
      }
    if (n_failed == n_ranks)
      return code;
    if (rank != lowest)
      std::this_thread::sleep_for(std::chrono::seconds(5));
    MPI_Abort(MPI_COMM_WORLD, code);
    return code;
  }
} // namespace

int
main(int argc, char **argv)
{
#ifdef __AVX2__
  if (!__builtin_cpu_supports("avx2"))
    {
      std::cerr << "amontons was built for processors with AVX2, which this one has not: build it here, or "
                   "with 'cmake -DAMONTONS_AVX2=OFF'\n";
      return 1;
    }
#endif
  // Half of the start of a single process is Open MPI starting a daemon for it; without one, processes that
  // start at once would share a folder.
  const Amontons::TemporaryFolder own_folder;
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMI_SIZE") == nullptr &&
      std::getenv("PMIX_RANK") == nullptr)
    {
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_pml", "ob1", 0);
      setenv("OMPI_MCA_btl", "self", 0);
      setenv("OMPI_MCA_orte_tmpdir_base", own_folder.path.c_str(), 0);
    }
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Amontons::BlasThreads              one_thread(1); // but for factorisations
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  MPI_Comm channel;
  MPI_Comm_dup(MPI_COMM_WORLD, &channel);
  try
    {
      return run(argc, argv);
    }
  catch (const Amontons::InputError &error)
    {
      return end_with(1, error.what(), channel);
    }
  catch (const std::bad_alloc &)
    {
      return end_with(
          1,
          "amontons: out of memory; allowed: a smaller 'Maximum DoFs', fewer cells or more memory",
          channel);
    }
  catch (const std::exception &error)
    {
      return end_with(2, std::string("amontons: internal error: ") + error.what(), channel);
    }
}

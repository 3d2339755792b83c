// A run of a study is a process: its exit code, signal, time limit, cost and summary; nothing is left behind.
#include <amontons/verification/run_process.h>

#include <check.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace test_run_process
{
using namespace Amontons;
namespace fs = std::filesystem;

namespace
{
  // /bin/sh stands for the program: "sh SCENE --quiet --output FOLDER --set ...".
  RunEnd
  shell(const std::string &script, const double time_limit = 60)
  {
    std::ofstream("script") << script;
    RunOrder order;
    order.scene      = "script";
    order.overrides  = {"A/B = 1"};
    order.folder     = "runs/0";
    order.time_limit = time_limit;
    order.patience   = 1;
    order.program    = "/bin/sh";
    const RunEnd end = run_process(order);
    check::is_true(!fs::exists("runs/0"), "its folder is gone");
    return end;
  }
} // namespace

int
main(int, char **)
{
  fs::create_directories("run_process_files");
  fs::current_path("run_process_files");

  RunEnd end = shell("mkdir -p \"$3\"; echo '{\"status\": \"converged\"}' > \"$3/summary.json\"; test \"$4 "
                     "$5\" = '--set A/B = 1'");
  check::is_true(end.kind == RunEnd::Kind::ended && end.code == 0, "ends well, with its override");
  check::is_true(end.summary && end.summary->get<std::string>("status") == "converged", "its summary");
  check::is_true(end.megabytes > 0.1, "its memory");

  end = shell("echo first >&2; echo 'last words' >&2; exit 3");
  check::is_true(end.kind == RunEnd::Kind::ended && end.code == 3 && end.last_words == "last words" &&
                     !end.summary,
                 "ends with a code");

  end = shell("kill -SEGV $$");
  check::is_true(end.kind == RunEnd::Kind::signal && end.code == SIGSEGV, "dies of a signal");

  // What it started is killed with it.
  end = shell("(sleep 3; touch left) & sleep 60", 0.1);
  check::is_true(end.kind == RunEnd::Kind::time_limit && end.wall_seconds < 20, "is killed after its time");
  check::is_true(std::system("sleep 4") == 0 && !fs::exists("left"), "with what it started");

  end = shell("while :; do :; done", 1);
  check::is_true(end.kind == RunEnd::Kind::time_limit && end.processor_seconds > 0.5, "works for too long");

  end = shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done");
  check::is_true(end.processor_seconds > 0.01 && end.processor_seconds < 1.5 * end.wall_seconds + 0.1,
                 "processor time");

  end = shell("test \"$OMP_NUM_THREADS\" = 1 && test -d \"$TMPDIR\" && test -z \"$OMPI_COMM_WORLD_SIZE\"");
  check::is_true(end.code == 0, "its environment");

  const StopOnSignal stop;
  std::raise(SIGINT);
  check::is_true(StopOnSignal::signal() == SIGINT, "the signal is told");
  check::is_true(shell("sleep 60").kind == RunEnd::Kind::stopped, "a signal ends runs");
  return check::result();
}
} // namespace test_run_process

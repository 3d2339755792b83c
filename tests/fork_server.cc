// Preloaded (LD_PRELOAD) into a program, makes of it a server of its own runs: where main() would begin, with
// all libraries linked, it waits at a socket and forks for each run asked for, which then takes main() up
// with its own arguments, surroundings, folder and standard streams. The dynamic linker needs 0.4 s for the
// 200 libraries below deal.II, more than most scenes of the tests take. See fork_client.cc, which starts the
// server and asks it.
#include "fork_server.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>

namespace
{
using Main = int(int, char **, char **);

Main *program;

[[noreturn]] void
run(fork_server::Request &request)
{
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (int stream = 0; stream < 3; ++stream)
    dup2(request.streams[stream], stream);
  for (const int stream : request.streams)
    close(stream);
  if (chdir(request.folder.c_str()) != 0)
    _exit(126);
  clearenv();
  for (std::string &variable : request.environment)
    putenv(variable.data());
  std::vector<char *> arguments;
  for (std::string &argument : request.arguments)
    arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  exit(program(static_cast<int>(request.arguments.size()), arguments.data(), environ));
}

/// The run asked for at @p connection: its process and, when it has ended, its status are told. Where nobody
/// listens any more, it is killed.
void
answer(const int connection)
{
  fork_server::Request request;
  if (!fork_server::receive(connection, request))
    return;
  // On the processors to which mpirun has bound whoever asks.
  ucred     asking = {};
  socklen_t size   = sizeof(asking);
  cpu_set_t processors;
  if (getsockopt(connection, SOL_SOCKET, SO_PEERCRED, &asking, &size) == 0 &&
      sched_getaffinity(asking.pid, sizeof(processors), &processors) == 0)
    sched_setaffinity(0, sizeof(processors), &processors);
  sigset_t ends, before;
  sigemptyset(&ends);
  sigaddset(&ends, SIGCHLD);
  sigprocmask(SIG_BLOCK, &ends, &before);
  const int   ended   = signalfd(-1, &ends, SFD_CLOEXEC);
  const pid_t process = fork();
  if (process == 0)
    {
      close(connection);
      close(ended);
      sigprocmask(SIG_SETMASK, &before, nullptr);
      run(request);
    }
  for (const int stream : request.streams)
    close(stream);
  if (process < 0 || !fork_server::write_all(connection, &process, sizeof(process)))
    return;
  pollfd events[] = {{connection, POLLIN, 0}, {ended, POLLIN, 0}};
  while (poll(events, 2, -1) < 0 && errno == EINTR)
    ;
  if (events[1].revents == 0)
    kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  fork_server::write_all(connection, &status, sizeof(status));
}

int
serve(int, char **, char **)
{
  signal(SIGCHLD, SIG_IGN); // nobody waits for those that answer
  pollfd asked = {fork_server::listening, POLLIN, 0};
  while (poll(&asked, 1, fork_server::idle_milliseconds) > 0)
    {
      const int connection = accept4(fork_server::listening, nullptr, nullptr, SOCK_CLOEXEC);
      if (connection < 0)
        continue;
      if (fork() == 0)
        {
          close(fork_server::listening);
          signal(SIGCHLD, SIG_DFL);
          answer(connection);
          _exit(0);
        }
      close(connection);
    }
  _exit(0);
}
} // namespace

extern "C" int
__libc_start_main(
    Main *main, int argc, char **argv, void (*init)(), void (*fini)(), void (*linker_fini)(), void *stack_end)
{
  program             = main;
  const auto original = reinterpret_cast<decltype(&__libc_start_main)>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return original(serve, argc, argv, init, fini, linker_fini, stack_end);
}

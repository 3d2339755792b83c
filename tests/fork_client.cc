// fork_client PROGRAM ARGUMENT...: runs the program as if it were started here, as a fork of a server
// (fork_server.cc) that has its libraries linked already. Ends as the run ends, by the same code or signal;
// signals that ask for an end are passed on, and a killed client takes its run along. The server of a
// program, that of its last build, is started by the first client and ends by itself.
#include "fork_server.h"

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>

namespace
{
volatile pid_t process = 0;

void
pass_on(const int signal)
{
  if (process > 0)
    kill(process, signal);
}

/// Listens at the socket @p listening with a copy of @p program, which nobody waits for.
void
start_server(const int listening, const char *program)
{
  const pid_t child = fork();
  if (child == 0)
    {
      if (setpgid(0, 0) != 0 || fork() != 0)
        _exit(0);
      std::string library(4096, '\0');
      library.resize(std::max<ssize_t>(readlink("/proc/self/exe", library.data(), library.size()), 0));
      library.replace(library.rfind('/') + 1, std::string::npos, "libfork_server.so");
      setenv("LD_PRELOAD", library.c_str(), 1);
      const int none = open("/dev/null", O_RDWR), socket = fcntl(listening, F_DUPFD, 10);
      for (int stream = 0; stream < 3; ++stream)
        dup2(none, stream);
      dup2(socket, fork_server::listening);
      for (int file = fork_server::listening + 1; file < 256; ++file)
        close(file);
      if (chdir("/") == 0)
        execl(program, program, static_cast<char *>(nullptr));
      _exit(127);
    }
  waitpid(child, nullptr, 0);
}

/// A connection to the server of @p program, which is started if there is none. -1: not to be had now.
int
connect_to(const char *program)
{
  struct stat file;
  if (stat(program, &file) != 0)
    return -1;
  // An abstract name: it goes with the server.
  sockaddr_un address = {};
  address.sun_family  = AF_UNIX;
  const int   length  = snprintf(address.sun_path + 1,
                              sizeof(address.sun_path) - 1,
                              "amontons-%ld-%ld-%ld-%ld.%ld",
                              static_cast<long>(getuid()),
                              static_cast<long>(file.st_dev),
                              static_cast<long>(file.st_ino),
                              static_cast<long>(file.st_mtim.tv_sec),
                              static_cast<long>(file.st_mtim.tv_nsec));
  const auto *name    = reinterpret_cast<const sockaddr *>(&address);
  const auto  size    = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
  const int   client  = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (connect(client, name, size) == 0)
    return client;
  const int listening = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (bind(listening, name, size) == 0 && listen(listening, 64) == 0)
    start_server(listening, program);
  close(listening);
  if (connect(client, name, size) == 0)
    return client;
  close(client);
  return -1;
}
} // namespace

int
main(int argc, char **argv)
{
  if (argc < 2)
    return fprintf(stderr, "fork_client PROGRAM ARGUMENT...\n"), 2;
  char                 folder[4096];
  fork_server::Request request;
  request.folder = getcwd(folder, sizeof(folder)) == nullptr ? "/" : folder;
  request.arguments.assign(argv + 1, argv + argc);
  for (char **variable = environ; *variable != nullptr; ++variable)
    request.environment.emplace_back(*variable);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP})
    std::signal(signal, pass_on);

  // A server that is about to end, or another client's that is not there yet, does not answer: asked again.
  for (int attempt = 0; attempt < 100; ++attempt)
    {
      const int connection = connect_to(argv[1]);
      pid_t     started    = 0;
      int       status     = 0;
      if (connection >= 0 && fork_server::send_request(connection, request) &&
          fork_server::read_all(connection, &started, sizeof(started)))
        {
          process = started;
          if (!fork_server::read_all(connection, &status, sizeof(status)))
            return fprintf(stderr, "fork_client: the server of %s ended\n", argv[1]), 125;
          if (WIFEXITED(status))
            return WEXITSTATUS(status);
          const rlimit no_core = {0, 0};
          setrlimit(RLIMIT_CORE, &no_core);
          std::signal(WTERMSIG(status), SIG_DFL);
          raise(WTERMSIG(status));
          return 128 + WTERMSIG(status);
        }
      if (connection >= 0)
        close(connection);
      usleep(10000);
    }
  // Without a server, as everybody starts it.
  for (const int signal : {SIGTERM, SIGINT, SIGHUP})
    std::signal(signal, SIG_DFL);
  execv(argv[1], argv + 1);
  perror(argv[1]);
  return 127;
}

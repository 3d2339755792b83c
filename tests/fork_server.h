// What fork_client.cc and fork_server.cc say to each other: the client sends the three standard streams and a
// Request; the server answers with the number of the process (pid_t) and, when it has ended, its status as of
// waitpid() (int).
#ifndef amontons_tests_fork_server_h
#define amontons_tests_fork_server_h

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace fork_server
{
constexpr int listening         = 3;     ///< file descriptor of the socket at which the server listens
constexpr int idle_milliseconds = 20000; ///< after so long without a run it ends

struct Request
{
  std::array<int, 3>       streams = {0, 1, 2}; ///< input, output, errors: file descriptors
  std::string              folder;              ///< in which the run begins
  std::vector<std::string> arguments;           ///< with the program's name first
  std::vector<std::string> environment;         ///< NAME=value
};

inline bool
write_all(const int file, const void *data, std::size_t size)
{
  for (auto *place = static_cast<const char *>(data); size > 0;)
    {
      const ssize_t n = send(file, place, size, MSG_NOSIGNAL);
      if (n <= 0)
        return false;
      place += n;
      size -= n;
    }
  return true;
}

inline bool
read_all(const int file, void *data, const std::size_t size)
{
  return size == 0 || recv(file, data, size, MSG_WAITALL) == static_cast<ssize_t>(size);
}

/// What is sent first: length of the text, numbers of arguments and of variables, beside the streams.
struct Head
{
  std::array<std::uint64_t, 3> sizes                                  = {};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(Request::streams))] = {};
  iovec  part                                                         = {sizes.data(), sizeof(sizes)};
  msghdr message                                                      = {};

  Head()
  {
    message.msg_iov        = &part;
    message.msg_iovlen     = 1;
    message.msg_control    = control;
    message.msg_controllen = sizeof(control);
  }
  Head(const Head &) = delete;
};

/// A Head, then the texts one after the other, each ended by a zero.
inline bool
send_request(const int connection, const Request &request)
{
  std::string text = request.folder + '\0';
  for (const auto *list : {&request.arguments, &request.environment})
    for (const std::string &entry : *list)
      text += entry + '\0';
  Head head;
  head.sizes         = {text.size(), request.arguments.size(), request.environment.size()};
  cmsghdr *rights    = CMSG_FIRSTHDR(&head.message);
  rights->cmsg_level = SOL_SOCKET;
  rights->cmsg_type  = SCM_RIGHTS;
  rights->cmsg_len   = CMSG_LEN(sizeof(request.streams));
  std::memcpy(CMSG_DATA(rights), request.streams.data(), sizeof(request.streams));
  return sendmsg(connection, &head.message, MSG_NOSIGNAL) == static_cast<ssize_t>(sizeof(head.sizes)) &&
         write_all(connection, text.data(), text.size());
}

/// The counterpart of send_request(). False: whoever asked is gone.
inline bool
receive(const int connection, Request &request)
{
  Head head;
  if (recvmsg(connection, &head.message, MSG_WAITALL) != static_cast<ssize_t>(sizeof(head.sizes)) ||
      CMSG_FIRSTHDR(&head.message) == nullptr)
    return false;
  std::memcpy(request.streams.data(), CMSG_DATA(CMSG_FIRSTHDR(&head.message)), sizeof(request.streams));
  std::string text(head.sizes[0], '\0');
  if (!read_all(connection, text.data(), text.size()))
    return false;
  std::size_t place = 0;
  const auto  next  = [&]() {
    std::string entry(text.c_str() + place);
    place += entry.size() + 1;
    return entry;
  };
  request.folder = next();
  for (std::size_t n = 0; n < head.sizes[1]; ++n)
    request.arguments.push_back(next());
  for (std::size_t n = 0; n < head.sizes[2]; ++n)
    request.environment.push_back(next());
  return true;
}
} // namespace fork_server
#endif

#include <amontons/output/files.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace Amontons
{
  namespace
  {
    // Into a new file, whatever had this name before; errno says why not.
    bool
    write_new_file(const std::string &file, const std::string &text, const bool to_disk)
    {
      unlink(file.c_str());
      const int stream = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
      if (stream < 0)
        return false;
      std::size_t done = 0;
      while (done < text.size())
        {
          const ssize_t n = write(stream, text.data() + done, text.size() - done);
          if (n < 0 && errno != EINTR)
            break;
          done += n > 0 ? n : 0;
        }
      const bool is_written = done == text.size() && (!to_disk || fsync(stream) == 0 || errno == EINVAL);
      const int  failure    = is_written ? 0 : errno;
      if (close(stream) == 0 && failure == 0)
        return true;
      errno = failure != 0 ? failure : errno;
      return false;
    }
  } // namespace

  void
  write_file(const std::string &file, const std::string &text, const bool to_disk)
  {
    const std::string aside = file + ".tmp";
    if (write_new_file(aside, text, to_disk) && std::rename(aside.c_str(), file.c_str()) == 0)
      return;
    const std::string why = std::strerror(errno);
    std::remove(aside.c_str());
    throw InputError({file, 0, ""},
                     "cannot write this file (" + why + ")",
                     "an output folder with space that you may write to");
  }

  std::string
  csv_field(const std::string &text)
  {
    if (text.find_first_of(",\"\n") == std::string::npos)
      return text;
    std::string result = "\"";
    for (const char c : text)
      result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
  }
} // namespace Amontons

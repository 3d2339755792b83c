#include <amontons/base/text_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Amontons
{
  std::string
  read_text_file(const std::string    &file,
                 const SourceLocation &place,
                 const std::string    &what,
                 const std::string    &allowed,
                 const std::size_t     most)
  {
    std::error_code error;
    const bool      exists = std::filesystem::exists(file, error);
    if (exists && !std::filesystem::is_regular_file(file, error))
      throw InputError(place, what + " '" + file + "' cannot be opened: it is no regular file", allowed);
    std::ifstream stream;
    if (exists)
      stream.open(file, std::ios::binary);
    if (!exists || !stream)
      throw InputError(place, what + " '" + file + "' cannot be opened", allowed);
    if (std::filesystem::file_size(file, error) > most)
      throw InputError(
          place, what + " '" + file + "' is larger than " + std::to_string(most >> 20) + " MB", allowed);
    std::ostringstream content;
    content << stream.rdbuf();
    return content.str();
  }
} // namespace Amontons

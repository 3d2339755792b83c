/// Files that a user names.
#pragma once

#include <amontons/base/input_error.h>

#include <cstddef>

namespace Amontons
{
  /// All of it. Throws InputError at `place`: there is none, it is no regular file (folders, devices and
  /// pipes are refused before they are opened), or it has more than `most` bytes. what: "the file",
  /// "the mesh file".
  std::string
  read_text_file(const std::string    &file,
                 const SourceLocation &place,
                 const std::string    &what,
                 const std::string    &allowed,
                 const std::size_t     most);
} // namespace Amontons

// Writing to the output folder. What cannot be written is the user's to know: InputError.
#pragma once

#include <amontons/base/input_error.h>

#include <string>

namespace Amontons
{
  // Writes aside (file.tmp) and renames, so that a file is never half-written, and never through a link. Not
  // collective. to_disk: returns once it is there, so that a machine that stops leaves no damaged file.
  void
  write_file(const std::string &file, const std::string &text, const bool to_disk = false);

  // Text as a field of a CSV file: quoted where it holds a comma or a quote.
  std::string
  csv_field(const std::string &text);
} // namespace Amontons

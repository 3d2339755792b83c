// The one exception for what a user wrote: it carries the place, what was found and what is allowed.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace Amontons
{
  // A place in an input file. line = 0: no line is known (JSON, command line); `entry` then names it.
  struct SourceLocation
  {
    std::string file;
    int         line = 0;
    std::string entry; // "Body lower/Material/Poisson ratio"
  };

  // what() is one line: "FILE:LINE: ENTRY: FOUND; ALLOWED", less than 2 kB of valid UTF-8 (other bytes as
  // \\xNN), with 80 characters at most of what is 'quoted'.
  class InputError : public std::runtime_error
  {
  public:
    InputError(const SourceLocation &where, const std::string &found, const std::string &allowed = "");
  };

  // One line of UTF-8 without characters that control a terminal.
  bool
  is_printable(const std::string &text);

  // The `candidates` entry nearest to `word` by edit distance, as " (did you mean 'X'?)", or "" if none is
  // near.
  std::string
  suggestion(const std::string &word, const std::vector<std::string> &candidates);
} // namespace Amontons

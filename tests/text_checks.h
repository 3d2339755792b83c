// Checks of what is printed or written.
#pragma once

#include "check.h"

#include <string>

namespace check
{
inline unsigned int
count(const std::string &text, const std::string &part)
{
  unsigned int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

inline void
contains(const std::string &text, const std::string &part)
{
  is_true(text.find(part) != std::string::npos, "'" + text + "' contains '" + part + "'");
}
} // namespace check

// Checks for unit tests: each failed check prints its place and values, and the program returns 1 in the end.
#pragma once

#include <cmath>
#include <iostream>
#include <string>

namespace check
{
inline int &
failures()
{
  static int n = 0;
  return n;
}

inline unsigned long &
checks()
{
  static unsigned long n = 0;
  return n;
}

inline void
is_true(const bool condition, const std::string &what)
{
  ++checks();
  if (!condition)
    {
      ++failures();
      std::cerr << "FAILED: " << what << std::endl;
    }
}

// |value - expected| <= tolerance * max(|expected|, scale)
inline void
is_close(const double       value,
         const double       expected,
         const double       tolerance,
         const std::string &what,
         const double       scale = 0)
{
  ++checks();
  if (!(std::abs(value - expected) <= tolerance * std::max(std::abs(expected), scale)))
    {
      ++failures();
      std::cerr.precision(15);
      std::cerr << "FAILED: " << what << ": " << value << ", expected " << expected << " within " << tolerance
                << std::endl;
    }
}

inline int
result()
{
  if (failures() == 0)
    std::cout << "all " << checks() << " checks hold" << std::endl;
  return failures() == 0 ? 0 : 1;
}
} // namespace check

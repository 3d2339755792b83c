// Which Amontons this is. Both are written by version.cmake.
#pragma once

namespace Amontons
{
  extern const char *const version; // of CMakeLists.txt
  extern const char *const commit;  // empty where the sources are no checkout
} // namespace Amontons

/// Libraries that say on std::cerr what they also return or throw.
#pragma once

#include <iostream>

namespace Amontons
{
  /// While it lives, nothing is printed on std::cerr.
  class SilentErrors
  {
  public:
    SilentErrors() : buffer(std::cerr.rdbuf(nullptr)) {}
    ~SilentErrors()
    {
      std::cerr.rdbuf(buffer);
      std::cerr.clear();
    }
    SilentErrors(const SilentErrors &) = delete;
    SilentErrors &
    operator=(const SilentErrors &) = delete;

  private:
    std::streambuf *buffer;
  };
} // namespace Amontons

/// A folder of this process alone.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace Amontons
{
  /// In that for temporary files; removed in the end. Where none can be made, `path` is the latter.
  struct TemporaryFolder
  {
    TemporaryFolder() : path(std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp")
    {
      std::string name = path + "/amontons-XXXXXX";
      made             = mkdtemp(name.data()) != nullptr;
      if (made)
        path = name;
    }
    ~TemporaryFolder()
    {
      std::error_code error;
      if (made)
        std::filesystem::remove_all(path, error);
    }
    TemporaryFolder(const TemporaryFolder &) = delete;
    TemporaryFolder &
    operator=(const TemporaryFolder &) = delete;

    std::string path;

  private:
    bool made = false;
  };
} // namespace Amontons

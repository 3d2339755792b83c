#include <amontons/output/files.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

namespace Amontons
{
  namespace
  {
    std::vector<std::filesystem::path> &
    new_folders() // from the outermost one to the output folder itself; none if that was there
    {
      static std::vector<std::filesystem::path> folders;
      return folders;
    }
  } // namespace

  void
  remove_new_output_folder()
  {
    std::error_code error;
    auto           &folders = new_folders();
    if (!folders.empty())
      std::filesystem::remove_all(folders.back(), error);
    for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder)
      std::filesystem::remove(*folder, error); // only an empty one
    folders.clear();
  }

  void
  keep_output_folder()
  {
    new_folders().clear();
  }

  void
  make_output_folder(const std::string &folder, const MPI_Comm communicator)
  {
    // Rank 0 says how many folders are new; then every rank can remove them.
    std::vector<std::filesystem::path> path;
    for (auto part = std::filesystem::path(folder).lexically_normal();
         !part.empty() && part != part.root_path();
         part = part.parent_path())
      if (part.has_filename())
        path.insert(path.begin(), part);
    int good = 1, n_new = 0;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        for (const auto &part : path)
          n_new += std::filesystem::exists(part, error) ? 0 : 1;
        std::filesystem::create_directories(folder, error);
        const std::string trial = folder + "/.amontons_write_test";
        good                    = std::ofstream(trial).put('\n').flush().good() ? 1 : 0;
        std::filesystem::remove(trial, error);
        // it would say that what this run leaves on the way is a finished answer
        std::filesystem::remove(folder + "/summary.json", error);
      }
    MPI_Bcast(&good, 1, MPI_INT, 0, communicator);
    MPI_Bcast(&n_new, 1, MPI_INT, 0, communicator);
    new_folders().assign(path.end() - n_new, path.end());
    if (good == 0)
      throw InputError({"", 0, "--output " + folder},
                       "this folder cannot be made or written to",
                       "a folder that you may write to");
  }

  void
  write_file(const std::string &file, const std::string &text)
  {
    const std::string aside = file + ".tmp";
    std::ofstream     stream(aside, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream.good() || std::rename(aside.c_str(), file.c_str()) != 0)
      {
        std::remove(aside.c_str());
        throw InputError(
            {file, 0, ""}, "cannot write this file", "an output folder with space that you may write to");
      }
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

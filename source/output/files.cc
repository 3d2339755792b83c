#include <amontons/output/files.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace Amontons
{
  void
  make_output_folder(const std::string &folder, const MPI_Comm communicator)
  {
    int good = 1;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        const std::string trial = folder + "/.amontons_write_test";
        good                    = std::ofstream(trial).put('\n').flush().good() ? 1 : 0;
        std::filesystem::remove(trial, error);
      }
    MPI_Bcast(&good, 1, MPI_INT, 0, communicator);
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

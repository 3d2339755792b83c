// Writing to the output folder. What cannot be written is the user's to know: InputError.
#pragma once

#include <amontons/base/input_error.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace Amontons
{
  // Makes the folder with its parents. Collective: all ranks throw if it cannot be made or written to.
  void
  make_output_folder(const std::string &folder, const MPI_Comm communicator);

  // After a run that failed: removes the folder, and the parents, that the last make_output_folder made. A
  // folder that was there before stays. Not collective. After success, keep_output_folder: the folder is now
  // the user's.
  void
  remove_new_output_folder();
  void
  keep_output_folder();

  // Writes aside (file.tmp) and renames, so that a file is never half-written. Not collective.
  void
  write_file(const std::string &file, const std::string &text);

  // Text as a field of a CSV file: quoted where it holds a comma or a quote.
  std::string
  csv_field(const std::string &text);
} // namespace Amontons

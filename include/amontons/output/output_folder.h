/// The folder that a run writes into. It holds one run, and one process writes into it.
#pragma once

#include <amontons/base/input_error.h>

#include <deal.II/base/mpi.h>

#include <string>

namespace Amontons
{
  /// Makes the folder with its parents, and locks it as long as this process has it (.lock, with the process
  /// and the host). What an earlier run has left there moves to earlier_run/ (after a run that ended and
  /// one that did not: unfinished_run/), where it stays until this run has ended; if this run goes on with
  /// that one, all but its checkpoint and its log. Again for the same folder: nothing. Collective: all ranks
  /// throw InputError if it cannot be made or written to, or if another process has it.
  void
  make_output_folder(const std::string &folder, const MPI_Comm communicator, const bool goes_on = false);

  /// The folder is the user's; what was there before is removed, if the run has ended. Not collective.
  void
  keep_output_folder(const bool has_ended = true);

  /// What an earlier try of the load program has left: files name_NNNN.EXT and name_NNNN.RANK.EXT of number
  /// `first` and more, extension: a regular expression. Not collective.
  void
  remove_later_files(const std::string &folder,
                     const std::string &name,
                     const std::string &extension,
                     const unsigned int first);

  /// The run has failed: if it has neither history nor checkpoint, all is as it was before the last
  /// make_output_folder. Not collective.
  void
  remove_new_output_folder();
} // namespace Amontons

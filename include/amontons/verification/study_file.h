/// What the file of a convergence study says: a scene, the parameters to sweep, and what to show. An example
/// is in convergence_study.h.
#pragma once

#include <amontons/verification/study_entries.h>

#include <string>
#include <vector>

namespace Amontons
{
  struct Study
  {
    std::string                 file, title, scene, output_directory;
    std::vector<SweptParameter> sweep; // the last one varies along the rows of a table (unless per_mesh)
    std::vector<std::string>    overrides;
    std::vector<SummaryPath>    columns, quantities;
    bool                        against_finest = false;
    bool                        per_mesh       = false;
    SourceLocation              columns_where, quantities_where;
  };

  // Throws InputError with the line of the entry.
  Study
  read_study(const std::string &file);
} // namespace Amontons

// What a study file says: a scene, the parameters to sweep, and what to show. An example is in
// convergence_study.h.
#pragma once

#include <string>
#include <vector>

#include <amontons/base/input_error.h>

namespace Amontons
{
  // "Body a/Refinements & Body b/Refinements: 1, 2, 3": all `names` take the same value.
  struct SweptParameter
  {
    std::vector<std::string> names, values;
    std::string              label; // "Refinements"
  };

  // A number of summary.json.
  struct SummaryPath
  {
    std::string path, label; // "reference.errors.contact_size", "contact_size"
  };

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

#include <amontons/verification/study_file.h>

#include <algorithm>

namespace Amontons
{
  Study
  read_study(const std::string &file)
  {
    const StudyEntries entries(file);
    Study              study;
    study.file             = file;
    study.title            = entries.or_stem("Title");
    study.output_directory = entries.or_stem("Output");
    study.against_finest   = entries.choice("Against", {"closed form", "finest"}) == "finest";
    study.per_mesh         = entries.is_true("Per mesh");
    study.overrides        = entries.overrides("");
    study.quantities_where = entries.where("", "Quantities");
    study.columns_where    = entries.where("", "Columns");
    study.quantities       = entries.paths("Quantities");
    study.columns          = entries.paths("Columns",
                                  study.per_mesh ? "cells, dofs, seconds"
                                                          : "cells, dofs, finest_mesh_seconds, wall_seconds");
    if (study.quantities.empty())
      throw InputError(
          study.quantities_where, "no quantity is given", "paths in summary.json, separated by commas");
    if (std::none_of(
            study.columns.begin(), study.columns.end(), [](const auto &c) { return c.label == "dofs"; }))
      throw InputError(
          study.columns_where, "the column 'dofs' is missing", "columns among which are the dofs");
    study.scene = entries.scene();
    study.sweep = entries.sweep(entries.number_up_to("Vary", StudyEntries::max_swept));
    if (study.sweep.empty() && !study.per_mesh)
      throw InputError({file, 0, "Sweep"}, "nothing is swept", "entries '1' to '4', or Per mesh = true");
    return study;
  }
} // namespace Amontons

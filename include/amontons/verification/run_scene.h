/// A scene from its file to its answer, with all that it is compared with.
#pragma once

#include <amontons/output/summary.h>
#include <amontons/run_control.h>

namespace Amontons
{
  struct SceneRun
  {
    std::string              scene;     // file
    std::vector<std::string> overrides; // as of --set
    std::string              folder;    // for its output, made if need be
    bool                     quiet   = false;
    bool                     resumes = false; // goes on from the checkpoint in the folder
  };

  /// Collective. Throws InputError; a failed iteration is in the summary's status. control: of the process.
  RunSummary
  run_scene(const SceneRun &run, RunControl &control);
} // namespace Amontons

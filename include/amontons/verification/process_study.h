/// A study whose runs are processes of their own: runs what is not known yet, prints and draws.
#pragma once

#include <amontons/verification/run_pool.h>
#include <amontons/verification/run_record.h>

#include <ostream>

namespace Amontons
{
  struct StudyOptions
  {
    std::string  output; // instead of the study's `Output`; empty: that
    unsigned int n_jobs = 1;
  };

  /// A point of a study with its run.
  struct StudyResult
  {
    StudyPoint          point;
    RunRecord           record;
    std::vector<double> errors; // of the study's quantities
  };

  /// On one rank. Results are appended to STUDY.csv in the output folder; those that stand there are not run
  /// again. Returns 0; 1 if a file could not be written; 128 + N if signal N stopped it. Throws InputError
  /// for errors in the study file.
  int
  run_process_study(const StudyEntries &entries,
                    const StudyOptions &options,
                    const RunProcess   &run,
                    std::ostream       &out);
} // namespace Amontons

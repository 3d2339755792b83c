/// What a study keeps of a run, and the line of a CSV file that it is.
#pragma once

#include <amontons/verification/run_process.h>
#include <amontons/verification/run_study.h>

namespace Amontons
{
  struct RunRecord
  {
    std::string ending;  // "converged", "not converged", "refused" (input), "time limit", "crash"
    std::string failure; // kind, see Diagnosis::kind
    std::string message;

    unsigned int        increments = 0, cut_backs = 0, iterations = 0, linear_solves = 0;
    unsigned long long  cells = 0, dofs = 0;
    double              wall_seconds = 0, processor_seconds = 0, megabytes = 0;
    std::vector<double> values; // of the study's quantities; NaN where there is none
  };

  /// Of a run that was not stopped. Throws InputError where a run converged whose summary has not a quantity.
  RunRecord
  make_record(const RunStudy &study, const RunEnd &end);

  /// "ending", "failure", ...: the fields below; without the key.
  std::vector<std::string>
  record_header(const RunStudy &study);
  std::vector<std::string>
  to_fields(const RunRecord &record);
  /// Nothing where these are no fields of a record.
  std::optional<RunRecord>
  from_fields(const RunStudy &study, const std::vector<std::string> &fields);

  /// Of each quantity: its absolute value, or how far it is from what is expected, relative to that (where
  /// that is zero: as it is). NaN where it is not known.
  std::vector<double>
  errors_of(const RunStudy &study, const StudyPoint &point, const RunRecord &record);
} // namespace Amontons

/// How much does an answer of a given error cost? Curves of error against cost, the Pareto front of all of
/// them, and the cheapest run of each that reaches a target.
#pragma once

#include <amontons/verification/process_study.h>

#include <array>

namespace Amontons
{
  /// What a run costs, as shown.
  struct CostKind
  {
    const char *name;
    double (*of)(const RunRecord &);
  };
  extern const std::array<CostKind, 4> cost_kinds; // processor seconds first

  /// The results of a series and of one value of all swept parameters but the last.
  struct WorkCurve
  {
    std::string                      label;
    std::vector<const StudyResult *> runs;
  };
  std::vector<WorkCurve>
  work_curves(const RunStudy &study, const std::vector<StudyResult> &results);

  /// Whether a run converged, so that its errors count.
  bool
  has_answer(const StudyResult &result);

  struct CostAndError
  {
    double cost, error;
  };
  /// Those than which no other one is better in one and not worse in the other, by increasing cost; as
  /// numbers. Only positive finite errors count.
  std::vector<unsigned int>
  pareto_front(const std::vector<CostAndError> &runs);

  /// The run of least processor time whose error of this quantity is at most `target`; nullptr if none.
  const StudyResult *
  cheapest(const WorkCurve &curve, const unsigned int quantity, const double target);

  void
  print_work_precision(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out);

  /// STEM.gp: a row of panels for each quantity, a panel for each cost.
  void
  write_work_script(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out);

  /// Prints, and draws beside the CSV. Returns whether files could be written.
  bool
  show_work_precision(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out);
} // namespace Amontons

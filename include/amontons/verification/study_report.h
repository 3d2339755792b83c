/// STEM.html: what a study says on one page that needs no other file: what was swept, the chart, all runs,
/// what failed and why, and how to run it again.
#pragma once

#include <amontons/output/html.h>
#include <amontons/verification/stability_map.h>
#include <amontons/verification/study_output.h>

namespace Amontons
{
  /// In the folder of the study; says so on `out`. command: repeats it. Return whether the file could be
  /// written.
  bool
  write_report(const Study                    &study,
               const std::vector<StudySeries> &all_series,
               const std::string              &command,
               std::ostream                   &out);
  bool
  write_report(const RunStudy                 &study,
               const std::vector<StudyResult> &results,
               const std::string              &command,
               std::ostream                   &out);

  /// "amontons SCENE --set '...' ...", in the words of a shell.
  std::string
  command_of(const std::string &scene, const std::vector<std::string> &overrides);

  /// "Amontons, Steps = 4, Friction = 0.7".
  std::string
  name_of(const RunStudy &study, const StudyPoint &point);

  /// Rows of the table that says what was run; the command below.
  std::string
  what_was_run(const std::string                                      &scene,
               const std::vector<SweptParameter>                      &sweep,
               const std::vector<std::string>                         &overrides,
               const std::vector<std::pair<std::string, std::string>> &more,
               const std::string                                      &command);

  /// Of stability: a coloured grid per panel; what is wrong, failed or crashed, with commands.
  std::string
  maps_as_html(const RunStudy &study, const std::vector<StudyResult> &results);

  /// Of work precision: tables of the cheapest runs, and charts of error against cost for where there is no
  /// gnuplot.
  std::string
  targets_as_html(const RunStudy &study, const std::vector<StudyResult> &results);
  std::vector<std::string>
  work_charts(const RunStudy &study, const std::vector<StudyResult> &results);
} // namespace Amontons

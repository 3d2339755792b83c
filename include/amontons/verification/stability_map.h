/// Where is a scene solved, and where not: the outcome of each point of a study, as a grid.
#pragma once

#include <amontons/verification/process_study.h>

#include <array>

namespace Amontons
{
  enum class Outcome
  {
    solved,
    cut_back, // solved, with more increments than asked for
    refused,  // says why there is no answer
    failed,   // says that none was found
    wrong,    // says converged, but the answer is another one
    time_limit,
    crash
  };

  struct OutcomeStyle
  {
    Outcome     outcome;
    char        letter;
    const char *name;
    const char *colour;
  };
  extern const std::array<OutcomeStyle, 7> outcome_styles; // in the order of Outcome

  /// Where there is no solution, "converged" is wrong; where it is known that there is one, a refusal is a
  /// failure. Errors that are not known are wrong.
  Outcome
  outcome_of(const RunStudy &study, const StudyResult &result);

  /// Which quantities are off, and how far; empty where none is.
  std::string
  what_is_off(const RunStudy &study, const StudyResult &result);

  /// In a cell of the map. Solved: the number of iterations; wrong: the error; else the letter.
  std::string
  cell_text(const RunStudy &study, const StudyResult &result);

  /// The results of one series and one value of the third parameter.
  struct MapPanel
  {
    std::string                                   title;
    std::vector<std::vector<const StudyResult *>> cells; // [y][x], nullptr where not run
  };
  std::vector<MapPanel>
  map_panels(const RunStudy &study, const std::vector<StudyResult> &results);

  /// Grids of letters with legend and counts; then what is wrong, with the command that shows it.
  void
  print_maps(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out);

  /// STEM.gp: a coloured grid for each panel, with the study's thresholds.
  void
  write_map_script(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out);

  /// Prints, and draws beside the CSV. Returns whether files could be written.
  bool
  show_stability_map(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out);
} // namespace Amontons

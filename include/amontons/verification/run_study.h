/// `amontons study FILE` of the kinds `work precision` and `stability`: many runs, each a process of its own.
// clang-format off
//
//   set Kind       = stability                # or: work precision
//   set Title      = Floating slab
//   set Scene      = ../floating_slab.prm     # relative to this file
//   set Output     = studies/slab             # relative to the working directory; default: name of this file
//   set Overrides  = Refinement/Cycles = 0    # of all runs; neither VTU nor report are written
//   set Quantities = reference.errors.contact_size        # errors: numbers of summary.json
//   set Expected   = pairs.0.normal_force.1 = 800 | pairs.0.tangential_force.0 = -60*x  # numbers, and what they should be
//   set Time limit = 60                       # processor seconds for each run
//   subsection Sweep                          # x and y are the values of 1 and 2 (z: of 3)
//     set 1       = Contact base/Friction coefficient: 0.01, 0.1, 1
//     set 2       = Boundary condition weight/Value = {}*t & Boundary condition push/Value = 0.3*{}*t: 1 | 10 | 100
//     set Label 2 = pressure                  # default: the last component of the name
//   end
//   subsection Series Amontons (dual mortar)  # names are legends of curves, titles of maps
//     set Overrides = Contact solver/Method = mortar
//   end
//
// work precision: a curve for each series and each combination of all swept parameters but the last (or `set Vary = 1`)
//   set Targets = 0.1, 0.01                   # which run of each series reaches this error at the least cost?
//
// stability: a map over the parameters 1 and 2, for each series and each value of 3
//   set Wrong above       = 0.01              # converged, but with a larger error
//   set No solution where = x - 0.15          # positive: converged is wrong there; else: a refusal is a failure
//   set Threshold         = T/N = 0.15: 0.15  # y of x, a curve in the map; several separated by |
//
// clang-format on
#pragma once

#include <amontons/scene/expression.h>
#include <amontons/verification/study_entries.h>

#include <optional>

namespace Amontons
{
  struct StudyQuantity
  {
    SummaryPath               path;
    std::optional<Expression> expected; // of x, y, z; none: the number is an error itself
    SourceLocation            where;
  };

  struct NamedSeries
  {
    std::string              name; // empty: there is only this one
    std::vector<std::string> overrides;
  };

  struct Threshold
  {
    std::string label;
    Expression  y; // of x
  };

  struct RunStudy
  {
    StudyKind                   kind = StudyKind::stability;
    std::string                 file, title, scene, output_directory;
    std::vector<std::string>    overrides;
    std::vector<SweptParameter> sweep;  // work precision: the last one varies along the curves
    std::vector<NamedSeries>    series; // at least one
    std::vector<StudyQuantity>  quantities;
    double                      time_limit = 60;
    std::vector<double>         targets;
    double                      wrong_above = 0.01;
    std::optional<Expression>   no_solution_where;
    std::vector<Threshold>      thresholds;

    std::string
    stem() const; // of the files that it writes
  };

  /// A combination: a series and a value of each swept parameter, as indices.
  struct StudyPoint
  {
    unsigned int              series = 0;
    std::vector<unsigned int> values;
  };

  /// Throws InputError with the line of the entry.
  RunStudy
  read_run_study(const StudyEntries &entries);

  /// All combinations; the last swept parameter runs fastest.
  std::vector<StudyPoint>
  points_of(const RunStudy &study);

  /// The name of the series and the values: what tells points apart.
  std::vector<std::string>
  key_of(const RunStudy &study, const StudyPoint &point);

  std::vector<std::string>
  overrides_of(const RunStudy &study, const StudyPoint &point);

  /// The number that value i of a swept parameter is, NaN if it is none.
  double
  number_of(const SweptParameter &parameter, const unsigned int i);

  /// The expression at the values of the swept parameters, those that are no numbers being zero.
  double
  evaluate(const Expression &expression, const RunStudy &study, const StudyPoint &point);
} // namespace Amontons

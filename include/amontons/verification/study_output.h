// Tables, CSV and chart of a study.
#pragma once

#include <amontons/verification/study_file.h>

#include <ostream>

namespace Amontons
{
  struct StudyRow
  {
    std::string         varied;  // value of the varied parameter, or number of the mesh
    std::vector<double> columns; // as in Study::columns
    std::vector<double> errors;  // as in Study::quantities
  };

  struct FailedRun
  {
    std::string              varied, message;
    std::vector<std::string> overrides;
  };

  // The rows of one table and one curve per quantity.
  struct StudySeries
  {
    std::string            label; // "Degree = 2", empty if there is only one
    unsigned int           dim = 2;
    std::vector<StudyRow>  rows;
    std::vector<FailedRun> failures;
  };

  // Of what varies along the rows: "mesh", "Refinements".
  std::string
  varied_name(const Study &study);

  // dim log(e1/e2) / log(n2/n1), the order in h on meshes of n1 and n2 unknowns; NaN where there is none.
  double
  observed_order(const double e1, const double e2, const double n1, const double n2, const unsigned int dim);

  void
  print_tables(const Study &study, const std::vector<StudySeries> &all_series, std::ostream &out);

  // STEM.csv, STEM.gp and, if gnuplot is there, STEM.svg and STEM.png in the study's output directory; says
  // on `out` what it wrote. Returns whether all could be written (a missing gnuplot is no failure).
  bool
  write_study_files(const Study &study, const std::vector<StudySeries> &all_series, std::ostream &out);

  // A gnuplot script (gnuplot.h): errors against cells, DoFs and seconds.
  void
  write_gnuplot_script(const Study                    &study,
                       const std::vector<StudySeries> &all_series,
                       const std::string              &stem,
                       std::ostream                   &out);
} // namespace Amontons

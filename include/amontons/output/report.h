// report.html: the answer with pictures, in one file that needs no other.
#pragma once

#include <amontons/output/contact_csv.h>
#include <amontons/output/mesh_picture.h>
#include <amontons/output/summary.h>
#include <amontons/output/svg_chart.h>
#include <amontons/scene/reference_solution.h>

namespace Amontons
{
  // Pressure along one pair. 2D: over the arc length from the contact's centre; 3D: over the distance from
  // it, as points.
  struct PressureCurve
  {
    std::string         pair;
    bool                radial = false;
    std::vector<double> s, pressure;
    std::string         exact_name; // empty: no closed form
    std::vector<double> exact_s, exact_pressure;
    Point<3>            centre;    // of the contact, current position
    double              shown = 0; // |s| up to which the picture goes; 0: all
  };

  // table: contact_table(...); pairs: in the same order. `exact` describes the pair `exact_pair` (empty: the
  // first).
  std::vector<PressureCurve>
  pressure_curves(const std::vector<ContactNode> &table,
                  const std::vector<PairSummary> &pairs,
                  const int                       dim,
                  const ReferenceSolution        *exact      = nullptr,
                  const std::string              &exact_pair = "");

  // Changes by iteration, a curve per mesh of the last increment that took several; errors and estimates by
  // DoFs, without rounding errors.
  Chart
  iteration_chart(const RunSummary &summary);
  Chart
  error_chart(const RunSummary &summary);
  Chart
  pressure_chart(const PressureCurve &curve);

  // To be called on rank 0. mesh: of gather_mesh_picture (empty: no such picture); pressure_maps: of
  // make_pressure_picture, with the names of the pairs.
  void
  write_report(const std::string                                      &file,
               const RunSummary                                       &summary,
               const std::vector<PressureCurve>                       &curves,
               const MeshPicture                                      &mesh,
               const std::vector<std::pair<std::string, MeshPicture>> &pressure_maps);
} // namespace Amontons

// report.html: the answer with pictures, in one file that needs no other.
#pragma once

#include <amontons/output/contact_csv.h>
#include <amontons/output/mesh_picture.h>
#include <amontons/output/summary.h>
#include <amontons/output/svg_chart.h>

namespace Amontons
{
  // Pressure, and with friction shear, along one pair. 2D: over the arc length from the contact's centre; 3D:
  // over the distance from it, as points.
  struct PressureCurve
  {
    std::string         pair;
    bool                radial = false;
    std::vector<double> s, pressure;
    std::string         exact_name; // empty: no closed form
    std::vector<double> exact_s, exact_pressure;
    Point<3>            centre;    // of the contact, current position
    double              shown = 0; // |s| up to which the picture goes; 0: all

    // Friction (else empty): the traction on the slave in the direction of the arc length (3D: of the
    // tangential force, to the side where its largest component is positive), the bound of its norm, states;
    // 3D: places of the nodes and tractions in two coordinates. exact_shear: at exact_s, empty: not known.
    std::vector<double>                shear, bound, exact_shear;
    std::vector<ContactStatus>         states;
    std::vector<bool>                  has_multiplier;
    std::vector<std::array<double, 2>> places, tractions;
    std::array<unsigned int, 2>        axes = {{0, 1}};
  };

  // What a pair's curves are compared with: tractions by the distance from the centre of the contact. Empty
  // functions are not known.
  struct ReferenceTractions
  {
    std::string                   pair; // empty: the first
    std::function<double(double)> pressure, shear;
  };

  // table: contact_table(...); pairs: in the same order.
  std::vector<PressureCurve>
  pressure_curves(const std::vector<ContactNode> &table,
                  const std::vector<PairSummary> &pairs,
                  const int                       dim,
                  const ReferenceTractions       &reference = {});

  // Changes by iteration, a curve per mesh of the last increment that took several; errors and estimates by
  // DoFs, without rounding errors.
  Chart
  iteration_chart(const RunSummary &summary);
  Chart
  error_chart(const RunSummary &summary);
  Chart
  pressure_chart(const PressureCurve &curve, const Units &units = {});

  // Of the axes that a surface in space is drawn along.
  std::array<std::string, 2>
  axis_names(const PressureCurve &curve, const Units &units);

  // Friction: shear between its bounds, with the states of the nodes; 3D: the states from above, with the
  // tractions as needles.
  Chart
  shear_chart(const PressureCurve &curve, const Units &units = {});
  Chart
  state_map(const PressureCurve &curve, const Units &units = {});

  // The last pass of the load program through t: of a replay the rows of the last mesh, of increments that
  // were solved on several meshes the last.
  std::vector<const MeshSummary *>
  last_pass(const RunSummary &summary);

  // What happened over t in the last pass (none with a single increment): forces, peak pressures, sizes,
  // work, iterations; tangential force against the displacement of probes.
  std::vector<Chart>
  history_charts(const RunSummary &summary);

  // To be called on rank 0. mesh: of gather_mesh_picture (empty: no such picture); pressure_maps: of
  // make_pressure_picture by pair, along the axes of its curve; bodies: of BodyHistory.
  void
  write_report(const std::string                        &file,
               const RunSummary                         &summary,
               const std::vector<PressureCurve>         &curves,
               const MeshPicture                        &mesh,
               const std::map<std::string, MeshPicture> &pressure_maps,
               const std::vector<std::string>           &bodies = {});
} // namespace Amontons

/// How far the highest pressure of a mesh is from a sharp peak.
#pragma once

#include <amontons/adaptivity/error_estimator.h>

namespace Amontons
{
  struct PeakError
  {
    double error = 0;                ///< relative to the peak; 0: it is smooth, or there is none
    bool   grows = false;            ///< for so long that no mesh is fine enough: n < 5/4, or no limit
    std::vector<unsigned int> faces; ///< of the slave, at the node of the highest pressure
  };

  /// Around the peak of a smooth pressure the mesh is off by next to nothing. Some contacts have a cusp: gaps
  /// |x|^n with 1 < n < 2 a pressure p_0 - c r^(n-1), which may be higher than its highest node by a quarter
  /// of what it falls from there to the next ones. It is one if from there to those twice as far it falls
  /// less than 2^(3/2) times as much. At the tip of a wedge (n = 1) the pressure rises as log 1/r, at a sharp
  /// edge as r^(-1/2): the node of the peak, whose pressure is that of the mesh, does not show it, but those
  /// around it do. Where the scene @p has_axis, more is missing there: see missing_on_the_axis().
  template <int dim>
  PeakError
  peak_error(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields, bool has_axis);

  /// Of all pairs, as `cusp` and, at the cells of both sides, as `quantity_indicators`.
  template <int dim>
  void
  add_error_of_peaks(const Discretization<dim>                &discretization,
                     const std::vector<ContactInterface<dim>> &interfaces,
                     const std::vector<SurfaceFields<dim>>    &fields,
                     ErrorEstimate<dim>                       &estimate);
} // namespace Amontons

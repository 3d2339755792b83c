/// The error of the pressure by faces of the coarse mesh that stand for a curve.
#pragma once

#include <amontons/contact/surface_fields.h>

namespace Amontons
{
  // What facets (see geometry/facets.h) do to the contact of a pair: of the one that leaves the largest error
  // of the gap where they touch that error, kink, step of the curvature and length, and whether it is curved;
  // the gap that the load closes, and the relative L2 error of the pressure.
  struct FacetError
  {
    bool   is_curved = false;
    double angle = 0, step = 0, size = 0, gap = 0, closed_gap = 0, pressure = 0;
  };

  /// doc/introduction.md, (32), over what touches on facets of either side that `Adjust` does not close; the
  /// error of the pressure is squared, and not yet relative. modulus: E* of both bodies. All ranks get the
  /// same.
  template <int dim>
  FacetError
  facet_error(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields, const double modulus);
} // namespace Amontons

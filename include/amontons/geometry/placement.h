// Where a body stands.
#pragma once

#include <amontons/geometry/coarse_mesh.h>

namespace Amontons
{
  // Rotates and shifts the mesh of `body` and its curved geometry. In axisymmetric scenes vertices that
  // rounding has moved off the axis return to it. Throws InputError if the body lies beyond the axis, or
  // turns out of the plane.
  template <int dim>
  void
  place(const BodyData &body, const ProblemType kind, CoarseMesh<dim> &mesh);
} // namespace Amontons

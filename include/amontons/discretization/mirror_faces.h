/// Which faces of a boundary are none of the whole body.
#pragma once

#include <amontons/discretization/discretization.h>
#include <amontons/geometry/facets.h>

namespace Amontons
{
  /// Whether a boundary face lies in a plane of symmetry, or in the axis of revolution: the body goes on
  /// behind it.
  template <int dim>
  IsMirror<dim>
  planes_of_symmetry(const Discretization<dim> &discretization);
} // namespace Amontons

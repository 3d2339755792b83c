// Obstacles that fit between the nodes of a surface.
#pragma once

#include <amontons/geometry/geometry.h>

namespace Amontons
{
  // A round or bounded obstacle of radius r that faces of its pair's boundary would miss: those that it may
  // be closest to are refined until a vertex or the middle of one is within sqrt(2) r of its centre, or they
  // are smaller than 2 r. Not from afar, where it is not known which these are. Collective.
  template <int dim>
  void
  refine_below_small_obstacles(const Scene &scene, Geometry<dim> &geometry);
} // namespace Amontons

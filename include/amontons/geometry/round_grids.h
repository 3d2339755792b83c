// Built-in round shapes: disks, rings, spheres and cylinders, and their pieces.
#pragma once

#include <amontons/geometry/coarse_mesh.h>

namespace Amontons
{
  // The round shape of `body`, one of built_in_shapes(dim), as make_grid() says. Throws InputError.
  template <int dim>
  CoarseMesh<dim>
  make_round_grid(const BodyData &body);
} // namespace Amontons

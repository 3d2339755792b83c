// Built-in shapes: blocks and round shapes as coarse meshes of few cells.
#pragma once

#include <amontons/geometry/coarse_mesh.h>

namespace Amontons
{
  // The shape of `body` in its reference directions, before placement, with the boundaries listed in scene.h.
  // Throws InputError.
  template <int dim>
  CoarseMesh<dim>
  make_grid(const BodyData &body);
} // namespace Amontons

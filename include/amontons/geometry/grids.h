// Built-in shapes: blocks, balls and rings as coarse meshes of few cells.
#pragma once

#include <amontons/geometry/coarse_mesh.h>

namespace Amontons
{
  // The shape of `body` in its reference directions, before placement, with the boundaries listed in scene.h.
  // In 3D, a disk is a ball, the half disk its part z <= 0, and the quarter disk x >= 0, z <= 0. Throws
  // InputError.
  template <int dim>
  CoarseMesh<dim>
  make_grid(const BodyData &body);
} // namespace Amontons

// Boundaries that follow a CAD model.
#pragma once

#include <amontons/geometry/geometry.h>

namespace Amontons
{
  // Gives each face of `boundary` the surface of the CAD face on which it lies, and each line at which the
  // CAD face or the boundary ends the CAD edge there, if there is one (at a cut through the model there is
  // none: the line follows the surface). Vertices that are off by rounding in the mesh file move onto the
  // model. Uses manifold ids from `next_id` on. Throws InputError at the body if a face has vertices farther
  // than 1e-3 of `body_size` from every CAD face.
  void
  attach_cad_manifolds(const Boundary             &boundary,
                       const BodyData             &body,
                       const double                body_size,
                       dealii::types::manifold_id &next_id,
                       dealii::Triangulation<3>   &triangulation);
} // namespace Amontons

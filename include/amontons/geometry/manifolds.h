// The curved geometry of boundaries, which refinement and the mapping follow.
#pragma once

#include <amontons/geometry/geometry.h>

namespace Amontons
{
  // Gives the faces of every curved boundary a manifold (its id is the boundary's id). Before refinement.
  // Throws InputError at the boundary's body if the vertices do not lie on the circle, sphere or cylinder,
  // whose radius they define, within 1e-3 of that radius.
  template <int dim>
  void
  attach_manifolds(const Scene &scene, Geometry<dim> &geometry);

  // Gives all cells of material `body` polar (spherical) coordinates about `centre`, with manifold `id`.
  template <int dim>
  void
  attach_polar_manifold(const dealii::types::material_id body,
                        const Point<3>                  &centre,
                        const dealii::types::manifold_id id,
                        dealii::Triangulation<dim>      &triangulation);
} // namespace Amontons

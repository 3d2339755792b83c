// The curved geometry of boundaries, which refinement and the mapping follow.
#pragma once

#include <amontons/geometry/geometry.h>

namespace Amontons
{
  // Gives the faces of every curved boundary a manifold: its id is the boundary's id, those of CAD models
  // begin with `first_free_id`; returns the next free one. Before refinement. Throws InputError at the
  // boundary's body if the vertices do not lie on the circle, sphere or cylinder, whose radius they define,
  // within 1e-3 of that radius, or on the CAD model.
  template <int dim>
  dealii::types::manifold_id
  attach_manifolds(const Scene                     &scene,
                   const dealii::types::manifold_id first_free_id,
                   Geometry<dim>                   &geometry);

  // Gives all cells of material `body` the polar coordinates of `shape`, a circle, sphere or cylinder, with
  // manifold `id`.
  template <int dim>
  void
  attach_polar_manifold(const dealii::types::material_id body,
                        const TrueGeometry              &shape,
                        const dealii::types::manifold_id id,
                        dealii::Triangulation<dim>      &triangulation);
} // namespace Amontons

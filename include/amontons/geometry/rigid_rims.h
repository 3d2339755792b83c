// Where the faces of rigid bodies end on curves.
#pragma once

#include <amontons/geometry/geometry.h>

namespace Amontons
{
  // In space, of rigid bodies: no error estimate refines these, but where a face that touches ends on a curve
  // (the end of a round punch), the mesh has chords of it. Refined until these turn by no more than about 0.1
  // each: n of them hold 1 - (2 pi/n)^2/6 of the area of a circle, and half of what is missing there is
  // missing of the force that a displacement takes. Collective.
  template <int dim>
  void
  refine_rims_of_rigid_bodies(const Scene &scene, Geometry<dim> &geometry);
} // namespace Amontons

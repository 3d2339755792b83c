// How far two bodies have come closer since they first touched.
#pragma once

#include <amontons/output/quantities.h>

namespace Amontons
{
  // (U_master - U_slave) . e less the smallest initial gap, where e is the direction of the contact force on
  // the slave and U the motion of what holds a body far from the contact: the rigid motion of an obstacle or
  // rigid body (at its reference point), else the mean displacement of the body's boundaries with a platen, a
  // symmetry plane normal to e, or a prescribed displacement along e. Nothing without a contact force, where
  // neither moves (but for an interference), or if a body has no such boundary, one with a displacement
  // field, or if what holds it turns. Collective.
  //
  // It is the approach of the bodies as they are meshed: with a block of half-width = height = H, its far
  // face fixed, in place of a half space it is less by about 0.39 P (1-nu^2) / (E H), which is 0.52 a/H of it
  // for a rigid sphere.
  template <int dim>
  std::optional<double>
  compute_approach(const Answer<dim> &answer, const unsigned int pair);
} // namespace Amontons

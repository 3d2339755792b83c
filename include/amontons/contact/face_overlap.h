// Which part of a slave face lies opposite of a master face or an obstacle, as quadrature points on exact
// segments.
#pragma once

#include <amontons/contact/contact_surface.h>
#include <amontons/contact/coupling.h>
#include <amontons/geometry/rigid_surface.h>

namespace Amontons
{
  // The line x + g n(xi) from the slave face through the master point: xi with (y - x(xi)) x n(xi) = 0,
  // clamped to [0, 1].
  double
  project_to_slave(const ContactSurface<2> &slave, const unsigned int face, const Point<2> &y);

  // Where the line through x along n meets the master face; empty if it misses it.
  std::optional<double>
  project_to_master(const ContactSurface<2> &master,
                    const unsigned int       face,
                    const Point<2>          &x,
                    const Tensor<1, 2>      &n);

  // Appends the points of the common part of the two faces: ends of the master face are projected on to the
  // slave face along its continuous normal field, and the segment between them carries a Gauss formula of
  // n_points points. Faces that look away from each other have no common part. Weights are lengths.
  void
  overlap_faces(const ContactSurface<2>      &slave,
                const unsigned int            slave_face,
                const ContactSurface<2>      &master,
                const unsigned int            master_face,
                const unsigned int            n_points,
                std::vector<OverlapPoint<2>> &points);

  // The same for an obstacle; its edges on the slave face are found by bisection.
  void
  overlap_obstacle(const ContactSurface<2>      &slave,
                   const unsigned int            slave_face,
                   const ObstacleData           &obstacle,
                   const unsigned int            n_points,
                   std::vector<OverlapPoint<2>> &points);
} // namespace Amontons

// Which part of a slave face lies opposite of a master face or an obstacle, as quadrature points on exact
// pieces: segments in 2D, polygons in 3D.
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

  // The same in 3D by Newton's method, not clamped; empty if it does not end within the unit face and a
  // face's width around it.
  std::optional<Point<2>>
  project_to_slave(const ContactSurface<3> &slave, const unsigned int face, const Point<3> &y);

  // Where the line through x along n meets the master face; empty if it misses it. In 3D points up to half a
  // face's width beyond the edges count: the caller knows from the clipping that they belong to this face.
  std::optional<double>
  project_to_master(const ContactSurface<2> &master,
                    const unsigned int       face,
                    const Point<2>          &x,
                    const Tensor<1, 2>      &n);
  std::optional<Point<2>>
  project_to_master(const ContactSurface<3> &master,
                    const unsigned int       face,
                    const Point<3>          &x,
                    const Tensor<1, 3>      &n);

  // Appends the points of the common parts of a slave face and the master faces. Pieces count whole or not at
  // all, so that each keeps a full formula: they do not where all gaps are above `reach`. Faces that look
  // away from each other have no common part. Weights are lengths and areas.
  //
  // 2D: the ends of the master face are projected on to the slave face along its continuous normal field; the
  // segment between them carries a Gauss formula.
  //
  // 3D: pieces are polygons in the plane at the middle of the slave face, normal to it there. The slave face
  // is represented by the bilinear map s(xi) of its corners in that plane, a master vertex by s(xi) of its
  // projection along the normal field. So slave faces are covered without slits, whatever their curvature,
  // since neighbouring master faces share their edges in the plane, and plane faces of any shape exactly. The
  // polygon is the clipped one, cut into triangles; their quadrature points are taken back to xi, x(xi) and
  // along n(xi) to the true master face. On parallelograms the integrand psi phi has degree 4p, and the
  // formula is exact; on others its degree grows with the distortion.
  // least_opposed: minus the cosine between the normals of faces that face each other is at least this.
  void
  overlap_faces(const ContactSurface<2>         &slave,
                const unsigned int               slave_face,
                const ContactSurface<2>         &master,
                const std::vector<unsigned int> &master_faces,
                const double                     search_distance,
                const double                     least_opposed,
                std::vector<OverlapPoint<2>>    &points);
  void
  overlap_faces(const ContactSurface<3>         &slave,
                const unsigned int               slave_face,
                const ContactSurface<3>         &master,
                const std::vector<unsigned int> &master_faces,
                const double                     search_distance,
                const double                     least_opposed,
                std::vector<OverlapPoint<3>>    &points);

  // The same for an obstacle that `motion` has taken to where it is. Its edges on the slave face are found by
  // bisection; in 3D on the edges of a lattice of 8 x 8 squares, and are straight between.
  void
  overlap_obstacle(const ContactSurface<2>      &slave,
                   const unsigned int            slave_face,
                   const ObstacleData           &obstacle,
                   const AffineMap<2>           &motion,
                   const double                  search_distance,
                   std::vector<OverlapPoint<2>> &points);
  void
  overlap_obstacle(const ContactSurface<3>      &slave,
                   const unsigned int            slave_face,
                   const ObstacleData           &obstacle,
                   const AffineMap<3>           &motion,
                   const double                  search_distance,
                   std::vector<OverlapPoint<3>> &points);
} // namespace Amontons

/// What the stress of the master says of the traction on faces of the slave at its edge.
#pragma once

#include <amontons/adaptivity/face_points.h>
#include <amontons/elasticity/loads.h>
#include <amontons/elasticity/stress_recovery.h>

#include <map>

namespace Amontons
{
  /// At the points of the overlap, by their place in the coupling, of slave faces at an edge of the master:
  /// the traction on the slave, -(sigma* m - load on the master), with the recovered stress sigma* of the
  /// master and its outward normal m. At the edge the stress of the slave jumps, inside of its body, which
  /// its own sigma* cannot; the master ends there. Nothing unless face_points.knows_master(). face_loads:
  /// null where none is to be taken off. Collective; all ranks get all.
  template <int dim>
  std::map<unsigned int, Tensor<1, dim>>
  tractions_of_master(const Discretization<dim>   &discretization,
                      const StressRecovery<dim>   &recovery,
                      const ContactInterface<dim> &interface,
                      const FacePoints<dim>       &face_points,
                      const FaceLoads<dim>        *face_loads);

  /// Of the squared error of a slave face, what its master opposite of the point is refined for: one
  /// finer than a quarter of it does less about it (displacements are of second order).
  template <int dim>
  double
  part_of_master(const ContactInterface<dim> &interface, const OverlapPoint<dim> &point);
} // namespace Amontons

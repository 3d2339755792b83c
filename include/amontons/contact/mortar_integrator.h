// Dual mortar integrals of one pair: from overlaps to one coupling row per multiplier.
#pragma once

#include <amontons/contact/contact_surface.h>
#include <amontons/contact/coupling.h>
#include <amontons/geometry/affine_map.h>
#include <amontons/geometry/rigid_surface.h>

#include <functional>

namespace Amontons
{
  // The motion of carrier m; u readable at its DoFs.
  template <int dim>
  AffineMap<dim>
  carrier_motion(const Discretization<dim> &discretization, const unsigned int m, const LA::Vector &u);

  // The side that receives the multiplier: a meshed surface or an analytic obstacle.
  template <int dim>
  struct MasterSide
  {
    const ContactSurface<dim> *surface  = nullptr;
    const ObstacleData        *obstacle = nullptr;
    unsigned int               carrier  = 0; // of the obstacle, and where it has taken it
    AffineMap<dim>             motion;
  };

  // Unknowns of the master at a point of the overlap.
  template <int dim>
  std::vector<NodeDofs<dim>>
  master_dofs(const Discretization<dim> &discretization,
              const MasterSide<dim>     &master,
              const OverlapPoint<dim>   &p);

  // Their shape values there.
  template <int dim>
  std::vector<double>
  master_values(const Discretization<dim> &discretization,
                const MasterSide<dim>     &master,
                const OverlapPoint<dim>   &p);

  // All overlaps of the pair whose gap is at most `reach`, with the geometric gaps. wanted: by slave face,
  // empty for all. Collective: each rank searches for every n-th slave face, wherever its cell is (often one
  // rank has all of them), and all get all points, in the order of the slave faces.
  template <int dim>
  std::vector<OverlapPoint<dim>>
  find_overlaps(const PairData            &pair,
                const ContactSurface<dim> &slave,
                const MasterSide<dim>     &master,
                const double               search_distance,
                const bool                 axisymmetric,
                const MPI_Comm             communicator,
                const bool                 moved  = false,
                const std::vector<bool>   &wanted = {});

  // carries_multiplier: by slave node, false where supports own the node whole. `points` in the order of the
  // slave faces. carried, for moved surfaces: which nodes did before. stays: surfaces that are never moved
  // may have nodal traces (nodal_traces.h). Collective: each rank integrates over its part of the points, and
  // all get all rows, equal to the last digit.
  template <int dim>
  Coupling<dim>
  integrate_coupling(const Discretization<dim>     &discretization,
                     const ContactSurface<dim>     &slave,
                     const MasterSide<dim>         &master,
                     std::vector<OverlapPoint<dim>> points,
                     const std::vector<bool>       &carries_multiplier,
                     const std::vector<bool>       &carried = {},
                     const bool                     stays   = false);
} // namespace Amontons

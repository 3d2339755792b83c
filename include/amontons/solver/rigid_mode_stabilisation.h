// What holds bodies that nothing holds yet.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/solver/floating_bodies.h>

namespace Amontons
{
  // Diagonal terms on the increment only, which vanish at convergence: `pins` for motions that contact can
  // never hold; `springs`, weak ones in addition for those that no closed node holds yet. Empty if no body
  // floats.
  struct RigidModeStabilisation
  {
    LA::Vector springs, pins;

    // On the bodies that move (by body, then by carrier) springs and pins, on the others pins alone: a motion
    // that closed nodes hold by a trifle only, as a roller between two nodes whose normals are nearly
    // opposite, would come to rest slowly against springs.
    template <int dim>
    LA::Vector
    springs_on(const std::vector<bool> &moving, const FloatingBodies<dim> &floating) const;
  };

  template <int dim>
  RigidModeStabilisation
  stabilise_rigid_modes(const Discretization<dim>     &discretization,
                        const ElasticityOperator<dim> &elasticity,
                        const FloatingBodies<dim>     &floating);
} // namespace Amontons

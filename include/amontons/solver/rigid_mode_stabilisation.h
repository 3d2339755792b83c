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
  };

  template <int dim>
  RigidModeStabilisation
  stabilise_rigid_modes(const Discretization<dim>     &discretization,
                        const ElasticityOperator<dim> &elasticity,
                        const FloatingBodies<dim>     &floating);
} // namespace Amontons

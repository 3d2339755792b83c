// St. Venant-Kirchhoff solid, at a point.
#pragma once

#include <amontons/elasticity/kirchhoff.h>

namespace Amontons
{
  // W = lambda/2 (tr E)^2 + mu E:E,  E = (F^T F - I)/2: Hooke's law between the second Piola-Kirchhoff stress
  // and Green's strain, for large rotations at small strain. Under compression to about 0.6 of a length it
  // loses its stiffness.
  struct StVenantKirchhoff
  {
    double lambda, mu;

    // tr E = (tr b - 3)/2,  4 E:E = tr b^2 - 2 tr b + 3
    double
    energy(const SymmetricTensor<2, 3> &b) const;

    // tau = lambda tr E b + mu (b^2 - b)
    Voigt<3>
    stress(const SymmetricTensor<2, 3> &b) const;

    // c_ijkl = lambda b_ij b_kl + mu (b_ik b_jl + b_il b_jk)
    SpatialTangent
    tangent(const SymmetricTensor<2, 3> &b) const;

    // b_33 with tau_33 = 0, for given b_11, b_22, b_12; not positive where there is none.
    double
    squared_thickness(const SymmetricTensor<2, 3> &b) const;
  };
} // namespace Amontons

// St. Venant-Kirchhoff solid, at a point; e = b - I.
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

    // tr E = tr e/2,  4 E:E = e:e
    double
    energy(const SymmetricTensor<2, 3> &e) const;

    // tau = lambda tr E b + mu b e
    Voigt<3>
    stress(const SymmetricTensor<2, 3> &e) const;

    // c_ijkl = lambda b_ij b_kl + mu (b_ik b_jl + b_il b_jk)
    SpatialTangent
    tangent(const SymmetricTensor<2, 3> &e) const;

    // e_33 with tau_33 = 0, for given e_11, e_22, e_12; not above -1 where there is none.
    double
    thickness_strain(const SymmetricTensor<2, 3> &e) const;
  };
} // namespace Amontons

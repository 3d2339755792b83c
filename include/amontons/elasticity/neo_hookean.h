// Compressible neo-Hookean solid, at a point; e = b - I.
#pragma once

#include <amontons/elasticity/kirchhoff.h>

namespace Amontons
{
  // W = mu/2 (tr b - 3) - mu ln J + lambda/4 (J^2 - 1 - 2 ln J),  J^2 = det b
  // (Ciarlet 1988; Simo and Miehe 1992; Wriggers 2008). Unlike with lambda/2 ln^2 J, the volumetric part is
  // convex in J everywhere, and infinite at J = 0 as at J = infinity.
  struct NeoHookean
  {
    double lambda, mu;

    double
    energy(const SymmetricTensor<2, 3> &e) const;

    // tau = mu (b - I) + lambda/2 (J^2 - 1) I
    Voigt<3>
    stress(const SymmetricTensor<2, 3> &e) const;

    // c_ijkl = lambda J^2 d_ij d_kl + (mu - lambda/2 (J^2 - 1)) (d_ik d_jl + d_il d_jk)
    SpatialTangent
    tangent(const SymmetricTensor<2, 3> &e) const;

    // e_33 with tau_33 = 0, for given e_11, e_22, e_12.
    double
    thickness_strain(const SymmetricTensor<2, 3> &e) const;
  };
} // namespace Amontons

// The laws of finite strain behind one face: isotropic, functions of b = F F^T with F always 3x3. They are
// given e = b - I, twice the strain where that is small, and keep its digits: loads may be as small as at
// small strain.
#pragma once

#include <amontons/elasticity/neo_hookean.h>
#include <amontons/elasticity/st_venant_kirchhoff.h>

#include <variant>

namespace Amontons
{
  using HyperelasticLaw = std::variant<NeoHookean, StVenantKirchhoff>;

  HyperelasticLaw
  make_law(const MaterialData &material);

  // Per reference volume.
  double
  energy(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e);

  Voigt<3>
  kirchhoff_stress(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e);

  SpatialTangent
  spatial_tangent(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e);

  // Plane stress: e_33, the square of the stretch of the thickness less 1; not above -1 where no stretch
  // gives tau_33 = 0.
  double
  thickness_strain(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e);

  // Plane stress: c_kl - c_k3 c_3l / c_33, the tangent between in-plane components with tau_33 kept at zero.
  SpatialTangent
  condense_thickness(const SpatialTangent &c);
} // namespace Amontons

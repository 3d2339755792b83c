// The laws of finite strain behind one face: isotropic, functions of b = F F^T with F always 3x3.
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
  energy(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &b);

  Voigt<3>
  kirchhoff_stress(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &b);

  SpatialTangent
  spatial_tangent(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &b);

  // Plane stress: the square of the stretch of the thickness; not positive where no stretch gives tau_33 = 0.
  double
  squared_thickness(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &b);

  // Plane stress: c_kl - c_k3 c_3l / c_33, the tangent between in-plane components with tau_33 kept at zero.
  SpatialTangent
  condense_thickness(const SpatialTangent &c);
} // namespace Amontons

#include <amontons/elasticity/hyperelastic.h>

namespace Amontons
{
  HyperelasticLaw
  make_law(const MaterialData &material)
  {
    const double E = material.young, nu = material.poisson;
    const double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    if (material.law == Law::neo_hookean)
      return NeoHookean{lambda, mu};
    return StVenantKirchhoff{lambda, mu};
  }

  double
  energy(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e)
  {
    return std::visit([&](const auto &l) { return l.energy(e); }, law);
  }

  Voigt<3>
  kirchhoff_stress(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e)
  {
    return std::visit([&](const auto &l) { return l.stress(e); }, law);
  }

  SpatialTangent
  spatial_tangent(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e)
  {
    return std::visit([&](const auto &l) { return l.tangent(e); }, law);
  }

  double
  thickness_strain(const HyperelasticLaw &law, const SymmetricTensor<2, 3> &e)
  {
    return std::visit([&](const auto &l) { return l.thickness_strain(e); }, law);
  }

  SpatialTangent
  condense_thickness(const SpatialTangent &c)
  {
    SpatialTangent condensed;
    for (unsigned int k = 0; k < 6; ++k)
      for (unsigned int l = 0; l < 6; ++l)
        condensed[k][l] = c[k][l] - c[k][2] * c[2][l] / c[2][2];
    return condensed;
  }
} // namespace Amontons

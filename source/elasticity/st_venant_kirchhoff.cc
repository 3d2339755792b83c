#include <amontons/elasticity/st_venant_kirchhoff.h>

namespace Amontons
{
  double
  StVenantKirchhoff::energy(const SymmetricTensor<2, 3> &e) const
  {
    return lambda / 8 * trace(e) * trace(e) + mu / 4 * (e * e);
  }

  Voigt<3>
  StVenantKirchhoff::stress(const SymmetricTensor<2, 3> &e) const
  {
    const auto b = unit_symmetric_tensor<3>() + e;
    return as_voigt(lambda / 2 * trace(e) * b + mu * (e + symmetrize(Tensor<2, 3>(e) * Tensor<2, 3>(e))));
  }

  SpatialTangent
  StVenantKirchhoff::tangent(const SymmetricTensor<2, 3> &e) const
  {
    const auto     b = unit_symmetric_tensor<3>() + e;
    SpatialTangent c;
    for (unsigned int m = 0; m < 6; ++m)
      for (unsigned int n = 0; n < 6; ++n)
        {
          const auto [i, j] = voigt_indices[m];
          const auto [k, l] = voigt_indices[n];
          c[m][n]           = lambda * b[i][j] * b[k][l] + mu * (b[i][k] * b[j][l] + b[i][l] * b[j][k]);
        }
    return c;
  }

  // lambda/2 (e_11 + e_22 + x) + mu x = 0 with x = e_33
  double
  StVenantKirchhoff::thickness_strain(const SymmetricTensor<2, 3> &e) const
  {
    return -lambda / 2 * (e[0][0] + e[1][1]) / (mu + lambda / 2);
  }
} // namespace Amontons

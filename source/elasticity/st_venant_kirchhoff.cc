#include <amontons/elasticity/st_venant_kirchhoff.h>

namespace Amontons
{
  double
  StVenantKirchhoff::energy(const SymmetricTensor<2, 3> &b) const
  {
    const double trace_E = (trace(b) - 3) / 2;
    return lambda / 2 * trace_E * trace_E + mu / 4 * (b * b - 2 * trace(b) + 3);
  }

  Voigt<3>
  StVenantKirchhoff::stress(const SymmetricTensor<2, 3> &b) const
  {
    return as_voigt((lambda / 2 * (trace(b) - 3) - mu) * b +
                    mu * symmetrize(Tensor<2, 3>(b) * Tensor<2, 3>(b)));
  }

  SpatialTangent
  StVenantKirchhoff::tangent(const SymmetricTensor<2, 3> &b) const
  {
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

  // lambda/2 (b_11 + b_22 + x - 3) + mu (x - 1) = 0 with x = b_33
  double
  StVenantKirchhoff::squared_thickness(const SymmetricTensor<2, 3> &b) const
  {
    return (mu + lambda / 2 * (3 - b[0][0] - b[1][1])) / (mu + lambda / 2);
  }
} // namespace Amontons

#include <amontons/elasticity/neo_hookean.h>

namespace Amontons
{
  double
  NeoHookean::energy(const SymmetricTensor<2, 3> &b) const
  {
    const double J2 = determinant(b), ln_J2 = std::log(J2);
    return mu / 2 * (trace(b) - 3 - ln_J2) + lambda / 4 * (J2 - 1 - ln_J2);
  }

  Voigt<3>
  NeoHookean::stress(const SymmetricTensor<2, 3> &b) const
  {
    const double pressure = lambda / 2 * (determinant(b) - 1);
    Voigt<3>     tau      = as_voigt(mu * b);
    for (unsigned int k = 0; k < 3; ++k)
      tau[k] += pressure - mu;
    return tau;
  }

  SpatialTangent
  NeoHookean::tangent(const SymmetricTensor<2, 3> &b) const
  {
    const double   J2 = determinant(b), shear = mu - lambda / 2 * (J2 - 1);
    SpatialTangent c = {};
    for (unsigned int k = 0; k < 3; ++k)
      {
        for (unsigned int l = 0; l < 3; ++l)
          c[k][l] = lambda * J2;
        c[k][k] += 2 * shear;
        c[3 + k][3 + k] = shear;
      }
    return c;
  }

  // mu (x - 1) + lambda/2 (det_2 x - 1) = 0 with x = b_33 and J^2 = det_2 x
  double
  NeoHookean::squared_thickness(const SymmetricTensor<2, 3> &b) const
  {
    const double det_2 = b[0][0] * b[1][1] - b[0][1] * b[0][1];
    return (mu + lambda / 2) / (mu + lambda / 2 * det_2);
  }
} // namespace Amontons

#include <amontons/elasticity/neo_hookean.h>

namespace Amontons
{
  double
  NeoHookean::energy(const SymmetricTensor<2, 3> &e) const
  {
    const double change = change_of_determinant(e), ln_J2 = std::log1p(change);
    return mu / 2 * (trace(e) - ln_J2) + lambda / 4 * (change - ln_J2);
  }

  Voigt<3>
  NeoHookean::stress(const SymmetricTensor<2, 3> &e) const
  {
    const double pressure = lambda / 2 * change_of_determinant(e);
    Voigt<3>     tau      = as_voigt(mu * e);
    for (unsigned int k = 0; k < 3; ++k)
      tau[k] += pressure;
    return tau;
  }

  SpatialTangent
  NeoHookean::tangent(const SymmetricTensor<2, 3> &e) const
  {
    const double   change = change_of_determinant(e), shear = mu - lambda / 2 * change;
    SpatialTangent c = {};
    for (unsigned int k = 0; k < 3; ++k)
      {
        for (unsigned int l = 0; l < 3; ++l)
          c[k][l] = lambda * (1 + change);
        c[k][k] += 2 * shear;
        c[3 + k][3 + k] = shear;
      }
    return c;
  }

  // mu x + lambda/2 ((1 + a)(1 + x) - 1) = 0 with x = e_33 and 1 + a = b_11 b_22 - b_12^2
  double
  NeoHookean::thickness_strain(const SymmetricTensor<2, 3> &e) const
  {
    const double a = e[0][0] + e[1][1] + e[0][0] * e[1][1] - e[0][1] * e[0][1];
    return -lambda / 2 * a / (mu + lambda / 2 * (1 + a));
  }
} // namespace Amontons

// Kirchhoff stress tau and its spatial tangent in the components of kinematics.h, as the laws return them.
#pragma once

#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // c[k][l] = c_ijkl of the Lie derivative of tau: with velocity gradient L,
  // d tau = c : sym L + L tau + tau L^T. Columns multiply engineering strains.
  using SpatialTangent = std::array<Voigt<3>, 6>;

  constexpr std::array<std::array<unsigned int, 2>, 6> voigt_indices = {
      {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};

  inline Voigt<3>
  as_voigt(const SymmetricTensor<2, 3> &s)
  {
    return {{s[0][0], s[1][1], s[2][2], s[0][1], s[0][2], s[1][2]}};
  }

  // Of 4 (plane) or 6 components.
  template <std::size_t n>
  Tensor<2, 3>
  as_tensor(const std::array<double, n> &stress)
  {
    Tensor<2, 3> result;
    for (unsigned int k = 0; k < n; ++k)
      {
        const auto [i, j] = voigt_indices[k];
        result[i][j] = result[j][i] = stress[k];
      }
    return result;
  }

  // det(I + h) - 1 = tr h + (sum of the principal minors of h) + det h: small strains keep their digits.
  template <typename TensorType>
  double
  change_of_determinant(const TensorType &h)
  {
    return h[0][0] + h[1][1] + h[2][2] + (h[0][0] * h[1][1] - h[0][1] * h[1][0]) +
           (h[1][1] * h[2][2] - h[1][2] * h[2][1]) + (h[2][2] * h[0][0] - h[2][0] * h[0][2]) + determinant(h);
  }
} // namespace Amontons

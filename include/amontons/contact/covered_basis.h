// Polynomials on the covered part of a slave face that are nearly orthogonal there.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Amontons
{
  // Products L_k of Legendre polynomials on the bounding box of some points of the unit face. L_0 = 1. The
  // Bernstein polynomials of the face are B = R L.
  template <int fdim>
  class CoveredBasis
  {
  public:
    CoveredBasis(const unsigned int degree, const std::vector<dealii::Point<fdim>> &points);

    std::vector<double>
    values(const dealii::Point<fdim> &xi) const;

    std::vector<dealii::Tensor<1, fdim>>
    gradients(const dealii::Point<fdim> &xi) const;

    dealii::FullMatrix<double> R;

  private:
    const unsigned int      degree;
    dealii::Point<fdim>     lower;
    dealii::Tensor<1, fdim> scale; // ds_d = scale_d dxi_d, s in [-1, 1]
  };
} // namespace Amontons

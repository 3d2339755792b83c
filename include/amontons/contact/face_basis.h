// Polynomials on the unit face [0,1]^(dim-1): Lagrange (equidistant nodes) and Bernstein, as tensor products.
#pragma once

#include <deal.II/base/point.h>

#include <vector>

namespace Amontons
{
  using dealii::Point;
  using dealii::Tensor;

  // Values and derivatives of the degree + 1 polynomials at x.
  void
  lagrange_1d(const unsigned int   degree,
              const double         x,
              std::vector<double> &values,
              std::vector<double> &derivatives);
  void
  bernstein_1d(const unsigned int degree, const double x, std::vector<double> &values);

  // (degree+1)^fdim values, the first coordinate running fastest.
  template <int fdim>
  std::vector<double>
  lagrange_values(const unsigned int degree, const Point<fdim> &xi);

  template <int fdim>
  std::vector<Tensor<1, fdim>>
  lagrange_gradients(const unsigned int degree, const Point<fdim> &xi);

  template <int fdim>
  std::vector<double>
  bernstein_values(const unsigned int degree, const Point<fdim> &xi);

  // Control values c = T u of a Lagrange interpolant: row i gives c_i. Degree 1: the identity; degree 2:
  // c_mid = 2 u_mid - (u_0 + u_1)/2.
  std::vector<std::vector<double>>
  control_matrix(const unsigned int degree, const unsigned int fdim);
} // namespace Amontons

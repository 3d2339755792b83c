// Polynomials on the unit face [0,1]^(dim-1): Lagrange (equidistant nodes) and Bernstein, as tensor products.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Amontons
{
  using dealii::Point;
  using dealii::Tensor;

  // Values and derivatives of the degree + 1 Lagrange polynomials at x, into containers of that size: with
  // t_j = n x - j,
  //   l_i = w_i prod_{j<i} t_j prod_{j>i} t_j,   w_i = (-1)^(n-i) / (i! (n-i)!).
  template <typename Values>
  void
  lagrange_1d(const unsigned int degree, const double x, Values &values, Values &derivatives)
  {
    const double n       = degree;
    double       product = 1, slope = 0; // of the factors on one side of i
    for (unsigned int i = 0; i <= degree; ++i)
      {
        values[i]      = product;
        derivatives[i] = slope;
        const double t = n * x - i;
        slope          = slope * t + n * product;
        product *= t;
      }
    product = 1;
    slope   = 0;
    for (unsigned int i = degree + 1; i-- > 0;)
      {
        derivatives[i] = derivatives[i] * product + values[i] * slope;
        values[i] *= product;
        const double t = n * x - i;
        slope          = slope * t + n * product;
        product *= t;
      }
    double weight    = degree % 2 == 0 ? 1 : -1; // w_0 n!
    double factorial = 1;
    for (unsigned int i = 2; i <= degree; ++i)
      factorial *= i;
    for (unsigned int i = 0; i <= degree; ++i)
      {
        values[i] *= weight / factorial;
        derivatives[i] *= weight / factorial;
        weight *= -(n - i) / (i + 1);
      }
  }

  // (degree+1)^fdim values, the first coordinate running fastest.
  template <int fdim>
  std::vector<double>
  lagrange_values(const unsigned int degree, const Point<fdim> &xi);

  template <int fdim>
  std::vector<Tensor<1, fdim>>
  lagrange_gradients(const unsigned int degree, const Point<fdim> &xi);

  // The Bernstein polynomials of degree 1 or 2.
  template <int fdim>
  std::vector<double>
  bernstein_values(const unsigned int degree, const Point<fdim> &xi);

  // Traces B' = A^T B of the unknowns of a face with hanging nodes (SurfaceFace::subdivision); B itself where
  // A is empty.
  std::vector<double>
  traces_of_unknowns(const std::vector<double> &B, const dealii::FullMatrix<double> &A);

  // Control values c = T u of a Lagrange interpolant: row i gives c_i. Degree 1: the identity; degree 2:
  // c_mid = 2 u_mid - (u_0 + u_1)/2 (doc/introduction.md, (4)).
  std::vector<std::vector<double>>
  control_matrix(const unsigned int degree, const unsigned int fdim);
} // namespace Amontons

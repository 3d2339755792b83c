// Polynomials on the unit face [0,1]^(dim-1): Lagrange (equidistant nodes) and Bernstein, as tensor products.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Amontons
{
  using dealii::Point;
  using dealii::Tensor;

  // Values and derivatives of the degree + 1 Lagrange polynomials at x, into containers of that size.
  template <typename Values>
  void
  lagrange_1d(const unsigned int degree, const double x, Values &values, Values &derivatives)
  {
    const double n = degree;
    for (unsigned int i = 0; i <= degree; ++i)
      {
        values[i]      = 1;
        derivatives[i] = 0;
        for (unsigned int j = 0; j <= degree; ++j)
          if (j != i)
            {
              const double slope  = n / (double(i) - double(j));
              const double factor = slope * (x - j / n);
              derivatives[i]      = derivatives[i] * factor + values[i] * slope;
              values[i] *= factor;
            }
      }
  }

  // The Bernstein polynomials
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

  // Traces B' = A^T B of the unknowns of a face with hanging nodes (SurfaceFace::subdivision); B itself where
  // A is empty.
  std::vector<double>
  traces_of_unknowns(const std::vector<double> &B, const dealii::FullMatrix<double> &A);

  // Control values c = T u of a Lagrange interpolant: row i gives c_i. Degree 1: the identity; degree 2:
  // c_mid = 2 u_mid - (u_0 + u_1)/2.
  std::vector<std::vector<double>>
  control_matrix(const unsigned int degree, const unsigned int fdim);
} // namespace Amontons

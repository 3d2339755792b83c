// Small vectors of doubles, or of numbers that carry derivatives: deal.II's tensors do not take Sacado's
// expression templates.
#pragma once

#include <deal.II/base/point.h>

#include <Sacado.hpp>

#include <array>
#include <cmath>

namespace Amontons
{
  // A number with its derivatives by n variables.
  template <int n>
  using ADNumber = Sacado::Fad::SFad<double, n>;

  inline double
  value_of(const double x)
  {
    return x;
  }

  template <int n>
  double
  value_of(const ADNumber<n> &x)
  {
    return x.val();
  }

  template <int dim, typename Number>
  struct Components : public std::array<Number, dim>
  {
    Components() { this->fill(Number(0.)); }

    explicit Components(const dealii::Tensor<1, dim> &v)
    {
      for (unsigned int d = 0; d < dim; ++d)
        (*this)[d] = v[d];
    }
  };

  template <int dim, typename Number>
  dealii::Point<dim>
  value_of(const Components<dim, Number> &v)
  {
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = value_of(v[d]);
    return result;
  }

  template <int dim, typename Number>
  Components<dim, Number>
  operator+(Components<dim, Number> a, const Components<dim, Number> &b)
  {
    for (unsigned int d = 0; d < dim; ++d)
      a[d] += b[d];
    return a;
  }

  template <int dim, typename Number>
  Components<dim, Number>
  operator-(Components<dim, Number> a, const Components<dim, Number> &b)
  {
    for (unsigned int d = 0; d < dim; ++d)
      a[d] -= b[d];
    return a;
  }

  template <int dim, typename Factor, typename Number>
  Components<dim, Number>
  scaled(const Factor &factor, Components<dim, Number> a)
  {
    for (unsigned int d = 0; d < dim; ++d)
      a[d] *= factor;
    return a;
  }

  template <int dim, typename Number>
  Number
  dot(const Components<dim, Number> &a, const Components<dim, Number> &b)
  {
    Number sum = a[0] * b[0];
    for (unsigned int d = 1; d < dim; ++d)
      sum += a[d] * b[d];
    return sum;
  }

  template <int dim, typename Number>
  Number
  norm(const Components<dim, Number> &a)
  {
    using std::sqrt;
    return sqrt(dot(a, a));
  }

  template <typename Number>
  Number
  cross(const Components<2, Number> &a, const Components<2, Number> &b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }

  template <typename Number>
  Components<3, Number>
  cross(const Components<3, Number> &a, const Components<3, Number> &b)
  {
    Components<3, Number> c;
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
    return c;
  }

  // rest = sum_k columns[k] result[k]
  template <int dim, typename Number>
  Components<dim, Number>
  solve(const std::array<dealii::Tensor<1, dim>, dim> &columns, const Components<dim, Number> &rest)
  {
    dealii::Tensor<2, dim> matrix;
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int k = 0; k < dim; ++k)
        matrix[d][k] = columns[k][d];
    const dealii::Tensor<2, dim> inverse = invert(matrix);
    Components<dim, Number>      result;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int d = 0; d < dim; ++d)
        result[k] += inverse[k][d] * rest[d];
    return result;
  }
} // namespace Amontons

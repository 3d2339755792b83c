#include <amontons/contact/face_ad.h>

namespace Amontons
{
  namespace
  {
    // Values, first and second derivatives.
    using Polynomials = std::array<std::array<double, ContactSurface<2>::geometry_degree + 1>, 3>;

    Polynomials
    lagrange_polynomials(const double x)
    {
      constexpr unsigned int degree = ContactSurface<2>::geometry_degree;
      Polynomials            p;
      for (unsigned int i = 0; i <= degree; ++i)
        {
          double value = 1, first = 0, second = 0;
          for (unsigned int j = 0; j <= degree; ++j)
            if (j != i)
              {
                const double slope  = degree / (double(i) - double(j));
                const double factor = slope * (x - double(j) / degree);
                second              = second * factor + 2 * first * slope;
                first               = first * factor + value * slope;
                value *= factor;
              }
          p[0][i] = value;
          p[1][i] = first;
          p[2][i] = second;
        }
      return p;
    }
  } // namespace

  template <int dim>
  std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1>
  second_derivatives(const SurfaceFace<dim> &face, const Point<dim - 1> &xi)
  {
    constexpr unsigned int                                   n = ContactSurface<dim>::geometry_degree + 1;
    std::array<Polynomials, dim - 1>                         p;
    std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> result;
    for (unsigned int d = 0; d < dim - 1; ++d)
      p[d] = lagrange_polynomials(xi[d]);
    if constexpr (dim == 2)
      for (unsigned int i = 0; i < n; ++i)
        result[0][0] += p[0][2][i] * face.geometry[i];
    else
      {
        for (unsigned int j = 0; j < n; ++j)
          {
            std::array<Tensor<1, dim>, 3> row; // and its derivatives along the row
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int order = 0; order < 3; ++order)
                row[order] += p[0][order][i] * face.geometry[i + n * j];
            result[0][0] += p[1][0][j] * row[2];
            result[0][1] += p[1][1][j] * row[1];
            result[1][1] += p[1][2][j] * row[0];
          }
        result[1][0] = result[0][1];
      }
    return result;
  }

  template std::array<std::array<Tensor<1, 2>, 1>, 1>
  second_derivatives(const SurfaceFace<2> &, const Point<1> &);
  template std::array<std::array<Tensor<1, 3>, 2>, 2>
  second_derivatives(const SurfaceFace<3> &, const Point<2> &);
} // namespace Amontons

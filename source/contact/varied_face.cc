#include <amontons/contact/varied_face.h>

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
    for (unsigned int k = 0; k < dim - 1; ++k)
      for (unsigned int l = 0; l < dim - 1; ++l)
        for (unsigned int i = 0; i < face.geometry.size(); ++i)
          {
            double value = 1;
            for (unsigned int d = 0, rest = i; d < dim - 1; ++d, rest /= n)
              value *= p[d][(d == k) + (d == l)][rest % n];
            result[k][l] += value * face.geometry[i];
          }
    return result;
  }

  template std::array<std::array<Tensor<1, 2>, 1>, 1>
  second_derivatives(const SurfaceFace<2> &, const Point<1> &);
  template std::array<std::array<Tensor<1, 3>, 2>, 2>
  second_derivatives(const SurfaceFace<3> &, const Point<2> &);
} // namespace Amontons

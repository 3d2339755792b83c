#include <amontons/contact/covered_basis.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    double
    legendre(const unsigned int k, const double s)
    {
      return k == 0 ? 1. : k == 1 ? s : 0.5 * (3 * s * s - 1);
    }

    double
    legendre_slope(const unsigned int k, const double s)
    {
      return k == 0 ? 0. : k == 1 ? 1. : 3 * s;
    }
  } // namespace

  template <int fdim>
  CoveredBasis<fdim>::CoveredBasis(const unsigned int degree, const std::vector<Point<fdim>> &points)
      : R(Utilities::fixed_power<fdim>(degree + 1)), degree(degree), lower(points[0])
  {
    Point<fdim> upper = points[0];
    for (const auto &p : points)
      for (unsigned int d = 0; d < fdim; ++d)
        {
          lower[d] = std::min(lower[d], p[d]);
          upper[d] = std::max(upper[d], p[d]);
        }
    for (unsigned int d = 0; d < fdim; ++d)
      scale[d] = 2 / std::max(upper[d] - lower[d], 1e-300);

    // By interpolation at the Gauss points of the box.
    const QGauss<fdim> gauss(degree + 1);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        Point<fdim> p;
        for (unsigned int d = 0; d < fdim; ++d)
          p[d] = lower[d] + gauss.point(q)[d] * (upper[d] - lower[d]);
        const auto B = bernstein_values(degree, p);
        for (unsigned int k = 0; k < R.n(); ++k)
          {
            double L = 1, norm = 1; // int L_k^2 over the unit box
            for (unsigned int d = 0, rest = k; d < fdim; ++d, rest /= degree + 1)
              {
                L *= legendre(rest % (degree + 1), 2 * gauss.point(q)[d] - 1);
                norm *= 1. / (2 * (rest % (degree + 1)) + 1);
              }
            for (unsigned int i = 0; i < R.m(); ++i)
              R(i, k) += gauss.weight(q) * B[i] * L / norm;
          }
      }
  }

  template <int fdim>
  std::vector<double>
  CoveredBasis<fdim>::values(const Point<fdim> &xi) const
  {
    std::vector<double> values(R.n(), 1.);
    for (unsigned int k = 0; k < values.size(); ++k)
      for (unsigned int d = 0, rest = k; d < fdim; ++d, rest /= degree + 1)
        values[k] *= legendre(rest % (degree + 1), scale[d] * (xi[d] - lower[d]) - 1);
    return values;
  }

  template <int fdim>
  std::vector<Tensor<1, fdim>>
  CoveredBasis<fdim>::gradients(const Point<fdim> &xi) const
  {
    std::vector<Tensor<1, fdim>> gradients(R.n());
    for (unsigned int k = 0; k < gradients.size(); ++k)
      for (unsigned int e = 0; e < fdim; ++e)
        {
          gradients[k][e] = scale[e];
          for (unsigned int d = 0, rest = k; d < fdim; ++d, rest /= degree + 1)
            gradients[k][e] *=
                (d == e ? legendre_slope : legendre)(rest % (degree + 1), scale[d] * (xi[d] - lower[d]) - 1);
        }
    return gradients;
  }

  template class CoveredBasis<1>;
  template class CoveredBasis<2>;
} // namespace Amontons

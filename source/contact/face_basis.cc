#include <amontons/contact/face_basis.h>

#include <deal.II/base/exceptions.h>

namespace Amontons
{
  namespace
  {
    using Factors = std::array<double, 5>; // one-dimensional polynomials, up to degree 4

    void
    bernstein_1d(const unsigned int degree, const double x, Factors &values)
    {
      Assert(degree == 1 || degree == 2, dealii::ExcNotImplemented());
      if (degree == 1)
        values = {{1 - x, x}};
      else
        values = {{(1 - x) * (1 - x), 2 * x * (1 - x), x * x}};
    }

    // Product over the directions of the first n factors f[direction][index], the first index fastest.
    template <int fdim>
    std::vector<double>
    tensor_product(const unsigned int n, const std::array<Factors, fdim> &f)
    {
      if constexpr (fdim == 1)
        return {f[0].begin(), f[0].begin() + n};
      else
        {
          std::vector<double> result(n * n);
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n; ++i)
              result[i + n * j] = f[0][i] * f[1][j];
          return result;
        }
    }
  } // namespace

  template <int fdim>
  std::vector<double>
  lagrange_values(const unsigned int degree, const Point<fdim> &xi)
  {
    std::array<Factors, fdim> f;
    Factors                   unused;
    for (unsigned int d = 0; d < fdim; ++d)
      lagrange_1d(degree, xi[d], f[d], unused);
    return tensor_product<fdim>(degree + 1, f);
  }

  template <int fdim>
  std::vector<Tensor<1, fdim>>
  lagrange_gradients(const unsigned int degree, const Point<fdim> &xi)
  {
    std::array<Factors, fdim> values, derivatives;
    for (unsigned int d = 0; d < fdim; ++d)
      lagrange_1d(degree, xi[d], values[d], derivatives[d]);
    std::vector<Tensor<1, fdim>> gradients;
    for (unsigned int d = 0; d < fdim; ++d)
      {
        auto f             = values;
        f[d]               = derivatives[d];
        const auto product = tensor_product<fdim>(degree + 1, f);
        gradients.resize(product.size());
        for (unsigned int i = 0; i < product.size(); ++i)
          gradients[i][d] = product[i];
      }
    return gradients;
  }

  template <int fdim>
  std::vector<double>
  bernstein_values(const unsigned int degree, const Point<fdim> &xi)
  {
    std::array<Factors, fdim> f;
    for (unsigned int d = 0; d < fdim; ++d)
      bernstein_1d(degree, xi[d], f[d]);
    return tensor_product<fdim>(degree + 1, f);
  }

  std::vector<double>
  traces_of_unknowns(const std::vector<double> &B, const dealii::FullMatrix<double> &A)
  {
    if (A.empty())
      return B;
    std::vector<double> result(A.n(), 0.);
    for (unsigned int i = 0; i < A.m(); ++i)
      for (unsigned int j = 0; j < A.n(); ++j)
        result[j] += B[i] * A(i, j);
    return result;
  }

  std::vector<std::vector<double>>
  control_matrix(const unsigned int degree, const unsigned int fdim)
  {
    std::vector<std::vector<double>> T1 =
        degree == 1 ? std::vector<std::vector<double>>{{1, 0}, {0, 1}}
                    : std::vector<std::vector<double>>{{1, 0, 0}, {-0.5, 2, -0.5}, {0, 0, 1}};
    if (fdim == 1)
      return T1;
    const unsigned int               n = degree + 1;
    std::vector<std::vector<double>> T2(n * n, std::vector<double>(n * n));
    for (unsigned int i = 0; i < n * n; ++i)
      for (unsigned int j = 0; j < n * n; ++j)
        T2[i][j] = T1[i % n][j % n] * T1[i / n][j / n];
    return T2;
  }

  template std::vector<double>
  lagrange_values(const unsigned int, const Point<1> &);
  template std::vector<double>
  lagrange_values(const unsigned int, const Point<2> &);
  template std::vector<Tensor<1, 1>>
  lagrange_gradients(const unsigned int, const Point<1> &);
  template std::vector<Tensor<1, 2>>
  lagrange_gradients(const unsigned int, const Point<2> &);
  template std::vector<double>
  bernstein_values(const unsigned int, const Point<1> &);
  template std::vector<double>
  bernstein_values(const unsigned int, const Point<2> &);
} // namespace Amontons

#include <amontons/contact/covered_basis.h>
#include <amontons/contact/dual_basis.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/utilities.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // A node that carries no multiplier leaves its part to the others of the face.
    template <int fdim>
    void
    share_among_carrying(const std::vector<bool> &carries_multiplier, DualBasis<fdim> &result)
    {
      const unsigned int n = carries_multiplier.size(), n_q = result.psi.n();
      const unsigned int n_carrying = std::count(carries_multiplier.begin(), carries_multiplier.end(), true);
      for (unsigned int f = 0; f < n; ++f)
        if (!carries_multiplier[f])
          {
            for (unsigned int i = 0; i < n; ++i)
              if (carries_multiplier[i])
                {
                  for (unsigned int q = 0; q < n_q; ++q)
                    result.psi(i, q) += result.psi(f, q) / n_carrying;
                  for (unsigned int j = 0; j < n; ++j)
                    result.traces(i, j) += result.traces(f, j) / n_carrying;
                }
            for (unsigned int j = 0; j < n; ++j)
              result.traces(f, j) = 0;
            for (unsigned int q = 0; q < n_q; ++q)
              result.psi(f, q) = 0;
          }
    }
  } // namespace

  template <int fdim>
  DualBasis<fdim>
  make_dual_basis(const unsigned int              degree,
                  const std::vector<Point<fdim>> &points,
                  const std::vector<double>      &weights,
                  const std::vector<bool>        &carries_multiplier,
                  const FullMatrix<double>       &subdivision,
                  const FullMatrix<double>       &change)
  {
    const unsigned int       n = Utilities::fixed_power<fdim>(degree + 1), n_q = points.size();
    const CoveredBasis<fdim> legendre(degree, points);
    FullMatrix<double>       L(n, n_q), G(n, n);
    Vector<double>           D(n);
    DualBasis<fdim>          result;
    result.mass.reinit(n, n);
    for (unsigned int q = 0; q < n_q; ++q)
      {
        const auto b = bernstein_values(degree, points[q]);
        const auto l = legendre.values(points[q]);
        for (unsigned int i = 0; i < n; ++i)
          {
            L(i, q) = l[i];
            D[i] += weights[q] * b[i];
            for (unsigned int j = 0; j < n; ++j)
              {
                G(i, j) += weights[q] * l[i] * l[j];
                result.mass(i, j) += weights[q] * b[i] * b[j];
              }
          }
      }

    if (!subdivision.empty())
      {
        const Vector<double> local(D);
        subdivision.Tvmult(D, local);
        FullMatrix<double> product(n, n);
        subdivision.Tmmult(product, result.mass);
        product.mmult(result.mass, subdivision);
      }

    // A single node takes all: psi = 1, whatever the covered part (slivers cannot be inverted).
    if (std::count(carries_multiplier.begin(), carries_multiplier.end(), true) == 1)
      {
        const unsigned int i = std::find(carries_multiplier.begin(), carries_multiplier.end(), true) -
                               carries_multiplier.begin();
        result.psi.reinit(n, n_q);
        result.traces.reinit(n, n);
        for (unsigned int q = 0; q < n_q; ++q)
          result.psi(i, q) = 1;
        for (unsigned int f = 0; f < n; ++f)
          result.traces(i, f) = D[f];
        return result;
      }

    // psi = D R^-T G^-1 L
    FullMatrix<double> G_inverse(n, n), R_inverse(n, n), RG(n, n);
    G_inverse.invert(G);
    R_inverse.invert(legendre.R);
    R_inverse.Tmmult(RG, G_inverse);
    if (!subdivision.empty())
      {
        FullMatrix<double> A_inverse(n, n);
        A_inverse.invert(subdivision);
        const FullMatrix<double> product(RG);
        A_inverse.mmult(RG, product);
      }
    FullMatrix<double> P{IdentityMatrix(n)};
    if (!change.empty())
      {
        P = change;
        FullMatrix<double> P_inverse(n, n);
        P_inverse.invert(P);
        const Vector<double> local(D);
        P_inverse.Tvmult(D, local);
        const FullMatrix<double> product(RG);
        P.mmult(RG, product);
      }
    result.psi.reinit(n, n_q);
    RG.mmult(result.psi, L);
    result.traces.reinit(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int q = 0; q < n_q; ++q)
          result.psi(i, q) *= D[i];
        for (unsigned int j = 0; j < n; ++j)
          result.traces(i, j) = D[i] * P(i, j);
      }

    share_among_carrying(carries_multiplier, result);
    return result;
  }

  template DualBasis<1>
  make_dual_basis(const unsigned int,
                  const std::vector<Point<1>> &,
                  const std::vector<double> &,
                  const std::vector<bool> &,
                  const FullMatrix<double> &,
                  const FullMatrix<double> &);
  template DualBasis<2>
  make_dual_basis(const unsigned int,
                  const std::vector<Point<2>> &,
                  const std::vector<double> &,
                  const std::vector<bool> &,
                  const FullMatrix<double> &,
                  const FullMatrix<double> &);
} // namespace Amontons

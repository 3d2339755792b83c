// Dual shape functions are biorthogonal to the Bernstein traces and sum to 1 on any covered part, with and
// without nodes that carry no multiplier.
#include "check.h"

#include <amontons/contact/dual_basis.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <random>

namespace test_dual_basis
{
using namespace Amontons;

std::mt19937 generator(1);

double
random_number(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(generator);
}

// Quadrature on a box of side `fraction` in the unit face, in `n_parts` slabs with a weight that varies as on
// curved faces.
template <int fdim>
void
cover(const double                      fraction,
      const unsigned int                n_parts,
      std::vector<dealii::Point<fdim>> &points,
      std::vector<double>              &weights)
{
  const dealii::QGauss<fdim> gauss(5);
  dealii::Point<fdim>        lower;
  for (unsigned int d = 0; d < fdim; ++d)
    lower[d] = random_number(0, 1 - fraction);
  points.clear();
  weights.clear();
  for (unsigned int part = 0; part < n_parts; ++part)
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        dealii::Point<fdim> p;
        for (unsigned int d = 0; d < fdim; ++d)
          p[d] = lower[d] + fraction * (d == 0 ? (part + gauss.point(q)[0]) / n_parts : gauss.point(q)[d]);
        points.push_back(p);
        weights.push_back(gauss.weight(q) * std::pow(fraction, fdim) / n_parts * 3 *
                          (1 + 0.5 * p[0] * p[fdim - 1]));
      }
}

template <int fdim>
void
check_basis(const unsigned int       degree,
            const double             fraction,
            const std::vector<bool> &carries,
            const double             tolerance,
            const std::string       &what)
{
  const unsigned int               n = carries.size();
  std::vector<dealii::Point<fdim>> points;
  std::vector<double>              weights;
  cover<fdim>(fraction, 1 + generator() % 3, points, weights);
  const auto   basis      = make_dual_basis<fdim>(degree, points, weights, carries);
  const double n_carrying = std::count(carries.begin(), carries.end(), true);

  dealii::FullMatrix<double> mass(n, n), traces(n, n);
  std::vector<double>        D(n, 0.);
  double                     area = 0;
  for (unsigned int q = 0; q < points.size(); ++q)
    {
      const auto B   = bernstein_values<fdim>(degree, points[q]);
      double     sum = 0;
      area += weights[q];
      for (unsigned int i = 0; i < n; ++i)
        {
          sum += basis.psi(i, q);
          D[i] += weights[q] * B[i];
          for (unsigned int j = 0; j < n; ++j)
            {
              mass(i, j) += weights[q] * B[i] * B[j];
              traces(i, j) += weights[q] * basis.psi(i, q) * B[j];
            }
        }
      check::is_close(sum, 1, tolerance, what + ": the sum of psi");
    }
  for (unsigned int i = 0; i < n; ++i)
    {
      check::is_true(D[i] > 0, what + ": positive D");
      for (unsigned int j = 0; j < n; ++j)
        {
          const double expected = !carries[i] ? 0 : i == j ? D[i] : !carries[j] ? D[j] / n_carrying : 0;
          check::is_close(traces(i, j), expected, tolerance, what + ": int psi B", area);
          check::is_close(basis.traces(i, j), expected, 1e-12, what + ": the returned int psi B", area);
          check::is_close(basis.mass(i, j), mass(i, j), 1e-12, what + ": the returned int B B", area);
        }
    }
}

template <int fdim>
void
check_all()
{
  // The smaller the part, the more rounding is magnified: about (1/fraction)^(degree fdim).
  const std::vector<double> fractions = {1., 0.5, 0.1, 0.01};
  for (const unsigned int degree : {1, 2})
    for (const double fraction : fractions)
      for (unsigned int sample = 0; sample < 8; ++sample)
        {
          const double      tolerance = std::max(1e-11, 1e-14 * std::pow(fraction, -double(degree * fdim)));
          std::vector<bool> carries(dealii::Utilities::fixed_power<fdim>(degree + 1), true);
          for (unsigned int k = 0; k < sample % 3 && k + 1 < carries.size(); ++k)
            carries[generator() % carries.size()] = false;
          check_basis<fdim>(degree,
                            fraction,
                            carries,
                            tolerance,
                            std::to_string(fdim) + "D, degree " + std::to_string(degree) + ", covered " +
                                std::to_string(fraction));
        }
}

int
main(int, char **)
{
  check_all<1>();
  check_all<2>();
  return check::result();
}
} // namespace test_dual_basis

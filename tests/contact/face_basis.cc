// Lagrange and Bernstein polynomials of a face: nodes, sums, derivatives, and the control values that turn
// one into the other.
#include "check.h"

#include <amontons/contact/face_basis.h>

#include <deal.II/base/utilities.h>

#include <random>

namespace test_face_basis
{
using namespace Amontons;

std::mt19937 generator(1);

template <int fdim>
Point<fdim>
random_point()
{
  Point<fdim> p;
  for (unsigned int d = 0; d < fdim; ++d)
    p[d] = std::uniform_real_distribution<double>(0, 1)(generator);
  return p;
}

template <int fdim>
void
check_lagrange(const unsigned int degree)
{
  const std::string what =
      "Lagrange polynomials of degree " + std::to_string(degree) + " in " + std::to_string(fdim) + "D";
  const unsigned int n_nodes = dealii::Utilities::fixed_power<fdim>(degree + 1);
  for (unsigned int j = 0; j < n_nodes; ++j)
    {
      Point<fdim> node;
      for (unsigned int d = 0, rest = j; d < fdim; ++d, rest /= degree + 1)
        node[d] = double(rest % (degree + 1)) / degree;
      const auto values = lagrange_values<fdim>(degree, node);
      for (unsigned int i = 0; i < n_nodes; ++i)
        check::is_close(values[i], i == j, 1e-14, what + ": at the nodes", 1);
    }
  for (unsigned int sample = 0; sample < 5; ++sample)
    {
      const auto   x         = random_point<fdim>();
      const auto   gradients = lagrange_gradients<fdim>(degree, x);
      const double h         = 1e-5;
      double       sum       = 0;
      for (const double value : lagrange_values<fdim>(degree, x))
        sum += value;
      check::is_close(sum, 1, 1e-13, what + ": partition of unity");
      for (unsigned int d = 0; d < fdim; ++d)
        {
          Point<fdim> a = x, b = x;
          a[d] -= h;
          b[d] += h;
          const auto below = lagrange_values<fdim>(degree, a), above = lagrange_values<fdim>(degree, b);
          for (unsigned int i = 0; i < n_nodes; ++i)
            check::is_close(gradients[i][d], (above[i] - below[i]) / (2 * h), 1e-8, what + ": derivative", 1);
        }
    }
}

// sum_i u_i N_i = sum_i (T u)_i B_i for every u.
template <int fdim>
void
check_bernstein(const unsigned int degree)
{
  const std::string what =
      "Bernstein polynomials of degree " + std::to_string(degree) + " in " + std::to_string(fdim) + "D";
  const auto T = control_matrix(degree, fdim);
  check::is_true(T.size() == dealii::Utilities::fixed_power<fdim>(degree + 1), what + ": size of T");
  for (unsigned int sample = 0; sample < 10; ++sample)
    {
      const auto x   = random_point<fdim>();
      const auto N   = lagrange_values<fdim>(degree, x);
      const auto B   = bernstein_values<fdim>(degree, x);
      double     sum = 0;
      for (unsigned int i = 0; i < T.size(); ++i)
        {
          sum += B[i];
          check::is_true(B[i] >= 0, what + ": not negative");
          double from_control = 0;
          for (unsigned int k = 0; k < T.size(); ++k)
            from_control += B[k] * T[k][i];
          check::is_close(from_control, N[i], 1e-14, what + ": from control values", 1);
        }
      check::is_close(sum, 1, 1e-14, what + ": partition of unity");
    }
}

int
main(int, char **)
{
  for (const unsigned int degree : {1, 2, 4})
    {
      check_lagrange<1>(degree);
      check_lagrange<2>(degree);
    }
  for (const unsigned int degree : {1, 2})
    {
      check_bernstein<1>(degree);
      check_bernstein<2>(degree);
    }
  return check::result();
}
} // namespace test_face_basis

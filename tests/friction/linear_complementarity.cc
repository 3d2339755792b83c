// Complementary solutions: of a problem solved by hand, of random positive definite ones and of friction with
// any coefficient; where there is none, none is said.
#include "check.h"

#include <amontons/friction/linear_complementarity.h>

#include <algorithm>
#include <random>

namespace test_linear_complementarity
{
using namespace Amontons;
using Matrix = dealii::FullMatrix<double>;
using Vector = dealii::Vector<double>;

double
error_of(const Matrix &M, const Vector &q, const Vector &z)
{
  Vector w(q);
  M.vmult_add(w, z);
  double error = 0;
  for (unsigned int i = 0; i < q.size(); ++i)
    error = std::max({error, -z[i], -w[i], std::min(z[i], w[i])});
  return error;
}

// n nodes with compliance A = B^T B (normal and tangential parts mixed), forces that push and drag; see
// solver/condensed_friction.h for the inequalities; unknowns are p, q+, q-, lambda.
void
friction(const unsigned int n, const double mu, const unsigned int seed)
{
  std::mt19937                     random(seed);
  std::normal_distribution<double> normal;
  Matrix                           B(2 * n, 2 * n), A(2 * n, 2 * n), M(4 * n, 4 * n);
  for (unsigned int i = 0; i < 2 * n; ++i)
    for (unsigned int j = 0; j < 2 * n; ++j)
      B(i, j) = normal(random);
  B.Tmmult(A, B);
  Vector q(4 * n);
  for (unsigned int i = 0; i < n; ++i)
    {
      q[i] = normal(random);
      for (unsigned int s = 0; s < 2; ++s)
        q[(1 + s) * n + i] = (s == 0 ? -1 : 1) * normal(random);
      q[2 * n + i] = -q[n + i];
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int s = 0; s < 2; ++s)
          {
            const double sign             = s == 0 ? 1 : -1;
            M(i, j)                       = A(i, j);
            M(i, (1 + s) * n + j)         = sign * A(i, n + j);
            M((1 + s) * n + i, j)         = sign * A(n + i, j);
            M((1 + s) * n + i, n + j)     = sign * A(n + i, n + j);
            M((1 + s) * n + i, 2 * n + j) = -sign * A(n + i, n + j);
          }
      M(n + i, 3 * n + i) = M(2 * n + i, 3 * n + i) = 1;
      M(3 * n + i, i)                               = mu;
      M(3 * n + i, n + i) = M(3 * n + i, 2 * n + i) = -1;
    }
  const auto        z    = complementary_solution(M, q);
  const std::string name = std::to_string(n) + " nodes, friction " + std::to_string(mu);
  check::is_true(z.has_value(), name + ": found");
  if (z)
    check::is_true(error_of(M, q, *z) < 1e-7 * (1 + z->linfty_norm()), name + ": complementary");
}

int
main(int, char **)
{
  Matrix M(2, 2);
  M(0, 0) = M(1, 1) = 2;
  M(0, 1) = M(1, 0) = 1;
  Vector q(2);
  q[0] = -5, q[1] = -6;
  const auto both = complementary_solution(M, q); // (4/3, 7/3)
  check::is_close((*both)[0], 4. / 3, 1e-14, "both: first");
  check::is_close((*both)[1], 7. / 3, 1e-14, "both: second");
  q[1]           = 1;
  const auto one = complementary_solution(M, q); // (5/2, 0)
  check::is_close((*one)[0], 2.5, 1e-14, "one: first");
  check::is_true((*one)[1] == 0, "one: second");
  q[0] = 3;
  check::is_true(complementary_solution(M, q)->all_zero(), "nothing to do");
  M    = 0;
  q[0] = -1;
  check::is_true(!complementary_solution(M, q), "there is none");

  for (const unsigned int n : {1, 3, 10, 40})
    for (const double mu : {0.1, 1., 10., 1000.})
      for (unsigned int seed = 0; seed < 5; ++seed)
        friction(n, mu, seed);
  return check::result();
}
} // namespace test_linear_complementarity

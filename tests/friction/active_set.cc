// The active-set iteration ends in complementarity from any start, with Murty's rule where changing all nodes
// at once would cycle.
#include "check.h"

#include <amontons/friction/active_set.h>

#include <deal.II/lac/full_matrix.h>

#include <random>
#include <set>

namespace test_active_set
{
using namespace Amontons;

using Matrix = dealii::FullMatrix<double>;

// Find p >= 0 with g = q + M p >= 0 and p g = 0.
struct Problem
{
  Matrix              M;
  std::vector<double> q;
};

struct Result
{
  std::vector<double> p, g;
  std::vector<bool>   closed;
  unsigned int        iterations  = 0;
  bool                safeguarded = false, converged = false;
};

// p = 0 where open, g = 0 where closed.
void
solve(const Problem &problem, Result &result)
{
  std::vector<unsigned int> c;
  for (unsigned int i = 0; i < problem.q.size(); ++i)
    if (result.closed[i])
      c.push_back(i);
  result.p.assign(problem.q.size(), 0.);
  result.g = problem.q;
  if (c.empty())
    return;
  Matrix inverse(c.size(), c.size()), part(c.size(), c.size());
  for (unsigned int i = 0; i < c.size(); ++i)
    for (unsigned int j = 0; j < c.size(); ++j)
      part(i, j) = problem.M(c[i], c[j]);
  inverse.invert(part);
  for (unsigned int i = 0; i < c.size(); ++i)
    for (unsigned int j = 0; j < c.size(); ++j)
      result.p[c[i]] -= inverse(i, j) * problem.q[c[j]];
  for (unsigned int i = 0; i < problem.q.size(); ++i)
    for (const unsigned int j : c)
      result.g[i] += problem.M(i, j) * result.p[j];
  for (const unsigned int i : c)
    result.g[i] = 0;
}

Result
iterate(const Problem           &problem,
        const std::vector<bool> &start,
        const double             c,
        const unsigned int       max_iterations)
{
  Result result;
  result.closed = start;
  ActiveSetUpdate           update;
  const std::vector<double> factors(problem.q.size(), c);
  for (; result.iterations < max_iterations && !result.converged; ++result.iterations)
    {
      solve(problem, result);
      result.converged   = update.update(result.p, result.g, factors, 1e-12, result.closed) == 0;
      result.safeguarded = result.safeguarded || update.safeguarded();
    }
  return result;
}

void
check_complementarity(const Problem &problem, const Result &result, const std::string &what)
{
  check::is_true(result.converged, what + ": converges");
  for (unsigned int i = 0; i < problem.q.size(); ++i)
    {
      check::is_true(result.p[i] >= -1e-9, what + ": no tension");
      check::is_true(result.g[i] >= -1e-9, what + ": no penetration");
      check::is_true(result.p[i] == 0 || result.g[i] == 0, what + ": complementarity");
    }
}

std::mt19937 generator(1);

double
random_number(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(generator);
}

// M-matrix (diagonally dominant, negative off the diagonal) or A A^T.
Problem
random_problem(const unsigned int n, const bool m_matrix)
{
  Problem problem;
  problem.M.reinit(n, n);
  for (unsigned int i = 0; i < n; ++i)
    problem.q.push_back(random_number(-1, 0.5));
  if (m_matrix)
    {
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < i; ++j)
          {
            problem.M(i, j) = problem.M(j, i) = -random_number(0, 1);
            problem.M(i, i) -= problem.M(i, j);
            problem.M(j, j) -= problem.M(i, j);
          }
      for (unsigned int i = 0; i < n; ++i)
        problem.M(i, i) += 0.1;
      return problem;
    }
  Matrix A(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      A(i, j) = random_number(-1, 1);
  A.mTmult(problem.M, A);
  for (unsigned int i = 0; i < n; ++i)
    problem.M(i, i) += 0.05;
  return problem;
}

void
check_random_problems(const bool m_matrix)
{
  const std::string what = m_matrix ? "M-matrix" : "positive definite matrix";
  for (unsigned int sample = 0; sample < 50; ++sample)
    {
      const unsigned int n       = m_matrix ? 20 : 10;
      const Problem      problem = random_problem(n, m_matrix);
      const Result       first   = iterate(problem, std::vector<bool>(n, false), 1, 5000);
      check_complementarity(problem, first, what);

      std::vector<bool> opposite = first.closed, random(n), alternate(n);
      opposite.flip();
      for (unsigned int i = 0; i < n; ++i)
        {
          random[i]    = generator() % 2 == 0;
          alternate[i] = i % 2 == 0;
        }
      for (const auto &start : {opposite, random, alternate, std::vector<bool>(n, true)})
        for (const double c : {1e-3, 1., 1e3})
          {
            const Result result = iterate(problem, start, c, 5000);
            check_complementarity(problem, result, what);
            check::is_true(result.closed == first.closed,
                           what + ": the same set from every start, with every c");
            // A monotone iteration: at most as many steps as nodes, and one to see that it has converged.
            if (m_matrix)
              check::is_true(!result.safeguarded && result.iterations <= n + 2, what + ": no safeguard");
          }
    }
}

Problem
make_problem(const std::vector<std::vector<double>> &M, const std::vector<double> &q)
{
  Problem problem{Matrix(q.size(), q.size()), q};
  for (unsigned int i = 0; i < q.size(); ++i)
    for (unsigned int j = 0; j < q.size(); ++j)
      problem.M(i, j) = M[i][j];
  return problem;
}

// Without the safeguard: the set of some earlier step comes back.
bool
cycles(const Problem &problem, const std::vector<bool> &start)
{
  Result                      result;
  std::set<std::vector<bool>> met;
  result.closed = start;
  while (met.insert(result.closed).second)
    {
      solve(problem, result);
      auto next = result.closed;
      for (unsigned int i = 0; i < next.size(); ++i)
        next[i] = result.p[i] - result.g[i] > 0;
      if (next == result.closed)
        return false;
      result.closed = next;
    }
  return true;
}

void
check_cycling()
{
  struct Case
  {
    Problem           problem;
    std::vector<bool> start;
  };
  const std::vector<Case> cases = {
      {make_problem({{8, 8, -8, -6}, {8, 15, 0, -2}, {-8, 0, 18, 11}, {-6, -2, 11, 7}},
                    {1.5, -3.5, -2.5, -2.5}),
       {false, true, true, false}},
      // not symmetric, but all principal minors are positive, which is what Murty's rule needs
      {make_problem({{1, 2, 0}, {0, 1, 2}, {2, 0, 1}}, {-1, -1, -1}), {false, false, true}}};
  for (unsigned int k = 0; k < cases.size(); ++k)
    {
      const std::string what = "cycling example " + std::to_string(k);
      check::is_true(cycles(cases[k].problem, cases[k].start), what + " cycles without a safeguard");
      const Result result = iterate(cases[k].problem, cases[k].start, 1, 200);
      check_complementarity(cases[k].problem, result, what);
      check::is_true(result.safeguarded, what + ": Murty's rule was used");
    }
}

// Values within the tolerance change nothing.
void
check_tolerance()
{
  ActiveSetUpdate   update;
  std::vector<bool> closed = {true, false, true, false};
  check::is_true(update.update({-1e-12, 0, 1, 0}, {0, -1e-12, 0, 1}, {1, 1, 1, 1}, 1e-9, closed) == 0,
                 "rounding");
  check::is_true(closed == std::vector<bool>({true, false, true, false}), "rounding leaves the set as it is");
  check::is_true(update.update({-1, 0, 1, 0}, {0, -1, 0, 1}, {1, 1, 1, 1}, 1e-9, closed) == 2, "two changes");
  check::is_true(closed == std::vector<bool>({false, true, true, false}),
                 "tension opens, penetration closes");
}

int
main(int, char **)
{
  check_random_problems(true);
  check_random_problems(false);
  check_cycling();
  check_tolerance();
  return check::result();
}
} // namespace test_active_set

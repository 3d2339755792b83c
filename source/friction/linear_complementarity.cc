#include <amontons/friction/linear_complementarity.h>

#include <deal.II/base/table.h>

#include <cmath>
#include <utility>
#include <vector>

namespace Amontons
{
  namespace
  {
    // Hundreds of pivots, each of them chosen by the smallest of ratios: double precision loses the path
    // where compliances have a condition of 1e5.
    using Number = long double;

    // w - M z - z0 e = q by columns w, z, z0, q; of each row the variable that it is solved for.
    class Tableau
    {
    public:
      Tableau(const dealii::FullMatrix<double> &M, const dealii::Vector<double> &q)
          : n(q.size()), entry(n, 2 * n + 2), basis(n)
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            entry(i, i) = 1;
            for (unsigned int j = 0; j < n; ++j)
              entry(i, n + j) = -M(i, j);
            entry(i, artificial()) = -1;
            entry(i, last())       = q[i];
            basis[i]               = i;
          }
      }

      unsigned int
      artificial() const
      {
        return 2 * n;
      }

      // Lexicographically smallest (q, w columns)/entry of the rows with a positive entry; n if there are
      // none.
      unsigned int
      leaving_row(const unsigned int column) const
      {
        Number largest = 0;
        for (unsigned int i = 0; i < n; ++i)
          largest = std::max(largest, std::abs(entry(i, column)));
        unsigned int best = n;
        for (unsigned int i = 0; i < n; ++i)
          if (entry(i, column) > 1e-12 * largest && (best == n || is_before(i, best, column)))
            best = i;
        return best;
      }

      // The variable that leaves.
      unsigned int
      pivot(const unsigned int row, const unsigned int column)
      {
        const Number factor = 1 / entry(row, column);
        for (unsigned int j = 0; j <= last(); ++j)
          entry(row, j) *= factor;
        for (unsigned int i = 0; i < n; ++i)
          if (const Number a = entry(i, column); i != row && a != 0)
            for (unsigned int j = 0; j <= last(); ++j)
              entry(i, j) -= a * entry(row, j);
        return std::exchange(basis[row], column);
      }

      unsigned int
      complement(const unsigned int variable) const
      {
        return variable < n ? variable + n : variable - n;
      }

      dealii::Vector<double>
      solution() const
      {
        dealii::Vector<double> z(n);
        for (unsigned int i = 0; i < n; ++i)
          if (basis[i] >= n && basis[i] < 2 * n)
            z[basis[i] - n] = std::max<Number>(0, entry(i, last()));
        return z;
      }

    private:
      unsigned int
      last() const
      {
        return 2 * n + 1;
      }

      bool
      is_before(const unsigned int i, const unsigned int k, const unsigned int column) const
      {
        const Number a = entry(i, column), b = entry(k, column);
        if (basis[i] == artificial() || basis[k] == artificial())
          {
            const Number p = entry(i, last()) / a, r = entry(k, last()) / b;
            if (std::abs(p - r) <= 1e-11 * (1 + std::abs(p) + std::abs(r)))
              return basis[i] == artificial();
          }
        for (unsigned int j = 0; j <= n; ++j)
          {
            const unsigned int c = j == 0 ? last() : j - 1;
            const Number       p = entry(i, c) / a, r = entry(k, c) / b;
            if (std::abs(p - r) > 1e-11 * (1 + std::abs(p) + std::abs(r)))
              return p < r;
          }
        return false;
      }

      const unsigned int        n;
      dealii::Table<2, Number>  entry;
      std::vector<unsigned int> basis;
    };
  } // namespace

  std::optional<dealii::Vector<double>>
  complementary_solution(const dealii::FullMatrix<double> &M, const dealii::Vector<double> &q)
  {
    Tableau            tableau(M, q);
    const unsigned int n   = q.size();
    unsigned int       row = 0;
    for (unsigned int i = 1; i < n; ++i)
      if (q[i] < q[row])
        row = i;
    if (n == 0 || q[row] >= 0)
      return dealii::Vector<double>(n);
    unsigned int entering = tableau.complement(tableau.pivot(row, tableau.artificial()));
    for (unsigned int step = 0; step < 5 * n; ++step)
      {
        row = tableau.leaving_row(entering);
        if (row == n)
          return {};
        const unsigned int leaving = tableau.pivot(row, entering);
        if (leaving == tableau.artificial())
          return tableau.solution();
        entering = tableau.complement(leaving);
      }
    return {};
  }
} // namespace Amontons

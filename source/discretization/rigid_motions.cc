#include <amontons/discretization/rigid_motions.h>

#include <cmath>

namespace Amontons
{
  std::vector<unsigned int>
  candidates_that_hold(FullMatrix<double> values, const double none)
  {
    const unsigned int        n = values.n();
    std::vector<unsigned int> result;
    std::vector<double>       pivot(n);
    while (result.size() < n)
      {
        unsigned int row = 0, column = 0;
        double       largest = 0;
        for (unsigned int i = 0; i < values.m(); ++i)
          for (unsigned int k = 0; k < n; ++k)
            if (std::abs(values(i, k)) > largest * (1 + 1e-6))
              {
                largest = std::abs(values(i, k));
                row     = i;
                column  = k;
              }
        if (largest < none)
          break;
        result.push_back(row);
        for (unsigned int k = 0; k < n; ++k)
          pivot[k] = values(row, k);
        for (unsigned int i = 0; i < values.m(); ++i)
          {
            const double factor = values(i, column) / pivot[column];
            for (unsigned int k = 0; k < n; ++k)
              values(i, k) -= factor * pivot[k];
          }
      }
    return result;
  }
} // namespace Amontons

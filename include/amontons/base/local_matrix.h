/// Matrices on some degrees of freedom: what is assembled into a system.
#pragma once

#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <vector>

namespace Amontons
{
  using namespace dealii;

  /// One of them, rows.size() x columns.size().
  struct LocalMatrix
  {
    std::vector<types::global_dof_index> rows, columns;
    FullMatrix<double>                   matrix;
  };

  /// Those of the cells, which are square and many: dofs and matrix of cell c in [0, n).
  struct CellMatrices
  {
    unsigned int                                                              n;
    std::function<const std::vector<types::global_dof_index> &(unsigned int)> dofs;
    std::function<FullMatrix<double>(unsigned int)>                           matrix;
  };
} // namespace Amontons

/// Rigid motions as vectors of numbers, and what holds them.
#pragma once

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Amontons
{
  using namespace dealii;

  template <int dim>
  constexpr unsigned int n_rigid_motions = dim *(dim + 1) / 2;

  /// Translations e_1, .., e_dim, then rotations X_a e_b - X_b e_a in the planes (0,1), (0,2), (1,2): the
  /// component of one of them at X.
  template <int dim>
  double
  rigid_motion(const unsigned int motion, const Tensor<1, dim> &X, const unsigned int component)
  {
    if (motion < dim)
      return component == motion ? 1 : 0;
    const unsigned int a = motion < dim + 2 ? 0 : 1, b = dim == 2 || motion == dim ? 1 : dim - 1;
    return component == a ? -X[b] : component == b ? X[a] : 0;
  }

  /// values: what each candidate (row) sees of each motion (column). As many candidates as hold the motions,
  /// by Gaussian elimination with complete pivoting; what is below `none` is nothing.
  std::vector<unsigned int>
  candidates_that_hold(FullMatrix<double> values, const double none);
} // namespace Amontons

/// Linear complementarity by pivoting: for sets of states that iterations do not find.
#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <optional>

namespace Amontons
{
  /// z >= 0 with w = M z + q >= 0, z . w = 0; nothing if the path ends on a ray. Lemke's method with the
  /// lexicographic rule, which makes it finite (Cottle, Pang and Stone, The Linear Complementarity Problem,
  /// section 4.4). For copositive M it finds a solution if q . z >= 0 for all z >= 0 with M z >= 0, z . M z =
  /// 0: so it does for dry friction on bodies that are held, whatever the coefficient (see
  /// solver/condensed_friction.h). Dense: some 2 n steps of 2 n^2 operations.
  std::optional<dealii::Vector<double>>
  complementary_solution(const dealii::FullMatrix<double> &M, const dealii::Vector<double> &q);
} // namespace Amontons

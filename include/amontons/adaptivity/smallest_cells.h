// Cells that are not refined any further.
#pragma once

#include <amontons/discretization/discretization.h>

namespace Amontons
{
  // p4est ends at 29 levels, in space at 18; cells of this size hardly differ from points.
  template <int dim>
  constexpr int most_levels = dim == 2 ? 22 : 17;

  // Of this rank.
  template <typename Cell, int dim>
  bool
  may_be_refined(const Discretization<dim> &discretization, const Cell &cell)
  {
    return cell->is_locally_owned() && discretization.is_deformable(cell->material_id()) &&
           cell->level() < most_levels<dim>;
  }

  // By active cell of this rank's triangulation: the root of the sum of squares over deformable cells of
  // most_levels. Collective.
  template <int dim>
  double
  error_of_smallest_cells(const Discretization<dim> &discretization, const Vector<float> &indicators);
} // namespace Amontons

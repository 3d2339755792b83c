// Nodes of a surface one after the other.
#pragma once

#include <deal.II/base/point.h>

#include <vector>

namespace Amontons
{
  using dealii::Point;

  // The nodes of a surface in the order of a walk over its faces (2D: from the free end with the smallest x;
  // closed curves from the smallest x; each further piece after the other), or sorted by position (3D).
  // faces: node indices, ends first and last.
  template <int dim>
  std::vector<unsigned int>
  order_along_surface(const std::vector<Point<dim>>                &nodes,
                      const std::vector<std::vector<unsigned int>> &faces);
} // namespace Amontons

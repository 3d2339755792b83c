/// What lies between the facets of a mesh and the round bodies that they stand for.
#pragma once

#include <amontons/geometry/vector_area.h>

#include <deal.II/base/point.h>

#include <cmath>

namespace Amontons
{
  /// Between a facet over `face`, the mean of whose corners is `middle`, and the surface: 2/3 of its height
  /// at the middle times the area, exact for a parabola in each direction. Never negative: what a hole has
  /// too much counts alike.
  template <int dim, typename Face>
  double
  missing_volume(const Face &face, const dealii::Point<dim> &middle)
  {
    const double volume = 2. / 3 * std::abs(vector_area<dim>(face) * (face->center(true) - middle));
    return volume > 1e-10 * std::pow(face->diameter(), dim) ? volume : 0;
  }
} // namespace Amontons

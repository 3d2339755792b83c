/// What lies between the facets of a mesh and the round bodies that they stand for.
#pragma once

#include <amontons/geometry/vector_area.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/point.h>

#include <cmath>

namespace Amontons
{
  /// Between the flat face through the vertices of `face` and the surface: 2/3 of its height at the middle
  /// times the area, exact for a parabola in each direction. Never negative: what a hole has too much counts
  /// alike.
  template <int dim, typename Face>
  double
  missing_volume(const Face &face)
  {
    dealii::Tensor<1, dim> middle = -dealii::Tensor<1, dim>(face->center(true));
    for (const unsigned int v : face->vertex_indices())
      middle += dealii::Tensor<1, dim>(face->vertex(v)) / double(face->n_vertices());
    const double volume = 2. / 3 * std::abs(vector_area<dim>(face) * middle);
    return volume > 1e-10 * std::pow(face->diameter(), dim) ? volume : 0;
  }
} // namespace Amontons

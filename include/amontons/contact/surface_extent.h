// How large a surface is.
#pragma once

#include <amontons/contact/contact_surface.h>

#include <deal.II/base/bounding_box.h>

namespace Amontons
{
  // The diagonal of the box around all nodes, as they lie now.
  template <int dim>
  double
  extent(const std::vector<const ContactSurface<dim> *> &surfaces)
  {
    std::vector<Point<dim>> points;
    for (const auto *surface : surfaces)
      for (const auto &node : surface->nodes)
        points.push_back(node.x);
    const auto box = BoundingBox<dim>(points).get_boundary_points();
    return box.first.distance(box.second);
  }
} // namespace Amontons

/// Where a contact surface ends.
#pragma once

#include <amontons/contact/contact_surface.h>

namespace Amontons
{
  /// By node: whether it lies on an end of the surface, in space on an edge that belongs to one face only (or
  /// to a hanging one and a half of it).
  template <int dim>
  std::vector<bool>
  rim_nodes(const ContactSurface<dim> &surface);
} // namespace Amontons

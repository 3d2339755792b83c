// Where the contact ends between the nodes: what a finer mesh starts with.
#pragma once

#include <amontons/contact/surface_fields.h>

namespace Amontons
{
  // A function by slave node that is positive where the surfaces touch and changes sign where the contact
  // ends. A pressure falls to zero like the square root of the distance to the end, so its square is linear
  // there: at nodes that carry pressure it is p^2; at open nodes beside them its linear extrapolation from
  // the nodes under pressure nearby (at most 0: the node is open); at all others minus the largest p^2.
  template <int dim>
  std::vector<double>
  signed_pressure_square(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields);
} // namespace Amontons

/// Where the force of a pair is.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  template <int dim>
  struct ForceCentre
  {
    double     force = 0;
    Point<dim> centre;
    double     spread = 0; // root of the mean square of the distance from it
  };

  /// Of a pressure by nodal values (moment-keeping) on the overlap, where it presses. But where an edge of
  /// the other side cuts faces, pressures swing about it, and only all of them together have the right
  /// moments: so where what pulls is more than a tenth of the force, unless that leaves no spread (a few
  /// nodes).
  template <int dim>
  ForceCentre<dim>
  force_centre(const ContactInterface<dim> &interface, const std::vector<double> &pressure);
} // namespace Amontons

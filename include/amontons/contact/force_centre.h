/// Where the force of a pair is.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  template <int dim>
  struct ForceCentre
  {
    Point<dim> centre;
    double     spread = 0; // root of the mean square of the distance from it
  };

  /// Of a pressure by nodal values (moment-keeping), on the overlap. Where an edge of the other side cuts
  /// faces, pressures swing about it, and only all of them together have the right moments; of ties, and
  /// where that leaves no spread (a few nodes), what presses counts alone.
  template <int dim>
  ForceCentre<dim>
  force_centre(const ContactInterface<dim> &interface, const std::vector<double> &pressure);
} // namespace Amontons

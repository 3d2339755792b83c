/// From multipliers to a continuous function on the slave surface.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// Control values c, by slave node, of the projection (doc/introduction.md, (7)): sum_j int B_i B_j c_j =
  /// sum_rows int psi_row B_i value_row over the overlap; `nonnegative`: with c >= 0 where no value around is
  /// negative (tied), which is closer to any pressure >= 0. Nodes of which next to nothing is covered take
  /// the mean of the others of their face.
  template <int dim>
  std::vector<double>
  project(const ContactInterface<dim> &interface,
          const std::vector<double>   &row_values,
          const bool                   nonnegative = false);

  /// Nodal values of a function given by control values.
  template <int dim>
  std::vector<double>
  control_to_nodal(const ContactSurface<dim> &surface, const std::vector<double> &control);
} // namespace Amontons

/// From multipliers to a continuous function on the slave surface.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// Control values c, by slave node, of the projection (doc/introduction.md, (7)): sum_j int B_i B_j c_j =
  /// sum_rows int psi_row B_i value_row over the overlap; `nonnegative`: with c >= 0 where no value around is
  /// negative (tied), which is closer to any pressure >= 0. Nodes of which next to nothing is covered take
  /// the mean of the others of their face, those in `means` of the ones that stand there (of none: 0).
  template <int dim>
  std::vector<double>
  project(const ContactInterface<dim>                             &interface,
          const std::vector<double>                               &row_values,
          const bool                                               nonnegative = false,
          const std::map<unsigned int, std::vector<unsigned int>> &means       = {});

  /// Of quadratic faces the nodes between vertices, with those, where `linear` says so of all of them, by
  /// slave node: with their means the function is linear there.
  template <int dim>
  std::map<unsigned int, std::vector<unsigned int>>
  nodes_between(const ContactSurface<dim> &slave, const std::vector<bool> &linear);

  /// Nodal values of a function given by control values.
  template <int dim>
  std::vector<double>
  control_to_nodal(const ContactSurface<dim> &surface, const std::vector<double> &control);
} // namespace Amontons

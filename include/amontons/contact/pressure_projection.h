/// From multipliers to a continuous function on the slave surface.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// What is asked of a projection besides its nearness to the multipliers.
  struct Smoothness
  {
    /// How much the gradient jumps from a face to its neighbour, across a vertex or edge: the jump along the
    /// surface times the mean width of both faces is sum coefficient x control value, by slave node.
    struct Jump
    {
      std::vector<unsigned int>                    edge; // its vertices
      std::vector<std::pair<unsigned int, double>> terms;
    };
    /// By slave node, the nodes whose mean it takes (of none: 0).
    std::map<unsigned int, std::vector<unsigned int>> means;
    std::vector<Jump>                                 jumps;
  };

  /// Control values c, by slave node, of the projection (doc/introduction.md, (7)): sum_j int B_i B_j c_j =
  /// sum_rows int psi_row B_i value_row over the overlap; `nonnegative`: with c >= 0 where no value around is
  /// negative (tied), which is closer to any pressure >= 0. Nodes of which next to nothing is covered take
  /// the mean of the others of their face. Of jumps a quarter of the square, times the area of the vertices
  /// of the edge, adds to what is least (doc/introduction.md, *Shear where a contact has grown*).
  template <int dim>
  std::vector<double>
  project(const ContactInterface<dim> &interface,
          const std::vector<double>   &row_values,
          const bool                   nonnegative = false,
          const Smoothness            &smoothness  = {});

  /// Nodal values of a function given by control values.
  template <int dim>
  std::vector<double>
  control_to_nodal(const ContactSurface<dim> &surface, const std::vector<double> &control);
} // namespace Amontons

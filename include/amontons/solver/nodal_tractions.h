/// What a solve says of the contact nodes: the same at small and at finite strain.
#pragma once

#include <amontons/solver/contact_nodes.h>

namespace Amontons
{
  /// Of a closed node. multipliers: of its equations (stick: dim of them), none if the first has no pivot:
  /// then a slipping node has `gap`, whatever its equation wants. slip: of frictional nodes.
  template <int dim>
  NodalContact<dim>
  answer_of_closed(const SlaveNode<dim> &node,
                   const ContactStatus   state,
                   const SlipLaw<dim>   &law,
                   const Tensor<1, dim> &slip,
                   const double          gap,
                   const bool            has_multiplier,
                   const double         *multipliers);

  /// From the multipliers of its dim equations.
  template <int dim>
  void
  set_traction_of_stick(const SlaveNode<dim> &node, const double *multipliers, NodalContact<dim> &answer);

  /// Adds the forces of a slipping node's shear that do not depend on the pressure of this step (those of a
  /// node without a multiplier of their own) to owned DoFs.
  template <int dim>
  void
  add_known_shear_forces(const SlaveNode<dim> &node,
                         const SlipLaw<dim>   &law,
                         const Tensor<1, dim> &slip,
                         const IndexSet       &locally_owned,
                         LA::Vector           &forces);

  /// What rounding makes of pressures, for nodes that move by `motion`.
  template <int dim>
  double
  rounding_of_pressures(const std::vector<SlaveNode<dim>> &nodes, const double motion);
} // namespace Amontons

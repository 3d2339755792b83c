/// Node-to-segment coupling, to compare with.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// Replaces jumps and gaps of the coupling's rows: that of a slave node is taken where its normal n meets
  /// the other side,
  ///   Delta = u - sum N_q(xi) u_q,   gap = n . (x_m - x),
  /// and its force acts on the node and on that point; its area is int N_i. Which nodes carry a multiplier
  /// stays as the mortar integrals say; nodes whose normal meets nothing lose their rows. A uniform pressure
  /// passes between meshes that match only. Surfaces that have not moved.
  template <int dim>
  void
  collocate(const Discretization<dim> &discretization, ContactInterface<dim> &interface);
} // namespace Amontons

/// Motion of nodes along the surface before they touch: no slip, although in the increment in which they
/// close.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  /// By pair and slave node, of the increment that begins at `state`, from the one that ended there: a node
  /// that was open in both of its ends, and came nearer by a from the gap g + a while it moved by s along the
  /// surface, is taken to touch after s g/a more (at most s; nothing if g > 2a, as it does not touch then).
  /// Where contact grows, gap and motion are proportional to each other, also near its edge, where both grow
  /// with the power 3/2 of the distance: doc/introduction.md, "The load program".
  template <int dim>
  std::vector<std::vector<Tensor<1, dim>>>
  motion_before_touch(const SolutionState<dim> &state);

  /// What is known of the nodes where the couplings are now, and nothing touches. mean: gaps as of surfaces
  /// that move.
  template <int dim>
  std::vector<NodalContacts<dim>>
  contact_at_rest(const std::vector<ContactInterface<dim>> &interfaces, const bool mean);
} // namespace Amontons

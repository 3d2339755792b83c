/// Where two surfaces touch, as a region: can pressures on it hold the bodies?
#pragma once

#include <amontons/solver/newton_step.h>

namespace Amontons
{
  /// Whose tractions count.
  enum class ContactRegion
  {
    closed,  // the covered parts of the faces with closed nodes, within the bounds of friction
    anywhere // all that is covered, with whatever friction
  };

  /// Whether the region ends within a slave face: else nodes carry nothing from beyond.
  template <int dim>
  bool
  ends_at_an_edge(const ContactEquilibrium<dim> &problem, const ContactRegion region);

  /// A rigid motion that the loads drive although neither supports nor any traction on the region works
  /// against it; empty if there is none. A node beyond the edge of the other side carries the pressure of the
  /// covered part of its faces, and its resultant lies at the node (int psi_i x = D_i x_i), where nothing is
  /// opposite: p_i >= 0 does not exclude that a body stands by such forces alone. The region is taken a
  /// little too large, and friction as unlimited where its coefficient is no constant: what is excluded is
  /// excluded rightly. floating: with the loads, and where the surfaces are.
  template <int dim>
  std::vector<double>
  motion_beyond_region(const ContactEquilibrium<dim> &problem,
                       const FloatingBodies<dim>     &floating,
                       const ContactRegion            region);
} // namespace Amontons

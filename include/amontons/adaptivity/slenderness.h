// What stress does to the stiffness of slender bodies.
#pragma once

#include <amontons/elasticity/stress_recovery.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  // As in a cantilever under the load P, of all bodies the largest P over Euler's load,
  //   48/pi^2 (sigma/E) ((L/h)^2 - 25),
  // with sigma in the mean square, h = 2 volume/surface, and for L how far points of the body are at most
  // from what holds it: supports of all directions, and contact that pinches it from both sides, within 2 h
  // of each other; without any its size. 0 for bodies that are stout. No less than at_least. contact: by pair
  // and slave node. Collective.
  template <int dim>
  double
  stress_stiffening(const Discretization<dim>                &discretization,
                    const StressRecovery<dim>                &recovery,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<NodalContacts<dim>>    &contact,
                    const double                              at_least);
} // namespace Amontons

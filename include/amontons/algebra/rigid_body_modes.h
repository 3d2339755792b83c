// The near null space of elasticity, for algebraic multigrid.
#pragma once

#include <amontons/discretization/discretization.h>

namespace Amontons
{
  // Translations and rotations at the owned DoFs, by mode (axisymmetric: the two translations).
  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<dim> &discretization);
} // namespace Amontons

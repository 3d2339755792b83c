/// How far an iterate is from equilibrium and from the equations of its closed nodes.
#pragma once

#include <amontons/solver/newton_step.h>

namespace Amontons
{
  /// Of forces that should vanish: what test functions see of them, with the error of friction, over
  /// now.force_scale. With the excess (see FiniteStrainCell) it is that of the displacement alone, but for
  /// the square of the excess. pins: DoFs that keep motions at rest which nothing holds or drives, but for
  /// what facets make of a curve; their reactions are none of it (moments beyond 1e-3 of the forces are seen
  /// by the checks of the physics).
  template <int dim>
  double
  relative_residual(const ContactEquilibrium<dim>              &problem,
                    const Iterate<dim>                         &now,
                    const LA::Vector                           &unbalanced,
                    const std::vector<types::global_dof_index> &pins);

  /// Forces of the excess that balance each other, as under uniform stress, are seen by none of the free
  /// rows; but supports and closed nodes carry them.
  template <int dim>
  double
  relative_excess(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now);

  /// Distance of a closed node from its equations, relative to the faces; the largest.
  template <int dim>
  double
  largest_violation(const ContactEquilibrium<dim> &problem, const Iterate<dim> &now);
} // namespace Amontons

/// How contact states get to another mesh: as a field on the slave nodes, SolutionState::traction.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  /// Makes traction and peaks of the state. fields: of its contact, by pair. Collective.
  template <int dim>
  void
  make_traction_field(const Discretization<dim>                &discretization,
                      const std::vector<ContactInterface<dim>> &interfaces,
                      const std::vector<SurfaceFields<dim>>    &fields,
                      SolutionState<dim>                       &state);

  /// The first guess that traction and peaks make on the present mesh: nodes start closed where the other
  /// mesh's pressure, continued beyond its last node, is positive; with friction they slip where the trial
  /// shear exceeds its bound.
  template <int dim>
  void
  carry_active_set(const std::vector<ContactInterface<dim>> &interfaces, SolutionState<dim> &state);
} // namespace Amontons

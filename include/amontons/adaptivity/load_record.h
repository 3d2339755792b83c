/// What is kept of a load program with friction, to compare it with another one (increment_error.h).
#pragma once

#include <amontons/adaptivity/increment_error.h>
#include <amontons/contact/contact_interface.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  /// Before an increment is committed. Whether any node with friction has closed in it.
  template <int dim>
  bool
  note_closed(const std::vector<ContactInterface<dim>> &interfaces,
              const SolutionState<dim>                 &state,
              LoadRecord::ClosedNodes                  &closed);

  /// Contact at the end of an increment; fields: of the state, by pair; closed: since the landing before.
  /// Tied pairs are left out.
  template <int dim>
  std::vector<LoadRecord::Pair>
  record_pairs(const std::vector<ContactInterface<dim>> &interfaces,
               const std::vector<SurfaceFields<dim>>    &fields,
               const SolutionState<dim>                 &state,
               const LoadRecord::ClosedNodes            &closed);

  /// Enough nodes of a pair with friction touch to see how slip spreads.
  template <int dim>
  bool
  resolves_friction(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState<dim> &state);

  /// Faces are larger than a hundredth of the contact (in space a twentieth) of the pair with friction that
  /// has most closed nodes: a zone that sticks may be smaller than they are.
  template <int dim>
  bool
  may_hide_stick(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState<dim> &state);
} // namespace Amontons

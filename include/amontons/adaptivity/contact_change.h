// What finite strain makes of the contact.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  struct ContactChange
  {
    double forces = 0, pressures = 0, shift = 0;
    bool   has_resultant = false; // some pair's forces do not balance, as around a closed ring
  };

  // The largest change of a pair's force, against the largest force; the change of the pressures of all
  // pairs in the mean square, wherever they are; and how far a pair's force moves along the slave, by its
  // part of the largest force, against `size`. (A contact that is much smaller than its body may be the
  // same a little beside.) What touches with finite strain alone is all new.
  template <int dim>
  ContactChange
  change_of_contact(const std::vector<ContactInterface<dim>> &interfaces,
                    const SolutionState<dim>                 &state,
                    const std::vector<ContactInterface<dim>> &finite_interfaces,
                    const SolutionState<dim>                 &finite_state,
                    const double                              size);
} // namespace Amontons

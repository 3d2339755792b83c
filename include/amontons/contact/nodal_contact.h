/// What is known of one slave node in one pair.
#pragma once

#include <deal.II/base/tensor.h>

#include <vector>

namespace Amontons
{
  enum class ContactStatus : char
  {
    open,
    slip, // closed, free to move tangentially (all closed nodes of frictionless contact)
    stick // closed, held in all directions (tied interfaces)
  };

  /// Contact traction on the slave: -(pressure normal + shear), a force per area.
  template <int dim>
  struct NodalContact
  {
    bool                   has_multiplier = false; // else nothing else is said
    ContactStatus          state          = ContactStatus::open;
    double                 pressure = 0, gap = 0;
    dealii::Tensor<1, dim> shear; // friction: along the slip of the slave
    dealii::Tensor<1, dim> slip;  // in this increment; tied: none
    dealii::Tensor<1, dim> trial; // (shear + c slip)/bound, for the next guess; see SolutionState::traction
  };

  template <int dim>
  using NodalContacts = std::vector<NodalContact<dim>>;
} // namespace Amontons

// Contact nodes on planes that supports keep them in.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  // See SlaveNode.
  template <int dim>
  struct NodePlanes
  {
    bool                            ridge;
    std::vector<Tensor<1, dim>>     planes;
    std::array<Tensor<1, dim>, dim> directions;
  };

  // Of the row's node; where nothing ties it and there is no friction, directions are not asked for, and no
  // ridge counts.
  template <int dim>
  NodePlanes<dim>
  planes_at(const ContactInterface<dim> &interface, const MortarRow<dim> &row);
} // namespace Amontons

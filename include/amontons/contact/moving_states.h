// States of the nodes of a contact surface in the plane whose ends of contact and of stick move on.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  // Along the surface nodes are open, slip or stick in parts, with ends halfway between two nodes. If there
  // are the same parts at the times t0 and t1, their ends go on to t as they moved in between, and nodes take
  // the state of the part that they are in then (as an equal node nearby has it). Nothing if the parts are
  // others, one would vanish, or hardly any node changes; nor in space. earlier, now: by slave node.
  template <int dim>
  std::optional<NodalContacts<dim>>
  move_states_on(const ContactInterface<dim> &interface,
                 const NodalContacts<dim>    &earlier,
                 const double                 t0,
                 const NodalContacts<dim>    &now,
                 const double                 t1,
                 const double                 t);
} // namespace Amontons

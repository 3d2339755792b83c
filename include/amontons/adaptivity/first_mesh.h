// What the first mesh must have, whatever the scene gives.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  // Marks the cells of deformable bodies behind slave and master faces that may touch first: faces with
  // overlap points whose gap exceeds the smallest of the pair by at most `distance` times the face's size.
  // Pairs with enough (8, in 3D 24) close faces, or all of whose faces are close (conforming surfaces), are
  // left alone; not flat_too: nor those whose sides lie on each other wherever they meet, which a number
  // does not ask to be finer. (Pressures beside the rim do.) Returns how many it marked, on all ranks.
  // Collective.
  template <int dim>
  unsigned int
  mark_close_cells(const Discretization<dim>                &discretization,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const double                              distance,
                   const bool                                flat_too = true);

  // Marks the cells of deformable bodies behind faces that meet the other side and are more than twice as
  // large as all of it: a small body on one large face meets stiffness that has nothing to do with the
  // body's, and no indicator sees that. Returns how many it marked, on all ranks. Collective.
  template <int dim>
  unsigned int
  mark_cells_at_small_surfaces(const Discretization<dim>                &discretization,
                               const std::vector<ContactInterface<dim>> &interfaces);
} // namespace Amontons

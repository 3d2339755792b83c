/// How smooth the shear is shown where a contact has grown.
#pragma once

#include <amontons/contact/pressure_projection.h>

namespace Amontons
{
  /// Functions that are linear between the vertices of faces, as far as `linear` says so of all nodes there,
  /// by slave node, and the jumps of their gradients from one such face to the next, where the surface goes
  /// straight on (none beside coarser faces).
  template <int dim>
  Smoothness
  smooth_on(const ContactSurface<dim> &slave, const std::vector<bool> &linear);

  /// What a node touched at stays with it as long as it sticks. The edge of the contact passes vertices,
  /// middles of faces and faces of other sizes in other ways, so that the shear goes up and down between
  /// nodes on any mesh (doc/introduction.md, *Shear where a contact has grown*). Where nodes stick that were
  /// open when an increment after the first began (was_open, by slave node; empty: none was), and on the rest
  /// of their faces, it is shown smooth. Of `fields`, states and areas are read.
  template <int dim>
  Smoothness
  shear_smoothness(const ContactInterface<dim> &interface,
                   const SurfaceFields<dim>    &fields,
                   const std::vector<bool>     &was_open);
} // namespace Amontons

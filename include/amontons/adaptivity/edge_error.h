/// The error of the pressure that the place of the end of contact in its face decides.
#pragma once

#include <amontons/contact/surface_fields.h>

#include <deal.II/base/quadrature.h>

namespace Amontons
{
  /// By slave face: the integral of (sqrt(max(0, s)) - p)^2, with the nodal values of
  /// signed_pressure_square() for s and the discrete pressure p, over faces of which some nodes carry
  /// pressure and others are open, and those that share nodes with them, where the other side is opposite, if
  /// it deforms; 0 elsewhere, and on pairs that are tied. In space, times cos(2 a)^4 where the end makes the
  /// angle a with a side of the unit face: if it crosses faces at all places recovery is right in the mean.
  /// All ranks get all faces. See doc/introduction.md, *The end of the contact*.
  template <int dim>
  std::vector<double>
  edge_errors(const ContactInterface<dim> &interface,
              const SurfaceFields<dim>    &fields,
              const Scene                 &scene,
              const Quadrature<dim - 1>   &quadrature);
} // namespace Amontons

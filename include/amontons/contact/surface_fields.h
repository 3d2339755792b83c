// From multipliers to what a person wants to see on the slave surface.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  // contact: by slave node. unused_shears: by coupling row, what is left of the bound of friction, >= 0.
  // `displacement` readable at relevant DoFs. Symmetry planes and
  // the axis give the centre of the contact where the slave touches them; else the centre of force. was_open:
  // by slave node, at the end of an increment before (empty: none was). Where such nodes stick, the traction
  // of quadratic faces is linear between their vertices.
  template <int dim>
  SurfaceFields<dim>
  make_surface_fields(const Discretization<dim>   &discretization,
                      const ContactInterface<dim> &interface,
                      const NodalContacts<dim>    &contact,
                      const std::vector<double>   &unused_shears,
                      const LA::Vector            &displacement,
                      const std::vector<bool>     &was_open = {});

  // Value at a point of a slave face of a field given by nodal values (Lagrange interpolation).
  template <int dim>
  double
  value_on_face(const ContactSurface<dim> &surface,
                const std::vector<double> &nodal_values,
                const unsigned int         face,
                const Point<dim - 1>      &xi);
  // What tables and pictures show at node i: nothing beyond the edge of the other side, and no more shear
  // than friction allows there.
  template <int dim>
  double
  shown_pressure(const SurfaceFields<dim> &fields, const unsigned int i)
  {
    return fields.is_covered[i] ? fields.pressure[i] : 0;
  }

  template <int dim>
  Tensor<1, dim>
  shown_traction(const SurfaceFields<dim> &fields, const unsigned int i)
  {
    const double length = fields.traction[i].norm();
    if (!fields.is_covered[i])
      return Tensor<1, dim>();
    return fields.bound.empty() || length <= fields.bound[i] ? fields.traction[i]
                                                             : fields.bound[i] / length * fields.traction[i];
  }
} // namespace Amontons

/// What errors of the stress around a contact do to its pressure.
#pragma once

#include <amontons/contact/contact_interface.h>

#include <deal.II/lac/vector.h>

namespace Amontons
{
  struct PollutionError
  {
    double              square = 0; ///< of the L2 norm of the pressure's error
    std::vector<double> by_cell;    ///< its shares, by active cell of this rank; may be empty for none
  };

  /// Recovery on the surface sees the errors that the mesh makes there. Coarse cells around a contact move
  /// its surfaces, too: a cell of length h, at the distance s of the nearest node that presses, with the
  /// squared error eta^2 of the stress in the energy norm, adds
  ///
  ///   C E*^2/E eta^2 (h/s)^(2 degree) / s  min(1, b/s)^2 prod_i min(1, b_i/s)
  ///
  /// to the squared L2 error of the pressure; b_i are half the lengths of the connected part of the contact
  /// along its axes, b the least of them. Cells up to 5 times as long as high count as squares of
  /// their area, and h < s; of those more than 12 times as long h is the length, 1.5 s at most, and s no less
  /// than their height. See doc/introduction.md, *Coarse cells around a contact*.
  ///
  /// modulus: E*. bulk_squares: eta^2 by active cell. displacement: where places are those of now (finite
  /// strain), readable at relevant DoFs; else null. None for tied pairs. Collective.
  template <int dim>
  PollutionError
  pollution_error(const Discretization<dim>   &discretization,
                  const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const double                 modulus,
                  const std::vector<double>   &bulk_squares,
                  const LA::Vector            *displacement);
} // namespace Amontons

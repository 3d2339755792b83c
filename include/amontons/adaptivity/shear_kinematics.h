// What small strain makes of the shear tractions.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// The relative error of the shear in the mean square over all pairs with friction, if that of the answer
  /// is e, is amplification * e + directions.
  struct ShearKinematics
  {
    /// What slips follows the pressure, and is off by as much. What sticks follows from small differences of
    /// motions, of which more is left out: six times as much (seen: 2 to 8). In the mean square.
    double amplification = 1;
    /// Where the normals are those of the slave, p (n - N) against the shear, see common_normal.h; and what
    /// the force of a pair turns by, times its size over that of the shear (at least noteworthy_shear).
    double directions = 0;
  };

  /// contact: by pair and slave node; turn: see NeglectedTerms. Empty: no pair has friction and pressure.
  template <int dim>
  std::optional<ShearKinematics>
  shear_kinematics(const Discretization<dim>                &discretization,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const std::vector<NodalContacts<dim>>    &contact,
                   const double                              turn);
} // namespace Amontons

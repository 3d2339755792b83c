/// Slave nodes that carry no multiplier, as supports prescribe where they are.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  /// Reference positions of slave nodes whose displacements are prescribed and which lie in a rigid obstacle,
  /// by more than a tenth of the mean face (beyond what they overlapped by in the reference configuration):
  /// no state of the bodies is an answer to that, and the weighted gaps of their neighbours do not see it.
  /// u: readable at the DoFs of the surfaces. Gaps that the scene declares are not looked at.
  template <int dim>
  std::vector<Point<dim>>
  driven_through(const Discretization<dim>                &discretization,
                 const Constraints                        &supports,
                 const LA::Vector                         &u,
                 const std::vector<ContactInterface<dim>> &interfaces);
} // namespace Amontons

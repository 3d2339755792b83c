// What small strain leaves out.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  // Of an answer with small strain; both relative.
  struct NeglectedTerms
  {
    // |1/2 H^T H| / |sym H|, H = grad u, in the energy norm of small strain: the quadratic part of Green's
    // strain, which a rotation alone has, too.
    double strain = 0;
    // Gaps of the closed nodes where the surfaces really are (they should be 0; root mean square over the
    // contact), against the largest motion of the slave surface.
    double contact = 0;

    double
    largest() const
    {
      return std::max(strain, contact);
    }
  };

  // Leaves the interfaces moved to the displacement. Collective.
  template <int dim>
  NeglectedTerms
  neglected_terms(const Discretization<dim>          &discretization,
                  const Constraints                  &supports,
                  const SolutionState                &state,
                  std::vector<ContactInterface<dim>> &interfaces);
} // namespace Amontons

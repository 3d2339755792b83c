// What a converged (or current) state consists of.
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/contact/contact_state.h>

#include <vector>

namespace Amontons
{
  struct SolutionState
  {
    double     t = 0;
    LA::Vector displacement; // readable at relevant DoFs; obeys hanging nodes and supports
    // Contact pressure of the pairs as a field on the displacement's DoFs (traction vector at slave nodes,
    // zero elsewhere): only to carry the active set from one mesh to the next.
    LA::Vector traction;
    // By pair and coupling row
    std::vector<std::vector<ContactState>> states;
    std::vector<std::vector<double>>       pressures;
    std::vector<std::vector<double>>       gaps;
    std::vector<std::vector<std::vector<double>>>
        tied_multipliers; // by component, for tied pairs: force per area
  };
} // namespace Amontons

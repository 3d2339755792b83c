// What a converged (or current) state consists of.
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/contact/contact_state.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Amontons
{
  // Contact traction on the slave: -(pressure normal + shear).
  struct SolutionState
  {
    double     t = 0;
    LA::Vector displacement; // readable at relevant DoFs; obeys hanging nodes and supports
    // The displacement that the increment started from, all the history there is: slip is the change of the
    // tangential jump since then. Empty: none.
    LA::Vector committed;
    double     committed_t = 0; // its time
    // A field on the slave nodes' DoFs (zero elsewhere) that carries the states from one mesh to the next:
    // along the normal (p/peak)^2, continued to negative values beyond the contact; along the surface the
    // trial shear over its bound, a node slipping where this exceeds 1.
    LA::Vector                     traction;
    std::vector<double>            peaks;   // of p, by pair
    std::vector<std::vector<bool>> carried; // by pair: slave nodes with a row
    // By pair and coupling row
    std::vector<std::vector<ContactState>> states;
    std::vector<std::vector<double>>       pressures;
    std::vector<std::vector<double>>       gaps;
    std::vector<std::vector<dealii::Tensor<1, 3>>>
        shears; // force per area; friction: along the slip of the slave
    std::vector<std::vector<dealii::Tensor<1, 3>>>
        trials; // (shear + c slip)/bound, for the next guess; see traction
    std::vector<std::vector<dealii::Tensor<1, 3>>> slips; // in this increment
  };
} // namespace Amontons

// Displacement and recovered stress at the points that the scene names.
#pragma once

#include <amontons/elasticity/stress_recovery.h>
#include <amontons/output/summary.h>

namespace Amontons
{
  // Points are given in the reference configuration. A point that no cell of the body holds, but that lies
  // within 1 % of a cell's size from one (on a curved boundary, say), takes that cell's nearest value; others
  // are left empty and named in `notes`. Collective; the result is the same on all ranks: of several cells
  // that hold a point, that of the lowest rank counts.
  template <int dim>
  std::vector<ProbeSummary>
  evaluate_probes(const Discretization<dim> &discretization,
                  const StressRecovery<dim> &recovery,
                  const LA::Vector          &displacement,
                  std::vector<std::string>  &notes);
} // namespace Amontons

/// The numbers that `Target quantity` names.
#pragma once

#include <amontons/output/energy.h>
#include <amontons/output/quantities.h>

namespace Amontons
{
  /// peak pressure | contact size | stick size | total force | approach: of each pair (0: it has none);
  /// energy | dissipation: one. Collective.
  template <int dim>
  std::vector<double>
  target_quantity(const std::string &name, const Answer<dim> &answer, const WorkDone<dim> &work);
} // namespace Amontons

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

  /// How many times as large as that of the answer its error by small strain is. Ten for stick size and
  /// dissipation, which follow from slip, in which motions of surfaces differ by little: of half a disk,
  /// pressed on a block until contact is 0.13 of its radius wide, 2.5 % are left out, and the dissipation is
  /// off by 30 to 40 %. Else one.
  double
  sensitivity_to_kinematics(const std::string &name);
} // namespace Amontons

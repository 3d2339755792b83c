/// The numbers that `Target quantity` names.
#pragma once

#include <amontons/output/energy.h>
#include <amontons/output/quantities.h>

namespace Amontons
{
  /// peak pressure | contact size | stick size | total force (along symmetry planes that cut the
  /// contact) | approach: of each pair (0: it has none); energy | dissipation: one. Collective.
  template <int dim>
  std::vector<double>
  target_quantity(const std::string &name, const Answer<dim> &answer, const WorkDone<dim> &work);

  /// The contact size or the stick size.
  bool
  is_size(const std::string &name);

  /// Whether it has a limit however sharp an edge presses: works, and forces that displacements cause.
  bool
  always_converges(const std::string &name);

  /// The relative error of the target quantity by small strain, as a multiple of what is estimated for the
  /// shear traction: one of the shear itself (`contact pressure` asks for the worse of both), two of the
  /// stick size, five of the dissipation: the slip that they follow from is a small difference of motions.
  /// (NAFEMS R0094-1 with mu = 0.1: 12 % estimated for the shear, 21 % off in the stick size, 62 % in the
  /// dissipation; at a tenth of the load 3, 7 and 13 %.) None: it does not follow from the shear.
  std::optional<double>
  sensitivity_to_shear(const std::string &name);

  /// What smaller values count against: of the dissipation a part of the work, of the approach (0 but for
  /// facets where both sides are held) a part of the largest displacement, of the stick size one of the
  /// largest contact size, else nothing. Collective.
  template <int dim>
  double
  noteworthy_value(const std::string &name, const Answer<dim> &answer, const WorkDone<dim> &work);

  /// What iterations leave, of the largest work and force of a load program, of one that comes back to zero.
  double
  rest_of_value(const std::string &name, const double largest_work, const double largest_force);
} // namespace Amontons

/// Contact and friction on the contact nodes alone, all at once.
#pragma once

#include <amontons/solver/active_set_lookahead.h>

namespace Amontons
{
  /// States, pressures and shears of all nodes that obey the laws of contact and friction, as a
  /// complementarity problem with the compliance of the nodes. With pressures and shears as lengths (over c),
  /// the slip v, and the shear q = q+ - q- along it,
  ///
  ///   gap >= 0              , p >= 0           lambda - v >= 0, q+ >= 0
  ///   phi(p) - q+ - q- >= 0 , lambda >= 0      lambda + v >= 0, q- >= 0
  ///
  /// each times its partner zero (doc/introduction.md, (20); Stewart and Trinkle, Int. J. Numer. Methods Eng.
  /// 39 (1996) 2673). The matrix is copositive, and bodies that are held have a solution that Lemke's method
  /// finds, whatever the coefficient (Anitescu and Potra, Nonlinear Dynamics 14 (1997) 231). Plane problems
  /// only. base: with all nodes open but the tied ones; bounds: by node, linear in the pressure.
  template <int dim>
  std::optional<NodalContacts<dim>>
  solve_condensed_friction(const BaseSolution<dim>                         &base,
                           const typename ActiveSetLookahead<dim>::Respond &respond,
                           const std::vector<ShearBound>                   &bounds);

  /// The same without friction, in the plane and in space, from any base: of its open nodes gap >= 0 and p >=
  /// 0, p gap = 0 with the pressures as unknowns, of its closed ones with the gaps. (A principal pivotal
  /// transform of the compliance: monotone, as that is.) Only nodes that pull or overlap take part, and those
  /// that do then; nothing if these are more than n_most.
  template <int dim>
  std::optional<NodalContacts<dim>>
  solve_condensed_contact(const BaseSolution<dim>                         &base,
                          const typename ActiveSetLookahead<dim>::Respond &respond,
                          const unsigned int                               n_most);
} // namespace Amontons

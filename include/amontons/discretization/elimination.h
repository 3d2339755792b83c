// One linear equation, written into AffineConstraints by eliminating one of its degrees of freedom.
#pragma once

#include <amontons/base/linear_algebra.h>

#include <optional>

namespace Amontons
{
  // sum_d coefficient_d u_d = value
  struct LinearEquation
  {
    Coefficients coefficients;
    double       value = 0;
  };

  // Replaces every DoF of the equation that `constraints` already eliminates (directly or through others) by
  // what it depends on.
  void
  substitute(LinearEquation &equation, const Constraints &constraints);

  // The DoF among `candidates` to be eliminated: unconstrained and with the largest coefficient. Empty if
  // none exceeds `threshold` (others own the node); equations are scaled by unit normals, so that 1 is large.
  std::optional<types::global_dof_index>
  choose_pivot(const LinearEquation                       &equation,
               const Constraints                          &constraints,
               const std::vector<types::global_dof_index> &candidates,
               const double                                threshold = 1e-6);

  // Adds the line u_pivot = (value - sum of the others) / coefficient_pivot.
  void
  eliminate(const LinearEquation &equation, const types::global_dof_index pivot, Constraints &constraints);

  // Closes the constraints. Lines refer to DoFs that were eliminated after them, these to others: each is
  // replaced by what it comes to first. AffineConstraints::close() replaces entry by entry without collecting
  // equal ones, which takes a time exponential in the length of the chain. order: the DoFs in the order of
  // their elimination.
  void
  close_chains(const std::vector<std::optional<types::global_dof_index>> &order, Constraints &constraints);
} // namespace Amontons

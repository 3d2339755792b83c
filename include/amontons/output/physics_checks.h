/// Whether an answer obeys the laws.
#pragma once

#include <amontons/output/quantities.h>

namespace Amontons
{
  /// force_balance: norm of loads + reactions + contact forces - internal forces where no support acts,
  /// relative to that of all of them; moment_balance: their moment on a body about the origin, relative to
  /// the sum of all forces on it times its size (both: at least what a strain of 1e-9 takes);
  /// complementarity: max |p g| relative to p_max times the mean face size; penetration: max(-g) relative to
  /// the face size; tension: max(-p) relative to p_max; coulomb_cone: how far shears exceed their bound,
  /// relative to the largest bound; slip_direction: the largest angle between shear and slip of a node (that
  /// of the multiplier, not of the projected traction); normal_mismatch: the sine of the angle between
  /// the normals of both sides where the slave ends or has an edge, times the part of a pair's force there if
  /// that is most of it; corner_forces: what the forces there have along other directions than the normals
  /// of the other side, their sum over all pairs of the same two relative to the forces. largest_so_far: of
  /// the pressures. Collective.
  template <int dim>
  std::map<std::string, double>
  check_physics(const Answer<dim> &answer, const double largest_so_far = 0);

  /// That check alone.
  template <int dim>
  double
  corner_forces(const Answer<dim> &answer);

  /// Those laws that no answer may break by more than the tolerance, and by how much; empty: none is.
  std::string
  broken_laws(const std::map<std::string, double> &checks, const double tolerance);
} // namespace Amontons

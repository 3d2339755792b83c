// The numbers of a run: forces, sizes, energies, reactions, and checks of the physics.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/output/summary.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  // Everything that the numbers are computed from; all functions here are collective.
  template <int dim>
  struct Answer
  {
    const Discretization<dim>                &discretization;
    const ElasticityOperator<dim>            &elasticity;
    const std::vector<ContactInterface<dim>> &interfaces;
    const std::vector<SurfaceFields<dim>>    &fields;
    const Constraints                        &supports;
    const LA::Vector                         &loads; // raw
    const SolutionState<dim>                 &state;
  };

  // Contact force on every DoF of slave and master: -+ weight area Lambda with Lambda = p normal + shear.
  template <int dim>
  std::map<types::global_dof_index, double>
  contact_forces(const Answer<dim> &answer);

  template <int dim>
  std::vector<PairSummary>
  summarize_pairs(const Answer<dim> &answer);

  // Stored energy 1/2 u . K u.
  template <int dim>
  double
  stored_energy(const Answer<dim> &answer);

  // Forces of the supports on the bodies: internal minus external minus contact forces on the nodes of each
  // constrained boundary (a node on several conditions counts for the first), with their moment about the
  // origin.
  template <int dim>
  std::vector<ReactionSummary>
  compute_reactions(const Answer<dim> &answer);

  // force_balance: norm of loads + reactions + contact forces - internal forces where no support acts,
  // relative to that of all of them; moment_balance: their moment on a body about the origin, relative to
  // contact forces times its size; complementarity: max |p g| relative to p_max times the mean face size;
  // penetration: max(-g) relative to the face size; tension: max(-p) relative to p_max; coulomb_cone: how far
  // shears exceed their bound, relative to the largest bound; slip_direction: the largest angle between shear
  // and slip of a node (that of the multiplier, not of the projected traction).
  template <int dim>
  std::map<std::string, double>
  check_physics(const Answer<dim> &answer);
} // namespace Amontons

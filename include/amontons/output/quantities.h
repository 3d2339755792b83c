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
} // namespace Amontons

// From an iteration to the state that outlives it.
#pragma once

#include <amontons/solver/node_states.h>

namespace Amontons
{
  // Fills states, pressures, gaps, shears, trials and slips, by interface and coupling row.
  template <int dim>
  void
  store_states(const std::vector<CandidateNode<dim>>    &nodes,
               const NodeStates<dim>                    &states,
               const std::vector<NodeAnswer<dim>>       &answers,
               const std::vector<ContactInterface<dim>> &interfaces,
               SolutionState                            &state);

  // After the surfaces were coupled anew: what the state says by row now refers to the present rows. Nodes
  // keep what they had; those without a row before are open.
  template <int dim>
  void
  fit_states(const std::vector<ContactInterface<dim>> &interfaces, SolutionState &state);
} // namespace Amontons

// Sparsity of elasticity, node by node: all components of two linked nodes are linked.
#pragma once

#include <amontons/base/linear_algebra.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <vector>

namespace Amontons
{
  using Nodes = std::vector<types::global_dof_index>; // sorted, each once: their first DoFs over components

  void
  sort_once(std::vector<types::global_dof_index> &numbers);

  // What a DoF stands for under constraints.
  template <typename Action>
  void
  for_each_entry(const Constraints &constraints, const types::global_dof_index dof, const Action &action)
  {
    if (!constraints.is_constrained(dof))
      action(dof, 1.);
    else
      for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
        action(other, weight);
  }

  // DoFs are numbered node by node, as those of FESystem(FE_Q, n_components) are; a rank has whole nodes.
  class NodePattern
  {
  public:
    NodePattern(const IndexSet &locally_owned, const IndexSet &relevant, const unsigned int n_components);

    void
    add(const Nodes &nodes); // all with all
    void
    add(const types::global_dof_index row, const Nodes &columns);

    // An empty matrix with these entries but for those of constrained DoFs, which keep their diagonals only.
    // Collective.
    void
    make_matrix(const Constraints &constraints, const MPI_Comm communicator, LA::SparseMatrix &matrix);

  private:
    const IndexSet         locally_owned, relevant;
    const unsigned int     n_components;
    DynamicSparsityPattern pattern; // rows: relevant nodes
  };
} // namespace Amontons

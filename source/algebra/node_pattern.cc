#include <amontons/algebra/node_pattern.h>

#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    IndexSet
    nodes_of(const IndexSet &dofs, const unsigned int n_components)
    {
      IndexSet nodes(dofs.size() / n_components);
      for (auto interval = dofs.begin_intervals(); interval != dofs.end_intervals(); ++interval)
        nodes.add_range(*interval->begin() / n_components, interval->last() / n_components + 1);
      nodes.compress();
      return nodes;
    }
  } // namespace

  void
  sort_once(std::vector<types::global_dof_index> &numbers)
  {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  NodePattern::NodePattern(const IndexSet    &locally_owned,
                           const IndexSet    &relevant,
                           const unsigned int n_components)
      : locally_owned(locally_owned), relevant(relevant), n_components(n_components),
        pattern(nodes_of(relevant, n_components))
  {
  }

  void
  NodePattern::add(const Nodes &nodes)
  {
    for (const auto row : nodes)
      add(row, nodes);
  }

  void
  NodePattern::add(const types::global_dof_index row, const Nodes &columns)
  {
    pattern.add_entries(row, columns.begin(), columns.end(), true);
  }

  void
  NodePattern::make_matrix(const Constraints &constraints,
                           const MPI_Comm     communicator,
                           LA::SparseMatrix  &matrix)
  {
    const IndexSet nodes = nodes_of(locally_owned, n_components);
    SparsityTools::distribute_sparsity_pattern(pattern, nodes, communicator, pattern.row_index_set());
    DynamicSparsityPattern               dofs(locally_owned.size(), locally_owned.size(), locally_owned);
    std::vector<types::global_dof_index> columns;
    const auto                           is_free = [&](const types::global_dof_index dof) {
      return !relevant.is_element(dof) || !constraints.is_constrained(dof);
    };
    for (const auto node : nodes)
      {
        pattern.add(node, node);
        columns.clear();
        for (unsigned int k = 0; k < pattern.row_length(node); ++k)
          for (unsigned int d = 0; d < n_components; ++d)
            if (const auto dof = pattern.column_number(node, k) * n_components + d; is_free(dof))
              columns.push_back(dof);
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const auto row = node * n_components + c;
            if (is_free(row))
              dofs.add_entries(row, columns.begin(), columns.end(), true);
            else
              dofs.add(row, row);
          }
      }
    matrix.reinit(locally_owned, locally_owned, dofs, communicator);
  }
} // namespace Amontons

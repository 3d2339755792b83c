// Adds cell matrices to a matrix whose pattern stays, without looking for the places of their entries.
#pragma once

#include <amontons/algebra/eliminated_system.h>

namespace Amontons
{
  // Adds C_rows^T block C_columns. Rows of constrained DoFs get no diagonal entry. Columns are sorted once
  // and found by one walk through each row of the matrix.
  void
  add_condensed(const FullMatrix<double>                   &block,
                const std::vector<types::global_dof_index> &rows,
                const std::vector<types::global_dof_index> &columns,
                const Constraints                          &of_rows,
                const Constraints                          &of_columns,
                LA::SparseMatrix                           &matrix);

  // The pattern and the supports of a Newton iteration stay while its values change. Places of the entries
  // among the values of the matrix are found once, for cells of which this rank owns all rows, one for each
  // row and run of columns that follow one another (components of a node).
  class DirectScatter
  {
  public:
    // Returns the cells that it cannot serve.
    std::vector<unsigned int>
    setup(const LA::SparseMatrix &matrix, const CellMatrices &cells, const Constraints &constraints);

    // C^T K C of these cells.
    void
    add(const CellMatrices &cells, LA::SparseMatrix &matrix) const;

  private:
    // What DoF `from` of the cell gives to DoF `to` of those that it stands for.
    struct Share
    {
      unsigned int from, to;
      double       weight;
    };
    struct Target
    {
      unsigned int              cell, n_rows;
      std::vector<unsigned int> runs;   // lengths
      std::vector<Share>        shares; // none: the cell has no constraints
    };

    std::vector<types::global_dof_index>
    distribute_shares(const std::vector<types::global_dof_index> &dofs,
                      const Constraints                          &constraints,
                      std::vector<Share>                         &shares) const;
    bool
    find_places(const LA::SparseMatrix                     &matrix,
                const std::vector<types::global_dof_index> &dofs,
                Target                                     &target);

    std::vector<Target>       targets;
    std::vector<unsigned int> places; // by target, row and run
  };
} // namespace Amontons

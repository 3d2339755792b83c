// Adds cell matrices to a matrix whose pattern stays, without looking for the places of their entries.
#pragma once

#include <amontons/algebra/condensed_system.h>

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

  // The pattern of a Newton iteration stays while its values change. Places of the entries among the values
  // of the matrix are found once, for cells without constraints of which this rank owns all rows: one for
  // each row and node, whose components follow one another.
  class DirectScatter
  {
  public:
    // Returns the cells that it cannot serve.
    std::vector<unsigned int>
    setup(const LA::SparseMatrix &matrix,
          const CellMatrices     &cells,
          const Constraints      &constraints,
          const unsigned int      n_components);

    void
    add(const CellMatrices &cells, LA::SparseMatrix &matrix) const;

  private:
    bool
    find_places(const LA::SparseMatrix                     &matrix,
                const std::vector<types::global_dof_index> &dofs,
                std::vector<unsigned int>                  &found) const;

    unsigned int              n_components = 1;
    std::vector<unsigned int> served;
    std::vector<unsigned int> places; // by cell served, row and node
  };
} // namespace Amontons

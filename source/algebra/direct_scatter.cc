#include <amontons/algebra/direct_scatter.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    // Compressed rows of this rank; columns by their local numbers.
    struct Rows
    {
      int    *begin   = nullptr;
      int    *columns = nullptr;
      double *values  = nullptr;

      explicit Rows(const LA::SparseMatrix &matrix)
      {
        auto &storage = const_cast<Epetra_CrsMatrix &>(matrix.trilinos_matrix());
        if (storage.ExtractCrsDataPointers(begin, columns, values) != 0)
          begin = nullptr; // not compressed
      }
    };
  } // namespace

  std::vector<unsigned int>
  DirectScatter::setup(const LA::SparseMatrix          &matrix,
                       const CellMatrices              &cells,
                       const std::vector<unsigned int> &among,
                       const Constraints               &constraints,
                       const unsigned int               components)
  {
    n_components = components;
    served.clear();
    places.clear();
    std::vector<unsigned int> others, found;
    for (const unsigned int c : among)
      {
        const auto &dofs = cells.dofs(c);
        if (std::none_of(
                dofs.begin(), dofs.end(), [&](const auto i) { return constraints.is_constrained(i); }) &&
            find_places(matrix, dofs, found))
          {
            served.push_back(c);
            places.insert(places.end(), found.begin(), found.end());
          }
        else
          others.push_back(c);
      }
    places.shrink_to_fit();
    return others;
  }

  bool
  DirectScatter::find_places(const LA::SparseMatrix                     &matrix,
                             const std::vector<types::global_dof_index> &dofs,
                             std::vector<unsigned int>                  &found) const
  {
    const Rows  rows(matrix);
    const auto &storage = matrix.trilinos_matrix();
    if (rows.begin == nullptr)
      return false;
    std::vector<int> columns;
    for (unsigned int i = 0; i < dofs.size(); ++i)
      {
        columns.push_back(storage.LCID(int(dofs[i])));
        if (i % n_components != 0 && columns[i] != columns[i - 1] + 1)
          return false;
      }
    found.clear();
    for (const auto dof : dofs)
      {
        const int row = storage.LRID(int(dof));
        if (row < 0)
          return false;
        const int *begin = rows.columns + rows.begin[row], *end = rows.columns + rows.begin[row + 1];
        for (unsigned int j = 0; j < dofs.size(); j += n_components)
          {
            const int *place = std::lower_bound(begin, end, columns[j]);
            for (unsigned int d = 0; d < n_components; ++d)
              if (place + d >= end || place[d] != columns[j + d])
                return false;
            found.push_back(place - rows.columns);
          }
      }
    return true;
  }

  void
  DirectScatter::add(const CellMatrices &cells, LA::SparseMatrix &matrix) const
  {
    const Rows          rows(matrix);
    const unsigned int *place = places.data();
    for (const unsigned int c : served)
      {
        const FullMatrix<double> cell = cells.matrix(c);
        for (unsigned int i = 0; i < cell.m(); ++i)
          for (unsigned int j = 0; j < cell.n(); j += n_components, ++place)
            for (unsigned int d = 0; d < n_components; ++d)
              rows.values[*place + d] += cell(i, j + d);
      }
  }
} // namespace Amontons

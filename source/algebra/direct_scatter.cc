#include <amontons/algebra/direct_scatter.h>

#include <algorithm>
#include <tuple>

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
    // Columns of the matrix, sorted by their local numbers, and what goes to each from the columns of a
    // block.
    struct Columns
    {
      struct Part
      {
        int                     local;
        types::global_dof_index dof;
        unsigned int            from;
        double                  weight;
      };
      std::vector<Part>         parts;
      std::vector<unsigned int> begin; // of each column among the parts, and the end

      Columns(const std::vector<types::global_dof_index> &dofs,
              const Constraints                          &constraints,
              const LA::SparseMatrix                     &matrix)
      {
        const auto append =
            [&](const types::global_dof_index dof, const unsigned int j, const double weight) {
              parts.push_back({matrix.trilinos_matrix().LCID(int(dof)), dof, j, weight});
            };
        for (unsigned int j = 0; j < dofs.size(); ++j)
          if (!constraints.is_constrained(dofs[j]))
            append(dofs[j], j, 1);
          else
            for (const auto &[other, weight] : *constraints.get_constraint_entries(dofs[j]))
              append(other, j, weight);
        std::sort(parts.begin(), parts.end(), [](const Part &a, const Part &b) {
          return std::tie(a.local, a.dof) < std::tie(b.local, b.dof);
        });
        for (unsigned int k = 0; k < parts.size(); ++k)
          if (k == 0 || parts[k].dof != parts[k - 1].dof)
            begin.push_back(k);
        begin.push_back(parts.size());
      }

      unsigned int
      size() const
      {
        return begin.size() - 1;
      }

      const Part &
      first(const unsigned int column) const
      {
        return parts[begin[column]];
      }

      // Values for one row of the matrix from those of a row of the block.
      void
      combine(const std::vector<double> &row, std::vector<double> &values) const
      {
        values.assign(size(), 0.);
        for (unsigned int column = 0; column < size(); ++column)
          for (unsigned int k = begin[column]; k < begin[column + 1]; ++k)
            values[column] += parts[k].weight * row[parts[k].from];
      }
    };

    // What goes to a row of the matrix from one of the block.
    struct RowPart
    {
      types::global_dof_index row;
      unsigned int            from;
      double                  weight;
    };

    // Sorted by rows of the matrix; rows of zeros are left out.
    std::vector<RowPart>
    row_parts(const FullMatrix<double>                   &block,
              const std::vector<types::global_dof_index> &dofs,
              const Constraints                          &constraints)
    {
      std::vector<RowPart> parts;
      for (unsigned int i = 0; i < dofs.size(); ++i)
        if (const double *row = &block(i, 0);
            std::any_of(row, row + block.n(), [](const double value) { return value != 0; }))
          {
            if (!constraints.is_constrained(dofs[i]))
              parts.push_back({dofs[i], i, 1});
            else
              for (const auto &[other, weight] : *constraints.get_constraint_entries(dofs[i]))
                parts.push_back({other, i, weight});
          }
      std::sort(parts.begin(), parts.end(), [](const RowPart &a, const RowPart &b) { return a.row < b.row; });
      return parts;
    }

    // The first of the sorted numbers in [begin, end) that is not below a value. Rows at the contact have
    // hundreds of entries, and the next one is mostly close.
    const int *
    find_from(const int *begin, const int *end, const int value)
    {
      std::ptrdiff_t step = 1;
      while (step < end - begin && begin[step] < value)
        {
          begin += step;
          step *= 2;
        }
      return std::lower_bound(begin, begin + std::min(step + 1, end - begin), value);
    }

    void
    add_to_row(const LA::SparseMatrix    &matrix,
               const int                  row,
               const Columns             &columns,
               const std::vector<double> &values)
    {
      int     n;
      double *entries;
      int    *places;
      matrix.trilinos_matrix().ExtractMyRowView(row, n, entries, places);
      const int *place = places, *end = places + n;
      for (unsigned int j = 0; j < columns.size(); ++j)
        {
          const int local = columns.first(j).local;
          place           = find_from(place, end, local);
          if (place != end && *place == local)
            entries[place - places] += values[j];
          else
            AssertThrow(values[j] == 0, ExcMessage("an entry outside of the sparsity pattern"));
        }
    }
  } // namespace

  void
  add_condensed(const FullMatrix<double>                   &block,
                const std::vector<types::global_dof_index> &rows,
                const std::vector<types::global_dof_index> &columns,
                const Constraints                          &of_rows,
                const Constraints                          &of_columns,
                LA::SparseMatrix                           &matrix)
  {
    if (columns.empty())
      return;
    const Columns                        sorted(columns, of_columns, matrix);
    std::vector<double>                  row(columns.size()), values, sent_values;
    std::vector<types::global_dof_index> sent_columns;
    const auto                           parts = row_parts(block, rows, of_rows);
    for (auto part = parts.begin(); part != parts.end();)
      {
        const auto target = part->row;
        std::fill(row.begin(), row.end(), 0.);
        for (; part != parts.end() && part->row == target; ++part)
          for (unsigned int j = 0; j < row.size(); ++j)
            row[j] += part->weight * block(part->from, j);
        sorted.combine(row, values);
        if (const int here = matrix.trilinos_matrix().LRID(int(target)); here >= 0)
          add_to_row(matrix, here, sorted, values);
        else // sent to its owner
          {
            sent_columns.clear();
            sent_values.clear();
            for (unsigned int j = 0; j < sorted.size(); ++j)
              if (values[j] != 0)
                {
                  sent_columns.push_back(sorted.first(j).dof);
                  sent_values.push_back(values[j]);
                }
            matrix.add(target, sent_columns, sent_values);
          }
      }
  }

  std::vector<unsigned int>
  DirectScatter::setup(const LA::SparseMatrix &matrix,
                       const CellMatrices     &cells,
                       const Constraints      &constraints,
                       const unsigned int      components)
  {
    n_components = components;
    served.clear();
    places.clear();
    std::vector<unsigned int> others, found;
    for (unsigned int c = 0; c < cells.n; ++c)
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

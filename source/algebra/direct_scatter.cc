#include <amontons/algebra/direct_scatter.h>
#include <amontons/algebra/node_pattern.h>

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
        for (unsigned int j = 0; j < dofs.size(); ++j)
          for_each_entry(constraints, dofs[j], [&](const auto dof, const double weight) {
            parts.push_back({matrix.trilinos_matrix().LCID(int(dof)), dof, j, weight});
          });
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
          for_each_entry(constraints, dofs[i], [&](const auto dof, const double weight) {
            parts.push_back({dof, i, weight});
          });
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
                       const Constraints      &constraints)
  {
    targets.clear();
    places.clear();
    std::vector<unsigned int> others;
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        Target target;
        target.cell = c;
        if (const auto dofs = distribute_shares(cells.dofs(c), constraints, target.shares);
            find_places(matrix, dofs, target))
          targets.push_back(target);
        else
          others.push_back(c);
      }
    places.shrink_to_fit();
    return others;
  }

  // Returns the DoFs that those of the cell stand for.
  std::vector<types::global_dof_index>
  DirectScatter::distribute_shares(const std::vector<types::global_dof_index> &dofs,
                                   const Constraints                          &constraints,
                                   std::vector<Share>                         &shares) const
  {
    if (std::none_of(dofs.begin(), dofs.end(), [&](const auto i) { return constraints.is_constrained(i); }))
      return dofs;
    std::vector<types::global_dof_index> targets;
    for (const auto dof : dofs)
      for_each_entry(constraints, dof, [&](const auto other, double) { targets.push_back(other); });
    sort_once(targets);
    for (unsigned int i = 0; i < dofs.size(); ++i)
      for_each_entry(constraints, dofs[i], [&](const auto other, const double weight) {
        const auto place = std::lower_bound(targets.begin(), targets.end(), other);
        shares.push_back({i, static_cast<unsigned int>(place - targets.begin()), weight});
      });
    return targets;
  }

  bool
  DirectScatter::find_places(const LA::SparseMatrix                     &matrix,
                             const std::vector<types::global_dof_index> &dofs,
                             Target                                     &target)
  {
    const Rows  rows(matrix);
    const auto &storage = matrix.trilinos_matrix();
    if (rows.begin == nullptr)
      return false;
    std::vector<int> first_columns;
    for (unsigned int j = 0; j < dofs.size(); ++j)
      if (const int column = storage.LCID(int(dofs[j]));
          j > 0 && column == first_columns.back() + int(target.runs.back()))
        ++target.runs.back();
      else
        {
          first_columns.push_back(column);
          target.runs.push_back(1);
        }
    target.n_rows              = dofs.size();
    const std::size_t n_places = places.size();
    for (const auto dof : dofs)
      {
        const int row = storage.LRID(int(dof));
        for (unsigned int r = 0; row >= 0 && r < target.runs.size(); ++r)
          {
            const int *begin = rows.columns + rows.begin[row], *end = rows.columns + rows.begin[row + 1];
            const int *place  = std::lower_bound(begin, end, first_columns[r]);
            const int  length = target.runs[r];
            if (end - place < length || place[0] != first_columns[r] ||
                place[length - 1] != first_columns[r] + length - 1)
              break;
            places.push_back(place - rows.columns);
          }
      }
    if (places.size() == n_places + dofs.size() * target.runs.size())
      return true;
    places.resize(n_places);
    return false;
  }

  void
  DirectScatter::add(const CellMatrices &cells, LA::SparseMatrix &matrix) const
  {
    const Rows          rows(matrix);
    const unsigned int *place = places.data();
    FullMatrix<double>  half, condensed;
    for (const auto &target : targets)
      {
        const FullMatrix<double>  cell  = cells.matrix(target.cell);
        const FullMatrix<double> *block = &cell;
        if (!target.shares.empty())
          {
            half.reinit(target.n_rows, cell.n());
            condensed.reinit(target.n_rows, target.n_rows);
            for (const auto &[from, to, weight] : target.shares)
              for (unsigned int j = 0; j < cell.n(); ++j)
                half(to, j) += weight * cell(from, j);
            for (unsigned int i = 0; i < target.n_rows; ++i)
              for (const auto &[from, to, weight] : target.shares)
                condensed(i, to) += weight * half(i, from);
            block = &condensed;
          }
        for (unsigned int i = 0; i < target.n_rows; ++i)
          {
            const double *value = &(*block)(i, 0);
            for (const unsigned int n : target.runs)
              {
                double *entry = rows.values + *place++;
                for (unsigned int d = 0; d < n; ++d)
                  entry[d] += *value++;
              }
          }
      }
  }
} // namespace Amontons

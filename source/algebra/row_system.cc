#include <amontons/algebra/row_system.h>

#include <boost/functional/hash.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <Epetra_Vector.h>

namespace Amontons
{
  namespace
  {
    // Adds sorted numbers to sorted ones; whether any is new.
    bool
    insert(Nodes &known, const Nodes &more)
    {
      if (std::includes(known.begin(), known.end(), more.begin(), more.end()))
        return false;
      Nodes all;
      std::set_union(known.begin(), known.end(), more.begin(), more.end(), std::back_inserter(all));
      known.swap(all);
      return true;
    }

    // Of matrices with the same pattern.
    void
    copy_values(const LA::SparseMatrix &from, LA::SparseMatrix &to)
    {
      for (int row = 0; row < from.trilinos_matrix().NumMyRows(); ++row)
        {
          double *source, *target;
          int     n;
          from.trilinos_matrix().ExtractMyRowView(row, n, source);
          to.trilinos_matrix().ExtractMyRowView(row, n, target);
          std::copy(source, source + n, target);
        }
    }

    // Leaves zeros in the row of an owned DoF; columns: local.
    void
    take_row(const LA::SparseMatrix       &matrix,
             const types::global_dof_index dof,
             std::vector<int>             &columns,
             std::vector<double>          &entries)
    {
      double *values;
      int     n, *places;
      matrix.trilinos_matrix().ExtractMyRowView(matrix.trilinos_matrix().LRID(int(dof)), n, values, places);
      columns.clear();
      entries.clear();
      for (int k = 0; k < n; ++k)
        if (values[k] != 0)
          {
            columns.push_back(places[k]);
            entries.push_back(std::exchange(values[k], 0.));
          }
    }

    // The entries of a row of this rank, and where a local column is among them.
    class RowView
    {
    public:
      explicit RowView(const LA::SparseMatrix &matrix)
          : storage(matrix.trilinos_matrix()), places(storage.NumMyCols(), none)
      {
      }

      void
      look_at(const int row)
      {
        leave();
        storage.ExtractMyRowView(row, n, values, columns);
        for (int k = 0; k < n; ++k)
          places[columns[k]] = k;
      }

      void
      add(const int column, const double value)
      {
        AssertThrow(column >= 0 && places[column] != none,
                    ExcMessage("an entry outside of the sparsity pattern"));
        values[places[column]] += value;
      }

    private:
      void
      leave()
      {
        for (int k = 0; k < n; ++k)
          places[columns[k]] = none;
      }

      static constexpr int    none = -1;
      const Epetra_CrsMatrix &storage;
      std::vector<int>        places;
      int                     n = 0, *columns = nullptr;
      double                 *values = nullptr;
    };

    // A row that another rank needs, by global columns, and how much of it goes to which of its DoFs.
    struct SentRow
    {
      std::vector<int>                                        columns;
      std::vector<double>                                     entries;
      std::vector<std::pair<types::global_dof_index, double>> shares;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &columns &entries &shares;
      }
    };

    double
    largest_diagonal(const LA::SparseMatrix &matrix)
    {
      Epetra_Vector diagonal(matrix.trilinos_matrix().RowMap());
      matrix.trilinos_matrix().ExtractDiagonalCopy(diagonal);
      double largest;
      diagonal.NormInf(&largest);
      return largest > 0 ? largest : 1;
    }
  } // namespace

  RowSystem::RowSystem(const IndexSet    &locally_owned,
                       const IndexSet    &relevant,
                       const unsigned int n_components,
                       MPI_Comm           communicator)
      : locally_owned(locally_owned), relevant(relevant), n_components(n_components),
        communicator(communicator)
  {
  }

  // New ones are kept, so that surfaces that slide to and fro need no new pattern. All that a DoF has ever
  // stood for counts: a block that was linked once is linked whatever the constraints are now.
  bool
  RowSystem::link(const Constraints              &supports,
                  const ContactConstraints       &test,
                  const std::vector<LocalMatrix> &further,
                  const std::vector<ContactRow>  &rows)
  {
    bool is_new = false;
    for (const auto &pivot : test.pivots())
      if (pivot)
        {
          is_new |= insert(replaced[*pivot], nodes_of({*pivot}, test.test()));
          is_new |= insert(replaced[*pivot], nodes_of({*pivot}, test.trial()));
        }
    if (is_new)
      linked_blocks.clear();
    for (const auto &matrix : further)
      link_block(matrix.rows, matrix.columns, supports, is_new);
    std::vector<types::global_dof_index> columns;
    for (const auto &row : rows)
      {
        columns.clear();
        for (const auto &entry : row.equation.coefficients)
          columns.push_back(entry.first);
        link_block({row.row}, columns, supports, is_new);
      }
    pattern_is_old = pattern_is_old || Utilities::MPI::max(int(is_new), communicator) > 0;
    return pattern_is_old;
  }

  Nodes
  RowSystem::nodes_of(const std::vector<types::global_dof_index> &dofs, const Constraints &constraints) const
  {
    Nodes nodes;
    for (const auto dof : dofs)
      for_each_entry(
          constraints, dof, [&](const auto other, double) { nodes.push_back(other / n_components); });
    sort_once(nodes);
    return nodes;
  }

  // With what test functions of closed nodes are replaced by.
  bool
  RowSystem::gather_nodes(const std::vector<types::global_dof_index> &dofs,
                          const Constraints                          &supports,
                          Nodes                                      &nodes) const
  {
    bool any = false;
    nodes.clear();
    for (const auto dof : dofs)
      for_each_entry(supports, dof, [&](const auto other, double) {
        nodes.push_back(other / n_components);
        if (const auto links = replaced.find(other); links != replaced.end())
          {
            any = true;
            nodes.insert(nodes.end(), links->second.begin(), links->second.end());
          }
      });
    sort_once(nodes);
    return any;
  }

  void
  RowSystem::link_block(const std::vector<types::global_dof_index> &rows,
                        const std::vector<types::global_dof_index> &columns,
                        const Constraints                          &supports,
                        bool                                       &is_new)
  {
    if (!linked_blocks
             .insert({boost::hash_range(rows.begin(), rows.end()),
                      boost::hash_range(columns.begin(), columns.end())})
             .second)
      return;
    Nodes of_rows, of_columns;
    gather_nodes(rows, supports, of_rows);
    gather_nodes(columns, supports, of_columns);
    for (const auto row : of_rows)
      is_new |= insert(coupled[row], of_columns);
  }

  void
  RowSystem::make_pattern(const CellMatrices &cells,
                          const Constraints  &supports,
                          const bool          with_eliminated_form)
  {
    NodePattern pattern(locally_owned, relevant, n_components);
    Nodes       nodes;
    surface.clear();
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        if (gather_nodes(cells.dofs(c), supports, nodes))
          surface.push_back(c);
        pattern.add(nodes);
      }
    for (const auto &[row, columns] : coupled)
      pattern.add(row, columns);
    pattern.make_matrix(supports, communicator, system);
    if (with_eliminated_form)
      eliminated.reinit(system);
    constrained    = scatter.setup(system, cells, supports);
    pattern_is_old = false;
  }

  void
  RowSystem::assemble(const CellMatrices             &cells,
                      const Constraints              &supports,
                      const ContactConstraints       &test,
                      const std::vector<LocalMatrix> &further,
                      const LA::Vector               *diagonal,
                      const std::vector<ContactRow>  &rows,
                      const bool                      with_eliminated_form)
  {
    constraints = &test;
    if (pattern_is_old)
      make_pattern(cells, supports, with_eliminated_form);

    const auto owners = owners_of_shares(test);
    system            = 0;
    scatter.add(cells, system);
    for (const unsigned int c : constrained)
      add_condensed(cells.matrix(c), cells.dofs(c), cells.dofs(c), supports, supports, system);
    add_diagonal(diagonal, supports, system);
    system.compress(VectorOperation::add);
    if (with_eliminated_form) // what matters of it
      {
        copy_values(system, eliminated);
        condense_rows(test, owners, eliminated);
        condense_columns(test, eliminated);
      }

    for (const auto &part : further)
      add_condensed(part.matrix, part.rows, part.columns, supports, supports, system);
    system.compress(VectorOperation::add);
    condense_rows(test, owners, system);
    diagonal_scale = largest_diagonal(system);
    measure_stiffness(cells, supports);
    write_rows(rows, supports);
    fill_empty_rows(system, supports);
    if (with_eliminated_form)
      fill_empty_rows(eliminated, test.trial());
  }

  void
  RowSystem::add_diagonal(const LA::Vector  *diagonal,
                          const Constraints &supports,
                          LA::SparseMatrix  &matrix) const
  {
    FullMatrix<double> one(1, 1);
    for (const auto dof : locally_owned)
      if (diagonal != nullptr && (*diagonal)(dof) != 0)
        {
          one(0, 0) = (*diagonal)(dof);
          add_condensed(one, {dof}, {dof}, supports, supports, matrix);
        }
  }

  RowSystem::OwnersOfShares
  RowSystem::owners_of_shares(const ContactConstraints &test) const
  {
    std::vector<types::global_dof_index> dofs;
    for (const auto &pivot : test.pivots())
      if (pivot && locally_owned.is_element(*pivot))
        for (const auto &entry : *test.test().get_constraint_entries(*pivot))
          if (!locally_owned.is_element(entry.first))
            dofs.push_back(entry.first);
    sort_once(dofs);
    OwnersOfShares result{IndexSet(locally_owned.size()), {}};
    result.dofs.add_indices(dofs.begin(), dofs.end());
    result.ranks = Utilities::MPI::compute_index_owner(locally_owned, result.dofs, communicator);
    return result;
  }

  // Once all is added, C_test^T times it: what was added to a row once goes to many others. Other ranks get
  // the row once, with the shares of their DoFs.
  void
  RowSystem::condense_rows(const ContactConstraints &test,
                           const OwnersOfShares     &owners,
                           LA::SparseMatrix         &matrix) const
  {
    const auto                                  &storage = matrix.trilinos_matrix();
    RowView                                      view(matrix);
    std::vector<int>                             columns;
    std::vector<double>                          entries;
    std::map<unsigned int, std::vector<SentRow>> sent;
    const auto                                   add = [&](const int row, const double weight) {
      view.look_at(row);
      for (unsigned int k = 0; k < columns.size(); ++k)
        view.add(columns[k], weight * entries[k]);
    };
    for (const auto &pivot : test.pivots())
      if (pivot && locally_owned.is_element(*pivot))
        {
          take_row(matrix, *pivot, columns, entries);
          std::map<unsigned int, std::vector<std::pair<types::global_dof_index, double>>> shares;
          for (const auto &[dof, weight] : *test.test().get_constraint_entries(*pivot))
            if (const int row = storage.LRID(int(dof)); row >= 0)
              add(row, weight);
            else
              shares[owners.ranks[owners.dofs.index_within_set(dof)]].emplace_back(dof, weight);
          for (auto &[rank, of_rank] : shares)
            {
              sent[rank].push_back({{}, entries, std::move(of_rank)});
              for (const int column : columns)
                sent[rank].back().columns.push_back(storage.GCID(column));
            }
        }
    for (const auto &[rank, received] : Utilities::MPI::some_to_some(communicator, sent))
      for (const SentRow &from : received)
        {
          columns.clear();
          for (const int column : from.columns)
            columns.push_back(storage.LCID(column));
          entries = from.entries;
          for (const auto &[dof, weight] : from.shares)
            add(storage.LRID(int(dof)), weight);
        }
  }

  // Times C_trial: what a row has in a pivot's column goes to the columns that the pivot stands for.
  void
  RowSystem::condense_columns(const ContactConstraints &test, LA::SparseMatrix &matrix) const
  {
    const auto &storage = matrix.trilinos_matrix();
    using Shares        = std::vector<std::pair<int, double>>; // local columns
    std::vector<Shares>                      shares;
    std::vector<std::optional<unsigned int>> shares_of(storage.NumMyCols());
    for (const auto &pivot : test.pivots())
      if (const int column = pivot ? storage.LCID(int(*pivot)) : -1; column >= 0)
        {
          shares_of[column] = shares.size();
          shares.emplace_back();
          for (const auto &[dof, weight] : *test.trial().get_constraint_entries(*pivot))
            shares.back().emplace_back(storage.LCID(int(dof)), weight);
        }
    RowView view(matrix);
    for (int row = 0; row < storage.NumMyRows(); ++row)
      {
        double *values;
        int     n, *columns;
        storage.ExtractMyRowView(row, n, values, columns);
        const auto is_condensed = [&](const int k) { return values[k] != 0 && shares_of[columns[k]]; };
        int        k            = 0;
        while (k < n && !is_condensed(k))
          ++k;
        if (k < n)
          view.look_at(row);
        for (; k < n; ++k)
          if (is_condensed(k))
            {
              const double value = std::exchange(values[k], 0.);
              for (const auto &[column, weight] : shares[*shares_of[columns[k]]])
                view.add(column, value * weight);
            }
      }
  }

  // Written rows get the size of the stiffness there, so that their residuals compare with forces; diagonals
  // of rows that have no equation, so that multigrid takes them as what is beside them.
  void
  RowSystem::measure_stiffness(const CellMatrices &cells, const Constraints &supports)
  {
    stiffness.reinit(locally_owned, relevant, communicator, true);
    std::vector<bool> on_surface(cells.n, false);
    for (const unsigned int c : surface)
      on_surface[c] = true;
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        const auto &dofs   = cells.dofs(c);
        const auto  counts = [&](const auto dof) { return on_surface[c] || supports.is_constrained(dof); };
        if (std::none_of(dofs.begin(), dofs.end(), counts))
          continue;
        const auto matrix = cells.matrix(c);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (counts(dofs[i]))
            stiffness(dofs[i]) += std::abs(matrix(i, i));
      }
    stiffness.compress(VectorOperation::add);
  }

  double
  RowSystem::row_scale(const types::global_dof_index row) const
  {
    const double scale = stiffness(row);
    return scale > 0 ? scale : diagonal_scale;
  }

  void
  RowSystem::write_rows(const std::vector<ContactRow> &rows, const Constraints &supports)
  {
    written.clear();
    for (const auto &row : rows)
      if (locally_owned.is_element(row.row))
        {
          const double scale = row_scale(row.row);
          written.push_back(row.row);
          for (const auto &[dof, coefficient] : row.equation.coefficients)
            for_each_entry(supports, dof, [&, c = coefficient](const auto column, const double weight) {
              system.add(row.row, column, scale * c * weight);
            });
        }
    system.compress(VectorOperation::add);
  }

  void
  RowSystem::fill_empty_rows(LA::SparseMatrix &matrix, const Constraints &owners) const
  {
    for (const auto &line : owners.get_lines())
      if (locally_owned.is_element(line.index) && matrix.diag_element(line.index) == 0)
        matrix.set(line.index, line.index, row_scale(line.index));
    matrix.compress(VectorOperation::insert);
  }

  EliminatedForm
  RowSystem::eliminated_form() const
  {
    EliminatedForm form{&eliminated, &constraints->trial(), {}};
    for (const auto dof : written)
      form.written.emplace_back(dof, system.diag_element(dof));
    return form;
  }
} // namespace Amontons

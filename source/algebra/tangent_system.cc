#include <amontons/algebra/tangent_system.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

namespace Amontons
{
  namespace
  {
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

    // All DoFs that the given ones stand for, each once.
    std::vector<types::global_dof_index>
    resolved(const std::vector<types::global_dof_index> &dofs, const Constraints &constraints)
    {
      std::vector<types::global_dof_index> result;
      for (const auto dof : dofs)
        for_each_entry(constraints, dof, [&](const auto other, double) { result.push_back(other); });
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(), result.end()), result.end());
      return result;
    }

    // Adds sorted DoFs to sorted ones; whether any is new.
    bool
    insert(std::vector<types::global_dof_index> &known, const std::vector<types::global_dof_index> &more)
    {
      if (std::includes(known.begin(), known.end(), more.begin(), more.end()))
        return false;
      std::vector<types::global_dof_index> all;
      std::set_union(known.begin(), known.end(), more.begin(), more.end(), std::back_inserter(all));
      known.swap(all);
      return true;
    }
  } // namespace

  TangentSystem::TangentSystem(const IndexSet &locally_owned, const IndexSet &relevant, MPI_Comm communicator)
      : locally_owned(locally_owned), relevant(relevant), communicator(communicator)
  {
  }

  // True if there are new ones. They are kept, so that surfaces that slide to and fro need no new pattern.
  bool
  TangentSystem::add_links(const Constraints                    &supports,
                           const ContactConstraints             &test,
                           const std::vector<RectangularMatrix> &further,
                           const std::vector<WrittenRow>        &rows)
  {
    bool is_new = false;
    for (const auto &pivot : test.pivots())
      if (pivot)
        {
          is_new |= insert(replaced[*pivot], resolved({*pivot}, test.test()));
          is_new |= insert(replaced[*pivot], resolved({*pivot}, test.trial()));
        }
    for (const auto &matrix : further)
      {
        auto columns = resolved(matrix.columns, supports);
        insert(columns, resolved(matrix.columns, test.trial()));
        for (const auto row : resolved(matrix.rows, test.test()))
          is_new |= insert(coupled[row], columns);
      }
    for (const auto &row : rows)
      {
        std::vector<types::global_dof_index> dofs;
        for (const auto &entry : row.equation.coefficients)
          dofs.push_back(entry.first);
        is_new |= insert(coupled[row.row], resolved(dofs, supports));
      }
    return Utilities::MPI::max(int(is_new), communicator) > 0;
  }

  void
  TangentSystem::make_pattern(const CellMatrices &cells,
                              const Constraints  &supports,
                              const bool          with_eliminated_form)
  {
    DynamicSparsityPattern               dsp(relevant);
    std::vector<types::global_dof_index> dofs;
    std::set<types::global_dof_index>    more;
    is_surface.assign(cells.n, false);
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        dofs = cells.dofs(c);
        more.clear();
        for (const auto dof : cells.dofs(c))
          for_each_entry(supports, dof, [&](const auto i, double) {
            if (const auto links = replaced.find(i); links != replaced.end())
              {
                is_surface[c] = true;
                more.insert(links->second.begin(), links->second.end());
              }
          });
        for (const auto dof : dofs)
          more.erase(dof);
        dofs.insert(dofs.end(), more.begin(), more.end());
        supports.add_entries_local_to_global(dofs, dsp, true);
      }
    for (const auto &[row, columns] : coupled)
      dsp.add_entries(row, columns.begin(), columns.end(), true);
    for (const auto dof : locally_owned)
      dsp.add(dof, dof);
    SparsityTools::distribute_sparsity_pattern(dsp, locally_owned, communicator, relevant);
    system.reinit(locally_owned, locally_owned, dsp, communicator);
    if (with_eliminated_form)
      eliminated.reinit(locally_owned, locally_owned, dsp, communicator);
    has_pattern = true;
  }

  void
  TangentSystem::assemble(const CellMatrices                   &cells,
                          const Constraints                    &supports,
                          const ContactConstraints             &test,
                          const std::vector<RectangularMatrix> &further,
                          const LA::Vector                     *diagonal,
                          const std::vector<WrittenRow>        &rows,
                          const bool                            with_eliminated_form)
  {
    constraints = &test;
    if (add_links(supports, test, further, rows) || !has_pattern)
      make_pattern(cells, supports, with_eliminated_form);
    const Constraints &of_rows = test.test();
    double             largest = 0;
    const auto         fill    = [&](LA::SparseMatrix &matrix, const Constraints &of_columns) {
      matrix = 0;
      for (unsigned int c = 0; c < cells.n; ++c)
        {
          const FullMatrix<double> cell = cells.matrix(c);
          for (unsigned int i = 0; i < cell.m(); ++i)
            largest = std::max(largest, std::abs(cell(i, i)));
          if (is_surface[c])
            of_rows.distribute_local_to_global(cell, cells.dofs(c), of_columns, cells.dofs(c), matrix);
          else
            supports.distribute_local_to_global(cell, cells.dofs(c), matrix);
        }
      for (const auto &part : further)
        of_rows.distribute_local_to_global(part.matrix, part.rows, of_columns, part.columns, matrix);
      FullMatrix<double> one(1, 1);
      for (const auto dof : locally_owned)
        if (diagonal != nullptr && (*diagonal)(dof) != 0)
          {
            one(0, 0) = (*diagonal)(dof);
            of_rows.distribute_local_to_global(one, {dof}, of_columns, {dof}, matrix);
          }
    };
    const auto fill_empty_rows = [&](LA::SparseMatrix &matrix, const Constraints &owners) {
      for (const auto dof : locally_owned)
        if (matrix.diag_element(dof) == 0 && owners.is_constrained(dof))
          matrix.set(dof, dof, diagonal_scale);
      matrix.compress(VectorOperation::insert);
    };
    fill(system, supports);
    diagonal_scale = Utilities::MPI::max(largest, communicator);
    for (const auto &row : rows)
      if (locally_owned.is_element(row.row))
        for (const auto &[dof, coefficient] : row.equation.coefficients)
          for_each_entry(supports, dof, [&, c = coefficient](const auto column, const double weight) {
            system.add(row.row, column, diagonal_scale * c * weight);
          });
    system.compress(VectorOperation::add);
    fill_empty_rows(system, supports);
    written.clear();
    for (const auto &row : rows)
      if (locally_owned.is_element(row.row))
        written.push_back(row.row);
    if (with_eliminated_form)
      {
        fill(eliminated, test.trial());
        eliminated.compress(VectorOperation::add);
        fill_empty_rows(eliminated, test.trial());
      }
  }

  EliminatedForm
  TangentSystem::eliminated_form() const
  {
    EliminatedForm form{&eliminated, &constraints->trial(), {}};
    for (const auto dof : written)
      form.written.emplace_back(dof, system.diag_element(dof));
    return form;
  }
} // namespace Amontons

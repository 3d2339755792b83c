#include <amontons/algebra/direct_scatter.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <unordered_map>

namespace Amontons
{
  LA::Vector
  condense(const LA::Vector &raw, const Constraints &constraints, const LA::Vector &like)
  {
    LA::Vector result;
    result.reinit(like);
    for (const auto dof : raw.locally_owned_elements())
      {
        const double value = raw(dof);
        if (value == 0)
          continue;
        if (!constraints.is_constrained(dof))
          result(dof) += value;
        else
          for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
            result(other) += weight * value;
      }
    result.compress(VectorOperation::add);
    return result;
  }

  void
  zero_constrained(const Constraints &constraints, const IndexSet &owned, LA::Vector &vector)
  {
    for (const auto dof : owned)
      if (constraints.is_constrained(dof))
        vector(dof) = 0;
    vector.compress(VectorOperation::insert);
  }

  namespace
  {
    void
    distribute_lines(const Constraints &constraints,
                     const double       part_of_inhomogeneities,
                     LA::Vector        &owned,
                     LA::Vector        &readable)
    {
      readable            = owned;
      const IndexSet mine = owned.locally_owned_elements();
      for (const auto &line : constraints.get_lines())
        if (mine.is_element(line.index))
          {
            double value = part_of_inhomogeneities * line.inhomogeneity;
            for (const auto &[other, weight] : line.entries)
              value += weight * readable(other);
            owned(line.index) = value;
          }
      owned.compress(VectorOperation::insert);
      readable = owned;
    }
  } // namespace

  void
  distribute(const Constraints &constraints, LA::Vector &owned, LA::Vector &readable)
  {
    distribute_lines(constraints, 1, owned, readable);
  }

  void
  distribute_change(const Constraints &constraints, LA::Vector &owned, LA::Vector &readable)
  {
    distribute_lines(constraints, 0, owned, readable);
  }

  EliminatedSystem::EliminatedSystem(const IndexSet &locally_owned,
                                     const IndexSet &relevant,
                                     MPI_Comm        communicator)
      : locally_owned(locally_owned), relevant(relevant), communicator(communicator)
  {
  }

  void
  EliminatedSystem::setup(const CellMatrices                 &cells,
                          const Constraints                  &supports,
                          const std::vector<ContactEquation> &candidates,
                          const LA::Vector                   *diagonal)
  {
    // What a DoF that may be eliminated can be replaced by, through any chain of pairs; DoFs that never are
    // (masters, carriers) end a chain.
    std::unordered_map<types::global_dof_index, std::vector<const LinearEquation *>> eliminating;
    for (const auto &candidate : candidates)
      for (const auto *dofs : {&candidate.candidates, &candidate.others})
        for (const auto dof : *dofs)
          eliminating[dof].push_back(&candidate.equation);
    const auto add_replacements = [&](const types::global_dof_index      first,
                                      std::set<types::global_dof_index> &found) {
      std::vector<types::global_dof_index> open = {first};
      std::set<types::global_dof_index>    seen = {first};
      while (!open.empty())
        {
          const auto equations = eliminating.find(open.back());
          open.pop_back();
          if (equations == eliminating.end())
            continue;
          for (const LinearEquation *equation : equations->second)
            for (const auto &entry : equation->coefficients)
              if (seen.insert(entry.first).second)
                {
                  found.insert(entry.first);
                  open.push_back(entry.first);
                }
        }
    };

    std::vector<bool>                    is_surface(cells.n, false);
    DynamicSparsityPattern               dsp(relevant);
    std::vector<types::global_dof_index> dofs;
    std::set<types::global_dof_index>    more, reached;
    const auto                           add_reached = [&](const types::global_dof_index dof) {
      reached.insert(dof);
      if (supports.is_constrained(dof))
        for (const auto &entry : *supports.get_constraint_entries(dof))
          reached.insert(entry.first);
    };
    surface_cells.clear();
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        dofs = cells.dofs(c);
        more.clear();
        const auto consider = [&](const types::global_dof_index dof) {
          if (eliminating.count(dof) > 0)
            {
              is_surface[c] = true;
              add_replacements(dof, more);
            }
        };
        for (const auto dof : cells.dofs(c))
          {
            consider(dof);
            if (supports.is_constrained(dof))
              for (const auto &entry : *supports.get_constraint_entries(dof))
                consider(entry.first);
          }
        if (is_surface[c])
          {
            surface_cells.push_back(c);
            for (const auto dof : dofs)
              more.erase(dof);
            dofs.insert(dofs.end(), more.begin(), more.end());
            for (const auto dof : dofs)
              add_reached(dof);
          }
        supports.add_entries_local_to_global(dofs, dsp, false);
      }
    for (const auto dof : locally_owned)
      dsp.add(dof, dof);
    SparsityTools::distribute_sparsity_pattern(dsp, locally_owned, communicator, relevant);
    system.reinit(locally_owned, locally_owned, dsp, communicator);

    system = 0;
    assemble_bulk(cells, supports, is_surface);
    if (diagonal != nullptr)
      for (const auto dof : locally_owned)
        if ((*diagonal)(dof) != 0)
          add_reached(dof);
    save_bulk_rows(reached);
  }

  // And the stiffness of the DoFs that have, or may get, no equation of their own.
  void
  EliminatedSystem::assemble_bulk(const CellMatrices      &cells,
                                  const Constraints       &supports,
                                  const std::vector<bool> &is_surface)
  {
    stiffness.reinit(locally_owned, relevant, communicator, true);
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        const auto  matrix = cells.matrix(c);
        const auto &dofs   = cells.dofs(c);
        if (!is_surface[c])
          add_condensed(matrix, dofs, dofs, supports, supports, system);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (is_surface[c] || supports.is_constrained(dofs[i]))
            stiffness(dofs[i]) += matrix(i, i);
      }
    system.compress(VectorOperation::add);
    stiffness.compress(VectorOperation::add);
  }

  // Rows that assemble() adds to, from this rank or another one.
  void
  EliminatedSystem::save_bulk_rows(const std::set<types::global_dof_index> &reached)
  {
    LA::Vector marks;
    marks.reinit(locally_owned, relevant, communicator, true);
    for (const auto dof : reached)
      marks(dof) += 1;
    marks.compress(VectorOperation::add);
    saved_rows.clear();
    std::size_t n_values = 0;
    for (const auto dof : locally_owned)
      if (marks(dof) > 0)
        {
          saved_rows.push_back(system.trilinos_matrix().LRID(int(dof)));
          n_values += system.trilinos_matrix().NumMyEntries(saved_rows.back());
        }
    saved_values.clear();
    saved_values.reserve(n_values);
    for (const int i : saved_rows)
      {
        double *row;
        int     n;
        system.trilinos_matrix().ExtractMyRowView(i, n, row);
        saved_values.insert(saved_values.end(), row, row + n);
      }
  }

  void
  EliminatedSystem::restore_bulk_rows()
  {
    const double *saved = saved_values.data();
    for (const int i : saved_rows)
      {
        double *row;
        int     n;
        system.trilinos_matrix().ExtractMyRowView(i, n, row);
        std::copy(saved, saved + n, row);
        saved += n;
      }
  }

  void
  EliminatedSystem::assemble(const CellMatrices             &cells,
                             const ContactConstraints       &constraints,
                             const LA::Vector               *diagonal,
                             const std::vector<LocalMatrix> &further)
  {
    restore_bulk_rows();
    const auto add = [&](const FullMatrix<double> &matrix, const std::vector<types::global_dof_index> &dofs) {
      add_condensed(matrix, dofs, dofs, constraints.test(), constraints.trial(), system);
    };
    for (const unsigned int c : surface_cells)
      add(cells.matrix(c), cells.dofs(c));
    for (const LocalMatrix &part : further)
      add_condensed(part.matrix, part.rows, part.columns, constraints.test(), constraints.trial(), system);
    if (diagonal != nullptr)
      {
        FullMatrix<double> one(1, 1);
        for (const auto dof : locally_owned)
          if ((*diagonal)(dof) != 0)
            {
              one(0, 0) = (*diagonal)(dof);
              add(one, {dof});
            }
      }
    system.compress(VectorOperation::add);
    add_missing_diagonals(constraints.trial());
  }

  // Rows that are eliminated, carriers and rigid bodies. Multigrid needs up to ten times the steps where such
  // a diagonal is not of the size of its neighbours.
  void
  EliminatedSystem::add_missing_diagonals(const Constraints &constraints)
  {
    const double largest = stiffness.linfty_norm();
    for (const auto &line : constraints.get_lines())
      if (locally_owned.is_element(line.index) && system.diag_element(line.index) == 0)
        {
          const double own = stiffness(line.index);
          system.set(line.index, line.index, own > 0 ? own : largest > 0 ? largest : 1.);
        }
    system.compress(VectorOperation::insert);
  }
} // namespace Amontons

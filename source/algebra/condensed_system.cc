#include <amontons/algebra/condensed_system.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

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

  CondensedSystem::CondensedSystem(const IndexSet &locally_owned,
                                   const IndexSet &relevant,
                                   MPI_Comm        communicator)
      : locally_owned(locally_owned), relevant(relevant), communicator(communicator)
  {
  }

  void
  CondensedSystem::setup(const CellMatrices                 &cells,
                         const Constraints                  &supports,
                         const std::vector<ContactEquation> &candidates)
  {
    // What a DoF that may be eliminated can be replaced by, through any chain of pairs; DoFs that never are
    // (masters, carriers) end a chain.
    std::map<types::global_dof_index, std::vector<const LinearEquation *>> eliminating;
    for (const auto &candidate : candidates)
      for (const auto dof : candidate.candidates)
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
    surface_cells.clear();
    for (unsigned int c = 0; c < cells.n; ++c)
      {
        dofs = cells.dofs(c);
        std::set<types::global_dof_index> more;
        const auto                        consider = [&](const types::global_dof_index dof) {
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
          }
        supports.add_entries_local_to_global(dofs, dsp, true);
      }
    for (const auto dof : locally_owned)
      dsp.add(dof, dof);
    SparsityTools::distribute_sparsity_pattern(dsp, locally_owned, communicator, relevant);
    bulk.reinit(locally_owned, locally_owned, dsp, communicator);
    system.reinit(bulk);

    double largest = 0;
    for (unsigned int c = 0; c < cells.n; ++c)
      for (unsigned int i = 0; i < cells.matrix(c).m(); ++i)
        largest = std::max(largest, cells.matrix(c)(i, i));
    diagonal_scale = Utilities::MPI::max(largest, communicator);

    bulk = 0;
    for (unsigned int c = 0; c < cells.n; ++c)
      if (!is_surface[c])
        add_cell(cells, c, supports, bulk);
    bulk.compress(VectorOperation::add);
  }

  void
  CondensedSystem::add_cell(const CellMatrices &cells,
                            const unsigned int  c,
                            const Constraints  &constraints,
                            LA::SparseMatrix   &matrix) const
  {
    constraints.distribute_local_to_global(cells.matrix(c), cells.dofs(c), matrix);
  }

  void
  CondensedSystem::assemble(const CellMatrices &cells,
                            const Constraints  &constraints,
                            const LA::Vector   *diagonal)
  {
    system.copy_from(bulk);
    for (const unsigned int c : surface_cells)
      add_cell(cells, c, constraints, system);
    if (diagonal != nullptr)
      {
        FullMatrix<double> one(1, 1);
        for (const auto dof : locally_owned)
          if ((*diagonal)(dof) != 0)
            {
              one(0, 0) = (*diagonal)(dof);
              constraints.distribute_local_to_global(one, std::vector<types::global_dof_index>{dof}, system);
            }
      }
    system.compress(VectorOperation::add);
    add_missing_diagonals(constraints, diagonal_scale, system);
  }

  // Rows that no cell reaches: carriers and rigid bodies (their DoFs are constrained or moved through
  // others).
  void
  CondensedSystem::add_missing_diagonals(const Constraints &constraints,
                                         const double       scale,
                                         LA::SparseMatrix  &matrix) const
  {
    for (const auto dof : locally_owned)
      if (constraints.is_constrained(dof) && matrix.diag_element(dof) == 0)
        matrix.set(dof, dof, scale);
    matrix.compress(VectorOperation::insert);
  }
} // namespace Amontons

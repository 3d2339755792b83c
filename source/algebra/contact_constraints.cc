#include <amontons/algebra/contact_constraints.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

namespace Amontons
{
  ContactConstraints::ContactConstraints(const Constraints                  &supports,
                                         const std::vector<ContactEquation> &equations)
      : constraints(supports.get_local_lines()), contact_equations(equations), pivot_dofs(equations.size())
  {
    constraints.merge(supports, Constraints::no_conflicts_allowed, true);
    for (unsigned int i = 0; i < equations.size(); ++i)
      {
        substitute(contact_equations[i].equation, supports);
        LinearEquation equation = contact_equations[i].equation;
        // Everything that is eliminated already is replaced, so that no line refers to an older one: lines
        // never form a cycle, whatever the order of the pairs (close() would not end on one).
        substitute(equation, constraints);
        pivot_dofs[i] = choose_pivot(equation, constraints, contact_equations[i].candidates);
        if (pivot_dofs[i])
          eliminate(equation, *pivot_dofs[i], constraints);
      }
    constraints.close();
  }

  std::vector<double>
  ContactConstraints::recover_multipliers(const std::vector<double> &residual_at_pivots) const
  {
    std::vector<double>                             multipliers(pivot_dofs.size(), 0.);
    std::map<types::global_dof_index, unsigned int> row_of_dof;
    std::vector<unsigned int>                       equation_of_row;
    for (unsigned int i = 0; i < pivot_dofs.size(); ++i)
      if (pivot_dofs[i])
        {
          row_of_dof[*pivot_dofs[i]] = equation_of_row.size();
          equation_of_row.push_back(i);
        }
    const unsigned int n = equation_of_row.size();
    if (n == 0)
      return multipliers;

    // Nearly diagonal: off the diagonal stand mid-side nodes of quadratic faces, corners with two
    // multipliers, and slaves that are masters of another pair.
    std::vector<std::tuple<unsigned int, unsigned int, double>> entries;
    DynamicSparsityPattern                                      dsp(n, n);
    bool                                                        diagonal = true;
    for (unsigned int c = 0; c < n; ++c)
      for (const auto &[dof, coefficient] : contact_equations[equation_of_row[c]].equation.coefficients)
        if (const auto row = row_of_dof.find(dof); row != row_of_dof.end())
          {
            entries.emplace_back(row->second, c, coefficient);
            dsp.add(row->second, c);
            diagonal = diagonal && row->second == c;
          }
    Vector<double> mu(n);
    for (unsigned int c = 0; c < n; ++c)
      mu[c] = residual_at_pivots[equation_of_row[c]];
    if (diagonal)
      for (const auto &[row, column, value] : entries)
        mu[row] /= value;
    else
      {
        SparsityPattern pattern;
        pattern.copy_from(dsp);
        SparseMatrix<double> matrix(pattern);
        for (const auto &[row, column, value] : entries)
          matrix.add(row, column, value);
        SparseDirectUMFPACK solver;
        solver.initialize(matrix);
        solver.solve(mu);
      }
    for (unsigned int c = 0; c < n; ++c)
      multipliers[equation_of_row[c]] = -mu[c];
    return multipliers;
  }
} // namespace Amontons

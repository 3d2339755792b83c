#include <amontons/algebra/contact_constraints.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

namespace Amontons
{
  namespace
  {
    // Both coefficients of the eliminated DoF should be large: their product, by DoF.
    LinearEquation
    product(const LinearEquation &trial, const LinearEquation &test)
    {
      LinearEquation result;
      for (const auto &[dof, coefficient] : trial.coefficients)
        if (const auto other = test.coefficients.find(dof); other != test.coefficients.end())
          result.coefficients[dof] = coefficient * other->second;
      return result;
    }

    // Of the others, one that would not move far more than the jump.
    std::optional<types::global_dof_index>
    pivot_of(const ContactEquation &equation,
             const LinearEquation  &substituted,
             const Constraints     &present,
             const Constraints     &supports)
    {
      return others_hold(equation, supports) ? choose_pivot(substituted, present, equation.others, 0.1)
                                             : choose_pivot(substituted, present, equation.candidates);
    }
  } // namespace

  bool
  others_hold(const ContactEquation &equation, const Constraints &supports)
  {
    const auto is_held = [&](const types::global_dof_index dof) { return supports.is_constrained(dof); };
    return !equation.others.empty() &&
           std::all_of(equation.candidates.begin(), equation.candidates.end(), is_held) &&
           std::none_of(equation.others.begin(), equation.others.end(), is_held);
  }

  ContactConstraints::ContactConstraints(const Constraints                  &supports,
                                         const std::vector<ContactEquation> &equations)
      : trial_constraints(supports.get_local_lines()),
        symmetric(
            std::all_of(equations.begin(), equations.end(), [](const auto &e) { return e.test.empty(); })),
        contact_equations(equations), pivot_dofs(equations.size())
  {
    trial_constraints.merge(supports, Constraints::no_conflicts_allowed, true);
    if (!symmetric)
      {
        test_constraints.reinit(supports.get_local_lines());
        for (const auto &line :
             supports.get_lines()) // test functions vanish where displacements are prescribed
          {
            test_constraints.add_line(line.index);
            test_constraints.add_entries(line.index, line.entries);
          }
      }
    for (unsigned int i = 0; i < equations.size(); ++i)
      {
        auto          &e = contact_equations[i];
        LinearEquation test{e.test, 0};
        substitute(e.equation, supports);
        substitute(test, supports);
        e.test = test.coefficients;
        // Everything that is eliminated already is replaced, so that no line refers to an older one: lines
        // never form a cycle, whatever the order of the pairs (close() would not end on one).
        LinearEquation trial = e.equation;
        substitute(trial, trial_constraints);
        if (!symmetric)
          {
            if (equations[i].test.empty())
              test.coefficients = e.equation.coefficients;
            substitute(test, test_constraints);
          }
        pivot_dofs[i] = pivot_of(e, symmetric ? trial : product(trial, test), trial_constraints, supports);
        if (pivot_dofs[i])
          {
            eliminate(trial, *pivot_dofs[i], trial_constraints);
            test.value = 0;
            if (!symmetric)
              eliminate(test, *pivot_dofs[i], test_constraints);
          }
      }
    close_chains(pivot_dofs, trial_constraints);
    if (!symmetric)
      close_chains(pivot_dofs, test_constraints);
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
      for (const auto &[dof, coefficient] : contact_equations[equation_of_row[c]].force_coefficients())
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

#include <amontons/discretization/elimination.h>

#include <algorithm>

namespace Amontons
{
  void
  substitute(LinearEquation &equation, const Constraints &constraints)
  {
    for (bool changed = true; changed;)
      {
        changed = false;
        for (const auto &[dof, coefficient] : equation.coefficients)
          if (constraints.is_constrained(dof))
            {
              const auto  d       = dof;
              const auto  factor  = coefficient;
              const auto *entries = constraints.get_constraint_entries(d);
              equation.coefficients.erase(d);
              if (entries != nullptr)
                for (const auto &[other, weight] : *entries)
                  equation.coefficients[other] += factor * weight;
              equation.value -= factor * constraints.get_inhomogeneity(d);
              changed = true;
              break;
            }
      }
  }

  std::optional<types::global_dof_index>
  choose_pivot(const LinearEquation                       &equation,
               const Constraints                          &constraints,
               const std::vector<types::global_dof_index> &candidates,
               const double                                threshold)
  {
    std::optional<types::global_dof_index> best;
    double                                 largest = threshold;
    for (const auto dof : candidates)
      {
        const auto entry = equation.coefficients.find(dof);
        if (entry != equation.coefficients.end() && !constraints.is_constrained(dof) &&
            std::abs(entry->second) > largest)
          {
            // A clear margin, so that rounding does not let ranks or runs choose differently.
            largest = std::abs(entry->second) * (1 + 1e-6);
            best    = dof;
          }
      }
    return best;
  }

  void
  eliminate(const LinearEquation &equation, const types::global_dof_index pivot, Constraints &constraints)
  {
    const double coefficient = equation.coefficients.at(pivot);
    constraints.add_line(pivot);
    for (const auto &[dof, weight] : equation.coefficients)
      if (dof != pivot && weight != 0)
        constraints.add_entry(pivot, dof, -weight / coefficient);
    constraints.set_inhomogeneity(pivot, equation.value / coefficient);
  }

  void
  close_chains(const std::vector<std::optional<types::global_dof_index>> &order, Constraints &constraints)
  {
    const auto is_chained = [&](const std::optional<types::global_dof_index> &dof) {
      if (!dof)
        return false;
      const auto &entries = *constraints.get_constraint_entries(*dof);
      return std::any_of(entries.begin(), entries.end(), [&](const auto &entry) {
        return constraints.is_constrained(entry.first);
      });
    };
    if (std::any_of(order.begin(), order.end(), is_chained))
      {
        Constraints result(constraints.get_local_lines());
        for (auto dof = order.rbegin(); dof != order.rend(); ++dof)
          if (*dof)
            {
              LinearEquation line{{{**dof, 1.}}, constraints.get_inhomogeneity(**dof)};
              for (const auto &[other, weight] : *constraints.get_constraint_entries(**dof))
                line.coefficients[other] -= weight;
              substitute(line, result);
              eliminate(line, **dof, result);
            }
        result.merge(constraints, Constraints::left_object_wins, true);
        constraints = std::move(result);
      }
    constraints.close();
  }
} // namespace Amontons

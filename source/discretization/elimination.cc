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
  resolve_chains(const std::vector<types::global_dof_index> &order, Constraints &constraints)
  {
    std::map<types::global_dof_index, LinearEquation> resolved; // u_dof = sum coefficient u + value
    for (auto dof = order.rbegin(); dof != order.rend(); ++dof)
      {
        const auto &entries = *constraints.get_constraint_entries(*dof);
        if (std::none_of(entries.begin(), entries.end(), [&](const auto &e) {
              return constraints.is_constrained(e.first);
            }))
          continue;
        LinearEquation line{{}, constraints.get_inhomogeneity(*dof)};
        for (const auto &[other, weight] : entries)
          if (const auto *later = constraints.get_constraint_entries(other); later == nullptr)
            line.coefficients[other] += weight;
          else
            {
              const auto known = resolved.find(other);
              if (known == resolved.end())
                for (const auto &[free, part] : *later)
                  line.coefficients[free] += weight * part;
              else
                for (const auto &[free, part] : known->second.coefficients)
                  line.coefficients[free] += weight * part;
              line.value += weight * (known == resolved.end() ? constraints.get_inhomogeneity(other)
                                                              : known->second.value);
            }
        resolved.emplace(*dof, std::move(line));
      }
    if (resolved.empty())
      return;
    Constraints result(constraints.get_local_lines());
    for (const auto &line : constraints.get_lines())
      {
        result.add_line(line.index);
        const auto known = resolved.find(line.index);
        if (known == resolved.end())
          result.add_entries(line.index, line.entries);
        else
          for (const auto &[free, part] : known->second.coefficients)
            if (part != 0)
              result.add_entry(line.index, free, part);
        result.set_inhomogeneity(line.index,
                                 known == resolved.end() ? line.inhomogeneity : known->second.value);
      }
    constraints = std::move(result);
  }
} // namespace Amontons

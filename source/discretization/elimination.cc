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

  namespace
  {
    using Lines = std::map<types::global_dof_index, LinearEquation>; // u_dof = sum coefficient u + value

    // known: of DoFs that were eliminated later.
    LinearEquation
    replaced_line(const types::global_dof_index dof, const Constraints &constraints, const Lines &known)
    {
      LinearEquation line{{}, constraints.get_inhomogeneity(dof)};
      for (const auto &[other, weight] : *constraints.get_constraint_entries(dof))
        if (const auto at = known.find(other); at != known.end())
          {
            for (const auto &[free, part] : at->second.coefficients)
              line.coefficients[free] += weight * part;
            line.value += weight * at->second.value;
          }
        else if (const auto *const later = constraints.get_constraint_entries(other))
          {
            for (const auto &[free, part] : *later)
              line.coefficients[free] += weight * part;
            line.value += weight * constraints.get_inhomogeneity(other);
          }
        else
          line.coefficients[other] += weight;
      return line;
    }
  } // namespace

  void
  close_chains(const std::vector<std::optional<types::global_dof_index>> &order, Constraints &constraints)
  {
    Lines replaced;
    for (auto dof = order.rbegin(); dof != order.rend(); ++dof)
      if (*dof)
        {
          const auto &entries = *constraints.get_constraint_entries(**dof);
          if (std::any_of(entries.begin(), entries.end(), [&](const auto &entry) {
                return constraints.is_constrained(entry.first);
              }))
            replaced.emplace(**dof, replaced_line(**dof, constraints, replaced));
        }
    if (!replaced.empty())
      {
        Constraints result(constraints.get_local_lines());
        for (const auto &line : constraints.get_lines())
          {
            const auto at = replaced.find(line.index);
            result.add_line(line.index);
            result.set_inhomogeneity(line.index,
                                     at == replaced.end() ? line.inhomogeneity : at->second.value);
            if (at == replaced.end())
              result.add_entries(line.index, line.entries);
            else
              for (const auto &[free, part] : at->second.coefficients)
                if (part != 0)
                  result.add_entry(line.index, free, part);
          }
        constraints = std::move(result);
      }
    constraints.close();
  }
} // namespace Amontons

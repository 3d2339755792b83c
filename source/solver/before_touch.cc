#include <amontons/solver/before_touch.h>

namespace Amontons
{
  template <int dim>
  std::vector<std::vector<Tensor<1, dim>>>
  motion_before_touch(const SolutionState<dim> &state)
  {
    std::vector<std::vector<Tensor<1, dim>>> result(state.contact.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      {
        const auto &now = state.contact[i];
        result[i].resize(now.size());
        for (unsigned int n = 0; n < now.size(); ++n)
          if (const auto &old = state.committed_contact[i][n];
              old.has_multiplier && now[n].has_multiplier && old.state == ContactStatus::open &&
              now[n].state == ContactStatus::open && old.gap > now[n].gap && now[n].gap > 0)
            if (const double share = now[n].gap / (old.gap - now[n].gap); share < 2)
              result[i][n] = std::min(share, 1.) * (now[n].slip + state.motion_before_touch(i, n));
      }
    return result;
  }

  template <int dim>
  std::vector<NodalContacts<dim>>
  contact_at_rest(const std::vector<ContactInterface<dim>> &interfaces, const bool mean)
  {
    std::vector<NodalContacts<dim>> result;
    for (const auto &interface : interfaces)
      {
        result.emplace_back(interface.slave->nodes.size());
        for (const auto &row : interface.coupling.rows)
          {
            auto &node          = result.back()[row.node];
            node.has_multiplier = true;
            node.gap            = mean ? std::max(row.gap, row.mean_gap) : row.gap;
          }
      }
    return result;
  }

  template std::vector<std::vector<Tensor<1, 2>>>
  motion_before_touch(const SolutionState<2> &);
  template std::vector<std::vector<Tensor<1, 3>>>
  motion_before_touch(const SolutionState<3> &);
  template std::vector<NodalContacts<2>>
  contact_at_rest(const std::vector<ContactInterface<2>> &, const bool);
  template std::vector<NodalContacts<3>>
  contact_at_rest(const std::vector<ContactInterface<3>> &, const bool);
} // namespace Amontons

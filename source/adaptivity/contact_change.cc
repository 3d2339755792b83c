#include <amontons/adaptivity/contact_change.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Amontons
{
  namespace
  {
    // Of a pair, by slave node: area and pressure.
    using NodalPressures = std::map<unsigned int, std::array<double, 2>>;

    template <int dim>
    NodalPressures
    pressures_of(const ContactInterface<dim> &interface, const NodalContacts<dim> &contact)
    {
      NodalPressures result;
      for (const auto &row : interface.coupling.rows)
        result[row.node] = {{row.area, contact[row.node].pressure}};
      return result;
    }

    // Of tied bodies push and pull may balance: neither is nothing.
    double
    force_of(const NodalPressures &pressures)
    {
      double force = 0;
      for (const auto &[node, value] : pressures)
        force += value[0] * std::abs(value[1]);
      return force;
    }

    template <int dim>
    Tensor<1, dim>
    centre_of(const NodalPressures &pressures, const ContactSurface<dim> &surface)
    {
      Tensor<1, dim> sum;
      for (const auto &[node, value] : pressures)
        sum += value[0] * std::abs(value[1]) * surface.nodes[node].x;
      return sum / force_of(pressures);
    }

    // Of all that the slave of a pair bears.
    template <int dim>
    double
    resultant_of(const ContactInterface<dim> &interface, const NodalContacts<dim> &contact)
    {
      Tensor<1, dim> sum;
      for (const auto &row : interface.coupling.rows)
        sum += row.area * (contact[row.node].pressure * interface.slave->nodes[row.node].normal -
                           contact[row.node].shear);
      return sum.norm();
    }

    // Largest first: by pressure, its area.
    std::vector<std::pair<double, double>>
    sorted(const NodalPressures &pressures)
    {
      std::vector<std::pair<double, double>> result;
      for (const auto &[node, value] : pressures)
        if (value[0] > 0)
          result.emplace_back(value[1], value[0]);
      std::sort(result.rbegin(), result.rend());
      return result;
    }

    // Integral of (p - q)^2, where p(s) and q(s) are the pressures of both on their areas s, the largest
    // first. At most that of the difference of both fields, and the same if a field moves along the surface.
    double
    distance_of_sorted(const NodalPressures &one, const NodalPressures &other)
    {
      const auto p = sorted(one), q = sorted(other);
      double     sum = 0, s = 0, end_p = 0, end_q = 0;
      for (unsigned int i = 0, j = 0; i < p.size() || j < q.size();)
        {
          const double until_p = i < p.size() ? end_p + p[i].second : std::numeric_limits<double>::max(),
                       until_q = j < q.size() ? end_q + q[j].second : std::numeric_limits<double>::max(),
                       next    = std::min(until_p, until_q),
                       change  = (i < p.size() ? p[i].first : 0.) - (j < q.size() ? q[j].first : 0.);
          sum += change * change * (next - s);
          s = next;
          if (until_p <= next)
            {
              end_p = until_p;
              ++i;
            }
          if (until_q <= next)
            {
              end_q = until_q;
              ++j;
            }
        }
      return sum;
    }
  } // namespace

  template <int dim>
  ContactChange
  change_of_contact(const std::vector<ContactInterface<dim>> &interfaces,
                    const SolutionState<dim>                 &state,
                    const std::vector<ContactInterface<dim>> &finite_interfaces,
                    const SolutionState<dim>                 &finite_state,
                    const double                              size)
  {
    double force_change = 0, largest_force = 0, square_change = 0, square = 0, shift = 0;
    bool   appears = false, has_resultant = false;
    // Forces of a hundredth of the rest are not what anybody asks for.
    constexpr double least_part = 0.01;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto   before    = pressures_of(interfaces[i], state.contact[i]);
        auto         after     = pressures_of(finite_interfaces[i], finite_state.contact[i]);
        const double old_force = force_of(before), new_force = force_of(after);
        for (auto &[node, value] : after) // on the same surface
          if (const auto same = before.find(node); same != before.end())
            value[0] = same->second[0];
        force_change  = std::max(force_change, std::abs(new_force - old_force));
        largest_force = std::max(largest_force, std::abs(old_force));
        has_resultant =
            has_resultant || resultant_of(interfaces[i], state.contact[i]) > least_part * old_force;
        appears = appears || new_force > 0;
        square_change += distance_of_sorted(before, after);
        for (const auto &[node, value] : before)
          square += value[0] * value[1] * value[1];
        if (old_force > 0 && new_force > 0) // how far that force moves
          shift = std::max(
              shift,
              old_force *
                  (centre_of(after, *interfaces[i].slave) - centre_of(before, *interfaces[i].slave)).norm());
      }
    if (largest_force <= 0)
      return appears ? ContactChange{1, 1, 0, true} : ContactChange();
    return {force_change / largest_force,
            std::sqrt(square_change / square),
            shift / (largest_force * size),
            has_resultant};
  }

  template ContactChange
  change_of_contact(const std::vector<ContactInterface<2>> &,
                    const SolutionState<2> &,
                    const std::vector<ContactInterface<2>> &,
                    const SolutionState<2> &,
                    const double);
  template ContactChange
  change_of_contact(const std::vector<ContactInterface<3>> &,
                    const SolutionState<3> &,
                    const std::vector<ContactInterface<3>> &,
                    const SolutionState<3> &,
                    const double);
} // namespace Amontons

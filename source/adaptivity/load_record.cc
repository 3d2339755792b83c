#include <amontons/adaptivity/load_record.h>
#include <amontons/base/points.h>
#include <amontons/friction/shear_law.h>

namespace Amontons
{
  namespace
  {
    // Of the shear.
    template <int dim>
    double
    bound_at(const ContactInterface<dim> &interface,
             const unsigned int           node,
             const SolutionState<dim>    &state,
             const unsigned int           i)
    {
      return interface.pair->has_friction() ? shear_bound(*interface.pair,
                                                          as_3d(interface.slave->nodes[node].X),
                                                          state.t,
                                                          state.contact[i][node].pressure)
                                                  .value
                                            : 0;
    }
  } // namespace

  template <int dim>
  bool
  note_closed(const std::vector<ContactInterface<dim>> &interfaces,
              const SolutionState<dim>                 &state,
              LoadRecord::ClosedNodes                  &closed)
  {
    bool any = false;
    closed.resize(interfaces.size());
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (!interfaces[i].pair->has_friction())
          continue;
        const auto *const before = state.committed_contact.empty() ? nullptr : &state.committed_contact[i];
        for (const auto &row : interfaces[i].coupling.rows)
          {
            if (state.contact[i][row.node].state == ContactStatus::open)
              continue;
            const bool is_new = before == nullptr || (*before)[row.node].state == ContactStatus::open;
            any               = any || is_new;
            const auto known  = closed[i].find(row.node);
            if (!is_new && known == closed[i].end())
              continue;
            double &square = closed[i][row.node];
            square = std::max(square, row.area * std::pow(bound_at(interfaces[i], row.node, state, i), 2));
          }
      }
    return any;
  }

  template <int dim>
  std::vector<LoadRecord::Pair>
  record_pairs(const std::vector<ContactInterface<dim>> &interfaces,
               const std::vector<SurfaceFields<dim>>    &fields,
               const SolutionState<dim>                 &state,
               const LoadRecord::ClosedNodes            &closed)
  {
    std::vector<LoadRecord::Pair> pairs;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const PairData &pair = *interfaces[i].pair;
        if (pair.tied)
          continue;
        LoadRecord::Pair kept;
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto &node     = state.contact[i][row.node];
            kept.nodes[row.node] = {
                row.area, node.pressure, bound_at(interfaces[i], row.node, state, i), as_3d(node.shear)};
            kept.force += row.area * node.pressure;
          }
        for (const auto &[node, square] : closed[i])
          kept.closed += square;
        kept.closed           = std::sqrt(kept.closed);
        kept.normal_force     = as_3d(fields[i].normal_force);
        kept.tangential_force = as_3d(fields[i].tangential_force);
        kept.contact_size     = fields[i].contact_size;
        kept.stick_size       = fields[i].stick_size;
        kept.tresca_alone     = !pair.friction;
        pairs.push_back(kept);
      }
    return pairs;
  }

  namespace
  {
    template <int dim>
    unsigned int
    most_closed_nodes(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState<dim> &state)
    {
      unsigned int most = 0;
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        if (interfaces[i].pair->has_friction())
          most = std::max<unsigned int>(
              most, std::count_if(state.contact[i].begin(), state.contact[i].end(), [](const auto &node) {
                return node.state != ContactStatus::open;
              }));
      return most;
    }
  } // namespace

  template <int dim>
  bool
  resolves_friction(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState<dim> &state)
  {
    return most_closed_nodes(interfaces, state) >= (dim == 2 ? 10 : 20);
  }

  // n faces: a line of half-width n h/2, or a disk of radius sqrt(n/pi) h.
  template <int dim>
  bool
  may_hide_stick(const std::vector<ContactInterface<dim>> &interfaces, const SolutionState<dim> &state)
  {
    const double n = most_closed_nodes(interfaces, state);
    return n > 0 && (dim == 2 ? 2 / n > 0.01 : std::sqrt(numbers::PI / n) > 0.05);
  }

  template bool
  note_closed(const std::vector<ContactInterface<2>> &, const SolutionState<2> &, LoadRecord::ClosedNodes &);
  template bool
  note_closed(const std::vector<ContactInterface<3>> &, const SolutionState<3> &, LoadRecord::ClosedNodes &);
  template std::vector<LoadRecord::Pair>
  record_pairs(const std::vector<ContactInterface<2>> &,
               const std::vector<SurfaceFields<2>> &,
               const SolutionState<2> &,
               const LoadRecord::ClosedNodes &);
  template std::vector<LoadRecord::Pair>
  record_pairs(const std::vector<ContactInterface<3>> &,
               const std::vector<SurfaceFields<3>> &,
               const SolutionState<3> &,
               const LoadRecord::ClosedNodes &);
  template bool
  resolves_friction(const std::vector<ContactInterface<2>> &, const SolutionState<2> &);
  template bool
  may_hide_stick(const std::vector<ContactInterface<2>> &, const SolutionState<2> &);
  template bool
  resolves_friction(const std::vector<ContactInterface<3>> &, const SolutionState<3> &);
  template bool
  may_hide_stick(const std::vector<ContactInterface<3>> &, const SolutionState<3> &);
} // namespace Amontons

#include <amontons/friction/limit_load.h>
#include <amontons/solver/node_states.h>

namespace Amontons
{
  template <int dim>
  NodeStates<dim>::NodeStates(const std::vector<SlaveNode<dim>>        &nodes,
                              const std::vector<ContactInterface<dim>> &interfaces,
                              const FloatingBodies<dim>                &floating,
                              const double                              t)
      : nodes(nodes), interfaces(interfaces), floating(floating), t(t),
        any_friction(
            std::any_of(nodes.begin(), nodes.end(), [](const auto &node) { return node.frictional; })),
        states(nodes.size(), ContactStatus::open), laws(nodes.size())
  {
  }

  template <int dim>
  void
  NodeStates<dim>::start(const SolutionState<dim> &state, const std::vector<bool> &closed)
  {
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const bool  has_row = nodes[k].row != numbers::invalid_unsigned_int;
        const auto *known   = has_row ? state.contact_of(nodes[k].interface, nodes[k].node) : nullptr;
        if (nodes[k].tied)
          states[k] = ContactStatus::stick;
        else if (known != nullptr)
          states[k] = known->state;
        else if (closed[k])
          states[k] = nodes[k].frictional ? ContactStatus::stick : ContactStatus::slip;
        if (nodes[k].wedged && states[k] != ContactStatus::open)
          {
            states[k] = ContactStatus::slip;
            laws[k]   = SlipLaw<dim>();
            continue;
          }
        if (known == nullptr || !nodes[k].frictional || states[k] != ContactStatus::slip)
          continue;

        const Tensor<1, dim> direction = nodes[k].tangential(known->trial);
        const double         p         = known->pressure;
        if (direction.norm() == 0)
          states[k] = ContactStatus::stick;
        else
          {
            const auto limit = bound(k, p);
            laws[k]          = linearise_slip(limit.value * direction, p, limit, nodes[k].c);
            if (limit.value == 0)
              laws[k].direction = direction / direction.norm();
          }
      }
  }

  template <int dim>
  ShearBound
  NodeStates<dim>::bound(const unsigned int k, const double pressure) const
  {
    if (is_frozen || !given_bounds.empty())
      return {is_frozen ? frozen_bounds[k] : given_bounds[k], 0.};
    return shear_bound(*interfaces[nodes[k].interface].pair, nodes[k].X, t, pressure);
  }

  // By pair: no more than 1e-4 of its largest nodal force, if that is a force.
  template <int dim>
  std::vector<double>
  NodeStates<dim>::neutral_forces(const NodalContacts<dim> &answers, const double neutral) const
  {
    std::vector<double> result(interfaces.size(), 0.);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      result[nodes[k].interface] =
          std::max(result[nodes[k].interface], nodes[k].area * std::abs(answers[k].pressure));
    for (auto &force : result)
      force = force > neutral ? std::min(neutral, 1e-4 * force) : neutral;
    return result;
  }

  template <int dim>
  std::vector<double>
  NodeStates<dim>::largest_bounds(const NodalContacts<dim> &answers, const std::vector<bool> &closed) const
  {
    std::vector<double> result(interfaces.size(), 0.);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (closed[k] && nodes[k].frictional)
        result[nodes[k].interface] =
            std::max(result[nodes[k].interface], bound(k, answers[k].pressure).value);
    return result;
  }

  template <int dim>
  unsigned int
  NodeStates<dim>::update(const NodalContacts<dim> &answers, const double rounding, const Neutral &neutral)
  {
    const auto                no_force = neutral_forces(answers, neutral.force);
    std::vector<double>       p, g, c;
    std::vector<bool>         next;
    std::vector<unsigned int> may_open;
    double                    largest = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (!nodes[k].tied)
        {
          may_open.push_back(k);
          const double pressure = answers[k].pressure, gap = answers[k].gap;
          const bool   is_open = states[k] == ContactStatus::open;
          const bool   is_neutral =
              is_open ? gap < 0 && -gap <= neutral.gap
                        : pressure < 0 && -pressure * nodes[k].area <= no_force[nodes[k].interface];
          p.push_back(is_neutral ? 0 : pressure);
          g.push_back(is_neutral ? 0 : gap);
          c.push_back(nodes[k].c);
          next.push_back(!is_open);
          largest = std::max(largest, std::abs(pressure));
        }
    const double tolerance = std::max(1e-9 * largest, rounding);
    //! [globalisation]
    active_set.update(p, g, c, tolerance, next);
    //! [globalisation]

    const auto        old = states;
    std::vector<bool> closed(nodes.size(), true);
    for (unsigned int i = 0; i < may_open.size(); ++i)
      closed[may_open[i]] = next[i];
    //! [globalisation]
    choose_friction_states(answers, closed, tolerance, no_force);
    //! [globalisation]
    first = false;
    if (single)
      keep_last_change(old);
    //! [globalisation]
    hold_motions(answers);
    //! [globalisation]
    changed.clear();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (old[k] != states[k])
        changed.push_back(k);
    //! [globalisation]
    if (any_friction)
      watch_for_cycles(answers, changed.size());
    //! [globalisation]
    return changed.size();
  }

  template <int dim>
  bool
  NodeStates<dim>::rests(const unsigned int k, const NodalContact<dim> &answer, const double limit) const
  {
    constexpr double none = 1e-3; // of the way that shear at the bound bends the surface by
    return nodes[k].wedged && nodes[k].c * answer.slip.norm() <= none * limit;
  }

  template <int dim>
  void
  NodeStates<dim>::slide(const unsigned int k, const NodalContact<dim> &answer)
  {
    const double         p     = answer.pressure - nodes[k].c * answer.gap;
    const auto           limit = bound(k, p);
    const Tensor<1, dim> way   = nodes[k].c * answer.slip;
    states[k]                  = ContactStatus::slip;
    laws[k]                    = rests(k, answer, limit.value)
                                     ? SlipLaw<dim>()
                                     : linearise_slip((1 + limit.value / way.norm()) * way, p, limit, nodes[k].c);
  }

  template <int dim>
  void
  NodeStates<dim>::choose_friction_states(const NodalContacts<dim>  &answers,
                                          const std::vector<bool>   &closed,
                                          const double               tolerance,
                                          const std::vector<double> &no_force)
  {
    const auto largest = largest_bounds(answers, closed);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        if (nodes[k].tied)
          continue;
        const ContactStatus old = states[k];
        if (!closed[k])
          {
            states[k] = ContactStatus::open;
            if (is_frozen && is_exhausted)
              frozen_bounds[k] = 0;
          }
        else if (!nodes[k].frictional)
          states[k] = ContactStatus::slip;
        else if (nodes[k].wedged)
          slide(k, answers[k]);
        else
          {
            const double p      = answers[k].pressure - nodes[k].c * answers[k].gap;
            const auto   limit  = bound(k, p);
            const auto   q      = trial(k, answers[k]);
            const double excess = q.norm() - limit.value;
            const bool   slid   = old == ContactStatus::slip;
            // Without a bound nothing holds what slid, wherever it turns.
            const bool turned = !first && slid && limit.value > 0 && q * laws[k].direction < 0;
            const bool moves  = slid && (limit.value <= 0 || nodes[k].c * answers[k].slip.norm() > tolerance);
            // What sticks may be over its bound by what counts as none, as a force and as a traction (areas
            // at the edge of the contact may be small). (What slid and rests is to stick: a slip of nothing
            // holds a self-locking wedge on some meshes only.)
            const double more = old == ContactStatus::stick
                                    ? std::min(no_force[nodes[k].interface] / nodes[k].area,
                                               1e-4 * largest[nodes[k].interface])
                                    : 0;
            const bool   slips =
                (is_frozen && limit.value <= 0) ||
                (!turned && q.norm() > 0 && excess > (moves ? -tolerance : std::max(tolerance, more)));
            states[k] = slips ? ContactStatus::slip : ContactStatus::stick;
            if (slips)
              laws[k] = linearise_slip(q, p, limit, nodes[k].c);
          }
      }
  }

  // Murty's rule for friction: of all the changes only that of the node with the highest number.
  template <int dim>
  void
  NodeStates<dim>::keep_last_change(const std::vector<ContactStatus> &old)
  {
    bool found = false;
    for (unsigned int k = nodes.size(); k-- > 0;)
      if (states[k] != old[k])
        {
          if (found)
            states[k] = old[k];
          found = true;
        }
  }

  template <int dim>
  std::vector<std::vector<double>>
  NodeStates<dim>::free_rigid_modes(const bool by_sticking) const
  {
    if (!floating.any())
      return {};
    std::vector<LinearEquation> all;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (const auto &equation : resistance_of(nodes[k], states[k], by_sticking ? SlipLaw<dim>() : laws[k]))
        all.push_back(equation);
    std::vector<const LinearEquation *> pointers;
    pointers.reserve(all.size());
    for (const auto &equation : all)
      pointers.push_back(&equation);
    return floating.free_rigid_modes(pointers);
  }

  template <int dim>
  std::string
  NodeStates<dim>::describe(const std::vector<std::vector<double>> &motions) const
  {
    std::string text;
    for (const auto &q : motions)
      if (const std::string motion = floating.describe(q); text.find(motion) == std::string::npos)
        text += (text.empty() ? "" : "; ") + motion;
    return text;
  }

  template <int dim>
  std::vector<double>
  NodeStates<dim>::beyond_friction(const double share) const
  {
    if (!any_friction || !floating.any())
      return {};
    const auto motions = floating.free_rigid_modes(holding_equations(nodes, true));

    std::vector<RigidContact> contacts;
    for (const auto &node : nodes)
      if (!node.tied)
        {
          RigidContact contact;
          for (const auto &motion : motions)
            contact.closing.push_back(floating.evaluate_on(node.closing.equation, motion));
          if (node.frictional)
            {
              const auto &friction = interfaces[node.interface].pair->friction;
              if (!friction || !friction->is_constant())
                return {};
              contact.friction = share * friction->value(node.X, t);
              contact.sliding.assign(dim, {});
              for (const auto &motion : motions)
                {
                  Tensor<1, dim> jump;
                  for (unsigned int d = 0; d < dim; ++d)
                    jump[d] = floating.evaluate_on(node.components[d].equation, motion);
                  jump = node.tangential(jump);
                  for (unsigned int d = 0; d < dim; ++d)
                    contact.sliding[d].push_back(jump[d]);
                }
            }
          contacts.push_back(contact);
        }
    return combination(motions, motion_beyond_friction(floating.relative_work(motions), contacts, 1e-5));
  }

  template <int dim>
  void
  NodeStates<dim>::impose(const NodalContacts<dim> &answers)
  {
    forget();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        states[k] = answers[k].state;
        if (const double p = answers[k].pressure; nodes[k].frictional && states[k] == ContactStatus::slip)
          laws[k] = linearise_slip(answers[k].shear, p, bound(k, p), nodes[k].c);
      }
  }

  // A body that slips as a whole may be moved back along the motion m, by a: of the nodes that slip by v_i
  // along it (slip . m_i/|m_i|^2), those with v_i > a still do, those with v_i < a slip the other way, and
  // with bounds w_i |m_i| loads of the work W on m are in balance where W + sum_{v_i < a} w_i - sum_{v_i > a}
  // w_i changes its sign. There rests a node; the least v_i if friction is all that holds (W = sum w_i).
  template <int dim>
  unsigned int
  NodeStates<dim>::node_at_rest(const std::vector<double> &motion, const NodalContacts<dim> &answers) const
  {
    struct Slip
    {
      double       along, ratio, bound;
      unsigned int node;
    };
    std::vector<Slip> slips;
    double            excess = floating.work(motion);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (nodes[k].frictional && states[k] == ContactStatus::slip)
        {
          Tensor<1, dim> m;
          for (unsigned int d = 0; d < dim; ++d)
            m[d] = floating.evaluate_on(nodes[k].components[d].equation, motion);
          m                  = nodes[k].tangential(m);
          const double limit = bound(k, answers[k].pressure).value;
          if (m.norm() < 1e-6 || limit <= 0)
            continue;
          slips.push_back({answers[k].slip * m / m.norm_square(),
                           trial(k, answers[k]).norm() / std::max(limit, 1e-300),
                           std::max(limit, 0.) * nodes[k].area * m.norm(),
                           k});
          excess -= slips.back().bound;
        }
    std::sort(slips.begin(), slips.end(), [](const Slip &a, const Slip &b) {
      return std::tie(a.along, a.ratio) < std::tie(b.along, b.ratio);
    });
    for (const Slip &slip : slips)
      if ((excess += 2 * slip.bound) >= 0)
        return slip.node;
    return slips.empty() ? nodes.size() : slips.front().node;
  }

  template <int dim>
  void
  NodeStates<dim>::hold_motions(const NodalContacts<dim> &answers)
  {
    held.clear();
    if (!any_friction || !floating.any())
      return;
    ++sliding.n_updates;
    const auto now = free_rigid_modes(true);
    if (now.empty())
      return;
    ++sliding.n;
    sliding.motions = now;
    auto motions    = free_rigid_modes();
    motions_held    = motions;
    while (!motions.empty())
      {
        const unsigned int k = node_at_rest(motions[0], answers);
        if (k == nodes.size())
          return;
        states[k] = ContactStatus::stick;
        held.push_back(k);
        motions = free_rigid_modes();
      }
  }

  template <int dim>
  void
  NodeStates<dim>::watch_for_cycles(const NodalContacts<dim> &answers, const unsigned int n_changes)
  {
    const auto follow = [&]() {
      std::vector<double> next(frozen_bounds);
      double              change = 0, largest = 0;
      is_frozen = false;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        if (nodes[k].frictional)
          {
            next[k] = bound(k, answers[k].pressure).value;
            change  = std::max(change, std::abs(next[k] - frozen_bounds[k]));
            largest = std::max(largest, next[k]);
          }
      is_frozen = true;
      if (largest > 0)
        change /= largest;
      swings = swings || change > last_change / 4;
      for (unsigned int k = 0; k < nodes.size(); ++k)
        frozen_bounds[k] += (swings ? 0.5 : 1) * (next[k] - frozen_bounds[k]);
      last_change = change;
    };
    if (n_changes == 0)
      {
        single = false;
        met.clear();
        if (is_frozen)
          {
            follow();
            is_frozen = last_change >= 1e-3;
          }
        return;
      }
    std::string key;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        key += char('0' + int(states[k]));
        if (dim == 2 && nodes[k].frictional && states[k] == ContactStatus::slip)
          for (unsigned int d = 0; d < dim; ++d)
            key += laws[k].direction[d] > 0 ? '+' : '-';
      }
    if (met.insert(key).second)
      return;
    met.clear();
    is_exhausted = is_exhausted || is_frozen;
    single       = is_frozen;
    if (!is_frozen)
      {
        frozen_bounds.assign(nodes.size(), 0.);
        swings      = false;
        last_change = std::numeric_limits<double>::max();
        follow();
        last_change = std::numeric_limits<double>::max();
      }
  }

  template <int dim>
  std::string
  NodeStates<dim>::where_unsettled() const
  {
    std::vector<Point<dim>> places;
    for (const unsigned int k : held.empty() ? changed : held)
      {
        places.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          places.back()[d] = nodes[k].X[d];
      }
    return places_of(places);
  }

  // (shear + c slip)/bound is bounded, as it will be interpolated: where the pressure vanishes the ratio has
  // none.
  template <int dim>
  std::vector<NodalContacts<dim>>
  NodeStates<dim>::by_slave_node(const NodalContacts<dim> &answers) const
  {
    std::vector<NodalContacts<dim>> result;
    for (const auto &interface : interfaces)
      result.emplace_back(interface.slave->nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (nodes[k].row != numbers::invalid_unsigned_int)
        {
          auto &contact = result[nodes[k].interface][nodes[k].node];
          if (std::isfinite(answers[k].pressure))
            contact = answers[k];
          contact.has_multiplier = true;
          contact.state          = states[k];
          const double limit     = bound(k, contact.pressure).value;
          if (nodes[k].frictional && states[k] != ContactStatus::open && limit > 0)
            {
              contact.trial = trial(k, contact) / limit;
              contact.trial *= std::min(1., 3 / std::max(contact.trial.norm(), 1e-100));
            }
        }
    return result;
  }

  template <int dim>
  double
  NodeStates<dim>::law_error(const NodalContacts<dim> &answers) const
  {
    double sum = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (nodes[k].frictional && states[k] == ContactStatus::slip)
        {
          const double p     = answers[k].pressure;
          const auto   q     = trial(k, answers[k]);
          auto         limit = given_bounds.empty()
                                   ? shear_bound(*interfaces[nodes[k].interface].pair, nodes[k].X, t, p)
                                   : ShearBound{given_bounds[k], 0.};
          limit.value += limit.slope * std::min(0., p); // a tension that leaves a node closed is no error
          const auto expected = rests(k, answers[k], limit.value) ? Tensor<1, dim>()
                                : q.norm() > 0                    ? limit.value / q.norm() * q
                                                                  : q;
          sum += std::pow(nodes[k].area, 2) * (answers[k].shear - expected).norm_square();
        }
    return std::sqrt(sum);
  }

  template class NodeStates<2>;
  template class NodeStates<3>;
} // namespace Amontons

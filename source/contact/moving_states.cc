#include <amontons/contact/moving_states.h>
#include <amontons/contact/surface_order.h>

#include <algorithm>
#include <limits>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int few_states = 8; // that change are found at once

    // Nodes with a row, in their order along the surface.
    struct Line
    {
      std::vector<unsigned int> nodes;
      std::vector<double>       place; // length up to there
    };

    Line
    line_of(const ContactInterface<2> &interface)
    {
      std::vector<Point<2>>                  nodes;
      std::vector<std::vector<unsigned int>> faces;
      for (const auto &node : interface.slave->nodes)
        nodes.push_back(node.X);
      for (const auto &face : interface.slave->faces)
        faces.push_back(face.nodes);
      Line         line;
      double       length = 0;
      unsigned int last   = numbers::invalid_unsigned_int;
      for (const unsigned int i : order_along_surface(nodes, faces))
        {
          length += last == numbers::invalid_unsigned_int ? 0. : nodes[i].distance(nodes[last]);
          last = i;
          if (interface.carried[i])
            {
              line.nodes.push_back(i);
              line.place.push_back(length);
            }
        }
      return line;
    }

    struct Parts
    {
      std::vector<ContactStatus> states;
      std::vector<double>        ends; // one less
    };

    Parts
    parts_of(const Line &line, const NodalContacts<2> &contact)
    {
      Parts parts;
      for (unsigned int k = 0; k < line.nodes.size(); ++k)
        if (const auto state = contact[line.nodes[k]].state; k == 0 || state != parts.states.back())
          {
            if (k > 0)
              parts.ends.push_back((line.place[k - 1] + line.place[k]) / 2);
            parts.states.push_back(state);
          }
      return parts;
    }

    // The node of that state that is nearest along the line to its k-th node.
    unsigned int
    nearest_of(const Line             &line,
               const NodalContacts<2> &contact,
               const ContactStatus     state,
               const unsigned int      k)
    {
      unsigned int nearest  = line.nodes[k];
      double       distance = std::numeric_limits<double>::max();
      for (unsigned int j = 0; j < line.nodes.size(); ++j)
        if (const double d = std::abs(line.place[j] - line.place[k]);
            contact[line.nodes[j]].state == state && d < distance)
          {
            nearest  = line.nodes[j];
            distance = d;
          }
      return nearest;
    }
  } // namespace

  template <>
  std::optional<NodalContacts<2>>
  move_states_on(const ContactInterface<2> &interface,
                 const NodalContacts<2>    &earlier,
                 const double               t0,
                 const NodalContacts<2>    &now,
                 const double               t1,
                 const double               t)
  {
    const double further = (t - t1) / (t1 - t0);
    const Line   line    = line_of(interface);
    const auto   before  = parts_of(line, earlier);
    auto         parts   = parts_of(line, now);
    if (before.states != parts.states)
      return {};
    for (unsigned int e = 0; e < parts.ends.size(); ++e)
      parts.ends[e] += further * (parts.ends[e] - before.ends[e]);
    if (!std::is_sorted(parts.ends.begin(), parts.ends.end()))
      return {};
    NodalContacts<2> result    = now;
    unsigned int     n_changes = 0;
    for (unsigned int k = 0; k < line.nodes.size(); ++k)
      {
        const auto part =
            std::upper_bound(parts.ends.begin(), parts.ends.end(), line.place[k]) - parts.ends.begin();
        const auto state = parts.states[part];
        auto      &node  = result[line.nodes[k]];
        if (state == node.state)
          continue;
        node.state    = state;
        node.trial    = now[nearest_of(line, now, state, k)].trial;
        node.pressure = state == ContactStatus::open ? 0 : node.pressure;
        ++n_changes;
      }
    return n_changes > few_states ? std::make_optional(result) : std::nullopt;
  }

  template <>
  std::optional<NodalContacts<3>>
  move_states_on(const ContactInterface<3> &,
                 const NodalContacts<3> &,
                 const double,
                 const NodalContacts<3> &,
                 const double,
                 const double)
  {
    return {};
  }
} // namespace Amontons

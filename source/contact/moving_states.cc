#include <amontons/contact/moving_states.h>

#include <algorithm>
#include <map>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int few_states = 8; // that change are found at once

    // Nodes with a row, in their order along an open or closed line of faces.
    struct Line
    {
      std::vector<unsigned int> nodes;
      std::vector<double>       place; // length of the line up to there
    };

    std::vector<Line>
    lines_of(const ContactSurface<2> &surface, const std::vector<bool> &carried)
    {
      std::map<unsigned int, std::vector<unsigned int>> faces_at; // by the node at their end
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        for (const unsigned int end : {surface.faces[f].nodes.front(), surface.faces[f].nodes.back()})
          faces_at[end].push_back(f);
      std::vector<bool> taken(surface.faces.size(), false);
      const auto        follow = [&](unsigned int end) {
        Line   line;
        double length = 0;
        for (const unsigned int *next = nullptr;; next = nullptr)
          {
            for (const unsigned int &f : faces_at[end])
              if (!taken[f])
                next = &f;
            if (next == nullptr)
              break;
            taken[*next] = true;
            auto nodes   = surface.faces[*next].nodes;
            if (nodes.front() != end)
              std::reverse(nodes.begin(), nodes.end());
            for (unsigned int k = 0; k < nodes.size(); ++k)
              {
                if (k > 0)
                  length += surface.nodes[nodes[k]].X.distance(surface.nodes[nodes[k - 1]].X);
                if (carried[nodes[k]] && (k > 0 || line.nodes.empty()))
                  {
                    line.nodes.push_back(nodes[k]);
                    line.place.push_back(length);
                  }
              }
            end = nodes.back();
          }
        return line;
      };
      std::vector<Line> lines;
      for (const bool closed : {false, true})
        for (const auto &[end, faces] : faces_at)
          if (closed || faces.size() == 1)
            if (auto line = follow(end); !line.nodes.empty())
              lines.push_back(std::move(line));
      return lines;
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
    const double     further   = (t - t1) / (t1 - t0);
    NodalContacts<2> result    = now;
    unsigned int     n_changes = 0;
    for (const Line &line : lines_of(*interface.slave, interface.carried))
      {
        const auto before = parts_of(line, earlier);
        auto       parts  = parts_of(line, now);
        if (before.states != parts.states)
          return {};
        for (unsigned int e = 0; e < parts.ends.size(); ++e)
          parts.ends[e] += further * (parts.ends[e] - before.ends[e]);
        if (!std::is_sorted(parts.ends.begin(), parts.ends.end()))
          return {};
        for (unsigned int k = 0; k < line.nodes.size(); ++k)
          {
            const auto part =
                std::upper_bound(parts.ends.begin(), parts.ends.end(), line.place[k]) - parts.ends.begin();
            const auto state = parts.states[part];
            auto      &node  = result[line.nodes[k]];
            if (state == now[line.nodes[k]].state)
              continue;
            const auto &alike = now[nearest_of(line, now, state, k)];
            node.state        = state;
            node.trial        = alike.trial;
            node.pressure     = state == ContactStatus::open ? 0 : node.pressure;
            ++n_changes;
          }
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

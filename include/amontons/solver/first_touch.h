/// Where a node that was open when the increment began touches first.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

namespace Amontons
{
  /// Gap g and tangential jump J of the node go on as they did in the increments before: where J is known at
  /// the gaps g < g_- < g_-- it is, along the parabola through the three,
  ///   J(g*) = J + l_- (J_- - J) + l_-- (J_-- - J),   l_j = prod_{i != j} (g* - g_i)/(g_j - g_i)
  /// (doc/introduction.md, *Nodes that close on the way*). Returns l_- and l_--. g_-- unknown, or not so far
  /// from g_- that it tells anything: along the line through the other two, l_-- = 0. g*: 0, or what is left
  /// when the increment ends, which is `longer` times as long as the one before. Both 0 where the node is
  /// closed or opens.
  inline std::array<double, 2>
  first_touch_weights(const double                now,
                      const double                before,
                      const std::optional<double> earlier,
                      const double                longer)
  {
    if (!(now > 0 && before > now))
      return {{0, 0}};
    const double     touch    = std::max(0., now - longer * (before - now));
    constexpr double too_near = 0.05;
    if (!earlier || *earlier - before < too_near * (before - now))
      return {{(touch - now) / (before - now), 0}};
    return {{(touch - now) * (touch - *earlier) / ((before - now) * (before - *earlier)),
             (touch - now) * (touch - before) / ((*earlier - now) * (*earlier - before))}};
  }
} // namespace Amontons

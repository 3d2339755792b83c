// Pictures of the shear traction and of the states.
#include <amontons/output/report.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    struct StateStyle
    {
      ContactStatus state;
      const char   *colour;
    };
    const std::array<StateStyle, 3> styles = {{{ContactStatus::open, "#aab2b9"},
                                               {ContactStatus::slip, "#d9541e"},
                                               {ContactStatus::stick, "#2a9d5c"}}};

    bool
    is_shown(const PressureCurve &curve, const std::size_t i)
    {
      return curve.shown == 0 || std::abs(curve.s[i]) <= curve.shown;
    }

    // The nodes that carry a multiplier (not hanging ones) as dots, a curve per state.
    template <typename PlaceOf>
    void
    add_states(Chart &chart, const PressureCurve &curve, const PlaceOf &place_of)
    {
      for (const StateStyle &style : styles)
        {
          Curve dots{state_name(style.state), {}, {}, false, true, style.colour};
          for (std::size_t i = 0; i < curve.s.size(); ++i)
            if (curve.states[i] == style.state && curve.has_multiplier[i] && is_shown(curve, i))
              {
                const std::array<double, 2> place = place_of(i);
                dots.x.push_back(place[0]);
                dots.y.push_back(place[1]);
              }
          if (!dots.x.empty())
            chart.curves.push_back(dots);
        }
    }

    // On both sides; in space, dots on one.
    void
    add_bounds(Chart &chart, const PressureCurve &curve)
    {
      const std::string colour = curve.radial ? "#dfe3e6" : "#8d959c";
      for (const double side : {1., -1.})
        {
          Curve bound{side > 0 ? "bound" : "", {}, {}, !curve.radial, curve.radial, colour, 1};
          for (std::size_t i = 0; i < curve.s.size(); ++i)
            if (is_shown(curve, i) && curve.bound[i] < 1e300)
              {
                bound.x.push_back(curve.s[i]);
                bound.y.push_back(side * curve.bound[i]);
              }
          if (!bound.x.empty() && (side > 0 || !curve.radial))
            chart.curves.push_back(bound);
        }
    }

    // Extent of what is shown along axis d.
    double
    extent(const PressureCurve &curve, const unsigned int d)
    {
      double lower = 1e300, upper = -1e300;
      for (std::size_t i = 0; i < curve.s.size(); ++i)
        if (is_shown(curve, i))
          {
            lower = std::min(lower, curve.places[i][d]);
            upper = std::max(upper, curve.places[i][d]);
          }
      return std::max(0., upper - lower);
    }

    // Tractions from the nodes, the largest as long as a twelfth of the picture.
    Curve
    needles(const PressureCurve &curve)
    {
      double largest = 0;
      for (std::size_t i = 0; i < curve.s.size(); ++i)
        if (is_shown(curve, i))
          largest = std::max(largest, std::hypot(curve.tractions[i][0], curve.tractions[i][1]));
      const double scale = largest > 0 ? std::max(extent(curve, 0), extent(curve, 1)) / 12 / largest : 0;
      Curve        lines{"shear on the slave", {}, {}, true, false, "#5b6470", 1};
      for (std::size_t i = 0; i < curve.s.size(); ++i)
        if (is_shown(curve, i) && curve.states[i] != ContactStatus::open)
          {
            lines.x.insert(lines.x.end(),
                           {curve.places[i][0], curve.places[i][0] + scale * curve.tractions[i][0], NAN});
            lines.y.insert(lines.y.end(),
                           {curve.places[i][1], curve.places[i][1] + scale * curve.tractions[i][1], NAN});
          }
      return lines;
    }
  } // namespace

  std::array<std::string, 2>
  axis_names(const PressureCurve &curve, const Units &units)
  {
    std::array<std::string, 2> names;
    for (unsigned int d = 0; d < 2; ++d)
      names[d] = with_unit(std::string(1, "xyz"[curve.axes[d]]), units.length);
    return names;
  }

  Chart
  shear_chart(const PressureCurve &curve, const Units &units)
  {
    Chart chart;
    if (curve.shear.empty())
      return chart;
    chart.title   = "Shear traction, " + curve.pair;
    chart.x_label = with_unit(curve.radial ? "distance from the centre of the contact"
                                           : "arc length from the centre of the contact",
                              units.length);
    chart.y_label = with_unit(curve.radial ? "shear along the force on the slave" : "shear on the slave",
                              units.pressure());
    add_bounds(chart, curve);
    Curve computed{"computed", {}, {}, true, false, "#1f6fb4"};
    for (std::size_t i = 0; i < curve.s.size(); ++i)
      if (is_shown(curve, i))
        {
          computed.x.push_back(curve.s[i]);
          computed.y.push_back(curve.shear[i]);
        }
    if (!curve.radial)
      chart.curves.push_back(computed);
    if (!curve.exact_shear.empty())
      chart.curves.push_back(
          {curve.exact_name, curve.exact_s, curve.exact_shear, true, false, "#8e4fb0", 1.2});
    add_states(chart, curve, [&](const std::size_t i) {
      return std::array<double, 2>{{curve.s[i], curve.shear[i]}};
    });
    return chart;
  }

  Chart
  state_map(const PressureCurve &curve, const Units &units)
  {
    Chart chart;
    if (curve.shear.empty() || !curve.radial)
      return chart;
    const auto names   = axis_names(curve, units);
    chart.title        = "States, " + curve.pair;
    chart.x_label      = names[0];
    chart.y_label      = names[1];
    chart.is_map       = true;
    chart.width        = 530;
    const double ratio = extent(curve, 0) > 0 ? extent(curve, 1) / extent(curve, 0) : 1;
    chart.height       = 82 + std::lround(440 * std::clamp(ratio, 0.3, 1.));
    chart.curves.push_back(needles(curve));
    add_states(chart, curve, [&](const std::size_t i) { return curve.places[i]; });
    return chart;
  }
} // namespace Amontons

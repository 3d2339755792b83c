#include <amontons/output/svg_chart.h>
#include <amontons/output/terminal.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    const std::array<const char *, 8> colours = {
        {"#1f6fb4", "#d9541e", "#2a9d5c", "#8e4fb0", "#c2901a", "#1aa3a8", "#c23b6b", "#5b6470"}};

    constexpr int left = 74, right = 16, bottom = 48, title_height = 34, legend_line = 16;

    // One axis: from values to [0, 1].
    struct Axis
    {
      bool                log   = false;
      double              lower = 1e300, upper = -1e300;
      std::vector<double> ticks;

      bool
      takes(const double v) const
      {
        return std::isfinite(v) && (!log || v > 0);
      }

      double
      fraction(const double v) const
      {
        return log ? std::log(v / lower) / std::log(upper / lower) : (v - lower) / (upper - lower);
      }

      void
      include(const double v)
      {
        lower = std::min(lower, v);
        upper = std::max(upper, v);
      }

      // A little room around the values; zero stays at the edge. Rounding errors are no range.
      void
      finish(const unsigned int n_ticks, const double room, const bool whole_numbers)
      {
        if (lower > upper)
          lower = log ? 0.1 : 0, upper = 1;
        if (log)
          {
            const double factor = std::max(std::pow(upper / lower, room), 1.3);
            lower /= factor;
            upper *= factor;
          }
        else
          {
            const double size  = std::max(std::abs(lower), std::abs(upper));
            const double width = upper - lower > 1e-6 * size ? upper - lower : (size > 0 ? size : 1);
            lower -= (std::abs(lower) <= 1e-6 * width ? 0 : room) * width;
            upper += room * width;
          }
        ticks = nice_ticks(lower, upper, n_ticks, log);
        if (whole_numbers)
          ticks.erase(std::remove_if(ticks.begin(),
                                     ticks.end(),
                                     [](const double v) { return std::abs(v - std::round(v)) > 1e-9; }),
                      ticks.end());
      }

      // `half` on both sides of the middle.
      void
      widen_to(const double half, const unsigned int n_ticks)
      {
        const double middle = (lower + upper) / 2;
        lower               = middle - half;
        upper               = middle + half;
        ticks               = nice_ticks(lower, upper, n_ticks, false);
      }
    };

    struct Frame
    {
      const Chart &chart;
      Axis         x, y;
      unsigned int legend_columns = 1, legend_rows = 0;
      double       legend_width = 0, top = title_height, height = 0;

      explicit Frame(const Chart &chart) : chart(chart)
      {
        x.log = chart.log_x;
        y.log = chart.log_y;
        for (const Curve &curve : chart.curves)
          for (std::size_t i = 0; i < curve.x.size(); ++i)
            if (takes(curve, i))
              {
                x.include(curve.x[i]);
                y.include(curve.y[i]);
              }
        if (!y.log && !chart.is_map)
          y.include(0);
        if (chart.is_map && x.lower < x.upper && y.lower < y.upper)
          {
            const double width = chart.width - left - right, height = chart.height - title_height - bottom;
            const double pixel = std::max((x.upper - x.lower) / width, (y.upper - y.lower) / height);
            x.widen_to(0.52 * pixel * width, 8);
            y.widen_to(0.52 * pixel * height, 6);
          }
        else
          {
            x.finish(8, 0.02, chart.whole_numbers);
            y.finish(6, 0.06, chart.whole_numbers);
          }

        unsigned int n_names = 0;
        std::size_t  longest = 0;
        for (const Curve &curve : chart.curves)
          {
            n_names += !curve.name.empty();
            longest = std::max(longest, curve.name.size());
          }
        legend_width   = 40 + 6.8 * longest;
        legend_columns = std::max(1, static_cast<int>((chart.width - left - right) / legend_width));
        legend_rows    = (n_names + legend_columns - 1) / legend_columns;
        top += legend_rows * legend_line;
        height = chart.height + legend_rows * legend_line;
      }

      bool
      takes(const Curve &curve, const std::size_t i) const
      {
        return x.takes(curve.x[i]) && y.takes(curve.y[i]);
      }

      double
      px(const double v) const
      {
        return left + x.fraction(v) * (chart.width - left - right);
      }

      double
      py(const double v) const
      {
        return height - bottom - y.fraction(v) * (height - top - bottom);
      }
    };

    std::string
    axes(const Frame &frame)
    {
      const Chart &chart = frame.chart;
      const double x0 = left, x1 = chart.width - right, y0 = frame.height - bottom, y1 = frame.top;
      std::string  svg;
      for (const double tick : frame.x.ticks)
        svg += line_between(frame.px(tick), y0, frame.px(tick), y1, "#e4e7ea") +
               text_at(frame.px(tick), y0 + 16, short_number(tick), "text-anchor=\"middle\"");
      for (const double tick : frame.y.ticks)
        svg += line_between(x0, frame.py(tick), x1, frame.py(tick), "#e4e7ea") +
               text_at(x0 - 6, frame.py(tick) + 4, short_number(tick), "text-anchor=\"end\"");
      svg += line_between(x0, y0, x1, y0, "#444") + line_between(x0, y0, x0, y1, "#444");
      if (!chart.log_y && frame.y.lower < 0 && frame.y.upper > 0)
        svg += line_between(x0, frame.py(0), x1, frame.py(0), "#999");
      const std::string middle = pixels((y0 + y1) / 2);
      svg += text_at(
          0.5 * chart.width, 20, chart.title, "text-anchor=\"middle\" font-size=\"14\" font-weight=\"600\"");
      svg += text_at((x0 + x1) / 2, frame.height - 12, chart.x_label, "text-anchor=\"middle\"");
      svg += text_at(16,
                     (y0 + y1) / 2,
                     chart.y_label,
                     "text-anchor=\"middle\" transform=\"rotate(-90 16 " + middle + ")\"");
      return svg;
    }

    std::string
    colour_of_curve(const Chart &chart, const std::size_t c)
    {
      return chart.curves[c].colour.empty() ? colours[c % colours.size()] : chart.curves[c].colour;
    }

    std::string
    curve_svg(const Frame &frame, const Curve &curve, const std::string &colour)
    {
      std::string path, markers;
      bool        begins = true;
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isnan(curve.x[i]))
          begins = true;
        else if (frame.takes(curve, i))
          {
            const std::string x = pixels(frame.px(curve.x[i])), y = pixels(frame.py(curve.y[i]));
            path += (begins ? "M" : "L") + x + " " + y;
            begins = false;
            markers += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"2.4\"/>";
          }
      std::string svg;
      if (curve.line)
        svg += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
               pixels(curve.width) + "\"/>\n";
      if (curve.markers)
        svg += "<g fill=\"" + colour + "\">" + markers + "</g>\n";
      return svg;
    }

    // In lines between the title and the curves.
    std::string
    legend(const Frame &frame)
    {
      std::string  svg;
      unsigned int n = 0;
      for (std::size_t c = 0; c < frame.chart.curves.size(); ++c)
        if (const Curve &curve = frame.chart.curves[c]; !curve.name.empty())
          {
            const unsigned int row    = n / frame.legend_columns;
            const double       x      = left + frame.legend_width * (n % frame.legend_columns);
            const double       y      = title_height + 10 + legend_line * row;
            const std::string  colour = colour_of_curve(frame.chart, c);
            if (curve.line)
              svg += line_between(x, y - 4, x + 20, y - 4, colour);
            if (curve.markers)
              svg += "<circle cx=\"" + pixels(x + 10) + "\" cy=\"" + pixels(y - 4) + "\" r=\"2.4\" fill=\"" +
                     colour + "\"/>\n";
            svg += text_at(x + 26, y, curve.name, "");
            ++n;
          }
      return svg;
    }
  } // namespace

  std::string
  svg_chart(const Chart &chart)
  {
    const Frame       frame(chart);
    const std::string width = std::to_string(chart.width), height = pixels(frame.height);
    std::string       svg = axes(frame);
    for (std::size_t c = 0; c < chart.curves.size(); ++c)
      svg += curve_svg(frame, chart.curves[c], colour_of_curve(chart, c));
    return svg_of(width, height, svg + legend(frame));
  }
} // namespace Amontons

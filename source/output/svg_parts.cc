#include <amontons/output/svg_chart.h>
#include <amontons/output/terminal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Amontons
{
  namespace
  {
    std::vector<double>
    linear_ticks(const double lower, const double upper, const unsigned int n)
    {
      const double rough = (upper - lower) / n;
      const double power = std::pow(10., std::floor(std::log10(rough)));
      double       step  = 10 * power;
      for (const double factor : {5., 2., 1.})
        if (factor * power >= rough)
          step = factor * power;

      std::vector<double> ticks;
      for (double k = std::ceil(lower / step); k * step <= upper * (1 + 1e-12) + 1e-12 * step; ++k)
        ticks.push_back(k == 0 ? 0 : k * step);
      return ticks;
    }

    std::vector<double>
    log_ticks(const double lower, const double upper, const unsigned int n)
    {
      const int           first = std::floor(std::log10(lower)), last = std::ceil(std::log10(upper));
      const bool          short_axis = upper < 1000 * lower;
      const int           stride     = std::max<int>(1, std::lround(std::ceil(double(last - first) / n)));
      std::vector<double> ticks;
      for (int k = first; k <= last; ++k)
        for (const double factor : {1., 2., 5.})
          {
            const double tick   = factor * std::pow(10., k);
            const bool   wanted = factor == 1 ? (k % stride == 0) : short_axis;
            if (wanted && tick >= lower && tick <= upper)
              ticks.push_back(tick);
          }
      return ticks.size() < 3 ? linear_ticks(lower, upper, 4) : ticks;
    }
  } // namespace

  std::vector<double>
  nice_ticks(const double lower, const double upper, const unsigned int n, const bool log)
  {
    return log ? log_ticks(lower, upper, n) : linear_ticks(lower, upper, n);
  }

  std::string
  colour_of(const double value)
  {
    static const int stops[][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
    const double     scaled     = 4 * std::clamp(std::isfinite(value) ? value : 0., 0., 1.);
    const int        k          = std::min(3, static_cast<int>(scaled));
    int              rgb[3];
    for (int c = 0; c < 3; ++c)
      rgb[c] = std::lround(stops[k][c] + (scaled - k) * (stops[k + 1][c] - stops[k][c]));
    char text[8];
    std::snprintf(text, sizeof(text), "#%02x%02x%02x", rgb[0] & 255, rgb[1] & 255, rgb[2] & 255);
    return text;
  }

  std::string
  escaped(const std::string &text)
  {
    std::string result;
    for (const char c : text)
      switch (c)
        {
          case '<':
            result += "&lt;";
            break;
          case '>':
            result += "&gt;";
            break;
          case '&':
            result += "&amp;";
            break;
          case '"':
            result += "&quot;";
            break;
          default:
            result += c;
        }
    return result;
  }

  std::string
  pixels(const double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.1f", value);
    return text;
  }

  std::string
  text_at(const double x, const double y, const std::string &text, const std::string &attributes)
  {
    return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" " + attributes + ">" + escaped(text) +
           "</text>\n";
  }

  std::string
  line_between(const double x0, const double y0, const double x1, const double y1, const std::string &colour)
  {
    return "<line x1=\"" + pixels(x0) + "\" y1=\"" + pixels(y0) + "\" x2=\"" + pixels(x1) + "\" y2=\"" +
           pixels(y1) + "\" stroke=\"" + colour + "\"/>\n";
  }

  std::string
  colour_bar(const double x, const double top, const double height, const double lowest, const double highest)
  {
    std::string  svg;
    const double step = height / n_bar_colours;
    for (int i = 0; i < n_bar_colours; ++i)
      svg += "<rect x=\"" + pixels(x) + "\" y=\"" + pixels(top + height - (i + 1) * step) +
             "\" width=\"12\" height=\"" + pixels(step + 0.3) + "\" fill=\"" +
             colour_of(double(i) / (n_bar_colours - 1)) + "\"/>\n";
    const auto mark = [&](const double value, const double place) {
      svg += "<text x=\"" + pixels(x + 17) + "\" y=\"" + pixels(top + height * (1 - place) + 4) + "\">" +
             short_number(value) + "</text>\n";
    };
    if (highest > lowest)
      for (const double tick : nice_ticks(lowest, highest, 5, false))
        mark(tick, (tick - lowest) / (highest - lowest));
    else
      mark(lowest, 0);
    return svg;
  }

  std::string
  svg_of(const std::string &width, const std::string &height, const std::string &content)
  {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<rect width=\"100%\" "
           "height=\"100%\" fill=\"#fff\"/>\n" +
           content + "</svg>\n";
  }
} // namespace Amontons

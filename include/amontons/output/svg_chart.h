// Curves as an SVG picture that stands for itself: no script, no other file.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace Amontons
{
  struct Curve
  {
    std::string         name; // for the legend; empty: not listed
    std::vector<double> x, y; // points that are not finite (or not positive on a log axis) are left out
    bool                line = true, markers = false;
    std::string         colour = ""; // empty: the next of the chart's own
    double              width  = 1.6;
  };

  struct Chart
  {
    std::string        title, x_label, y_label;
    bool               log_x = false, log_y = false; // a y axis that is not logarithmic includes 0
    bool               whole_numbers = false;        // ticks
    bool               is_map        = false;        // x and y have the same scale, and neither includes 0
    std::vector<Curve> curves;
    int                width = 530, height = 340; // without the legend, which stands above the curves
  };

  // Lines are broken where x is NaN.
  std::string
  svg_chart(const Chart &chart);

  // Round numbers between lower and upper, about n of them (log: powers of ten, thinned out; 2 and 5 times
  // these on short axes; round multiples on very short ones).
  std::vector<double>
  nice_ticks(const double lower, const double upper, const unsigned int n, const bool log);

  // Parts of a picture, places in pixels from its upper left corner.
  std::string
  text_at(const double x, const double y, const std::string &text, const std::string &attributes);
  std::string
  line_between(const double x0, const double y0, const double x1, const double y1, const std::string &colour);

  // Colour of a value in [0, 1] as "#rrggbb": dark blue over green to yellow (viridis).
  std::string
  colour_of(const double value);

  // Its colours from lowest to highest, with round numbers beside them; 12 pixels wide.
  constexpr int n_bar_colours = 24;
  std::string
  colour_bar(
      const double x, const double top, const double height, const double lowest, const double highest);

  // A picture of this size, as text in pixels, on white.
  std::string
  svg_of(const std::string &width, const std::string &height, const std::string &content);

  // Text with <, >, & and quotes written so that SVG and HTML show them.
  std::string
  escaped(const std::string &text);

  // One decimal: pixels.
  std::string
  pixels(const double value);
} // namespace Amontons

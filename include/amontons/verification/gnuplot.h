/// What the charts of all studies share. A script draws STEM.svg, and STEM.png with `gnuplot -e "png = 1"`.
#pragma once

#include <limits>
#include <ostream>
#include <string>

namespace Amontons
{
  /// As a text of gnuplot in quotes; underscores are blanks.
  std::string
  in_gnuplot(const std::string &text);

  /// Of what is drawn on a logarithmic axis: positive finite numbers only.
  struct LogRange
  {
    double lower = std::numeric_limits<double>::max(), upper = 0;

    void
    add(const double value);
    bool
    is_empty() const;
    void
    widen(const double factor);
  };

  /// The beginning of a script: `study` says which one wrote it. Sizes in pixels.
  void
  write_terminal(const std::string &study,
                 const std::string &stem,
                 const double       width,
                 const double       height,
                 std::ostream      &out);

  /// Runs STEM.gp in `folder` for both pictures, and says on `out` what was written there. Returns whether
  /// they could be drawn; a missing gnuplot is no failure.
  bool
  draw(const std::string &folder, const std::string &stem, std::ostream &out);

  /// STEM.svg as draw() has just drawn it, to stand within a page; empty without gnuplot.
  std::string
  drawn_chart(const std::string &folder, const std::string &stem);

  /// As a word of a shell; in quotes where it has to be.
  std::string
  in_shell(const std::string &text);

  /// Writes the script to STEM.gp first.
  bool
  draw(const std::string &folder, const std::string &stem, const std::string &script, std::ostream &out);
} // namespace Amontons

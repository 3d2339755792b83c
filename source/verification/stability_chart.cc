// The maps of a stability study as a gnuplot script.
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/stability_map.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // Cells are equally wide: places along an axis are numbers of values, in between as the logarithm goes,
    // or as the numbers where one is not positive.
    class MapAxis
    {
    public:
      explicit MapAxis(const SweptParameter &parameter)
      {
        for (unsigned int i = 0; i < parameter.values.size(); ++i)
          places.push_back(number_of(parameter, i));
        logarithmic = std::all_of(places.begin(), places.end(), [](const double value) { return value > 0; });
        if (logarithmic)
          for (double &place : places)
            place = std::log(place);
      }

      // NaN where it is outside.
      double
      place_of(const double value) const
      {
        const double v = logarithmic ? std::log(value) : value;
        unsigned int i = 0;
        while (i + 2 < places.size() && v > places[i + 1])
          ++i;
        const double place = i + (v - places[i]) / (places[i + 1] - places[i]);
        return place >= -0.5 && place <= places.size() - 0.5 ? place : std::nan("");
      }

      double
      value_at(const double place) const
      {
        const int    last = static_cast<int>(places.size()) - 2;
        const int    i    = std::max(0, std::min(last, static_cast<int>(std::floor(place))));
        const double v    = places[i] + (place - i) * (places[i + 1] - places[i]);
        return logarithmic ? std::exp(v) : v;
      }

    private:
      std::vector<double> places;
      bool                logarithmic = false;
    };

    void
    write_panel_data(const RunStudy    &study,
                     const MapPanel    &panel,
                     const unsigned int number,
                     std::ostream      &out)
    {
      out << "$panel_" << number << " << END\n";
      for (unsigned int y = 0; y < panel.cells.size(); ++y)
        for (unsigned int x = 0; x < panel.cells[y].size(); ++x)
          if (const StudyResult *const cell = panel.cells[y][x])
            {
              const auto  outcome = outcome_of(study, *cell);
              const auto &style   = outcome_styles[static_cast<unsigned int>(outcome)];
              const bool  dark =
                  outcome == Outcome::wrong || outcome == Outcome::crash || outcome == Outcome::time_limit;
              out << x << ' ' << y << " 0x" << style.colour + 1 << ' ' << cell_text(study, *cell) << ' '
                  << (dark ? "0xffffff" : "0x404040") << '\n';
            }
      out << "END\n";
    }

    void
    write_thresholds(const RunStudy &study, std::ostream &out)
    {
      for (unsigned int i = 0; i < study.thresholds.size(); ++i)
        {
          const MapAxis      x(study.sweep[0]), y(study.sweep[1]);
          const unsigned int n = 50 * study.sweep[0].values.size();
          out << "$threshold_" << i << " << END\n";
          for (unsigned int k = 0; k <= n; ++k)
            {
              const double at = -0.5 + study.sweep[0].values.size() * static_cast<double>(k) / n;
              const double height =
                  y.place_of(study.thresholds[i].y.value(dealii::Point<3>(x.value_at(at), 0, 0), 0));
              if (std::isfinite(height))
                out << at << ' ' << height << '\n';
              else
                out << '\n';
            }
          out << "END\n";
        }
    }

    void
    write_ticks(const std::string &axis, const std::vector<std::string> &values, std::ostream &out)
    {
      out << "set " << axis << "range [-0.5:" << values.size() - 0.5 << "]\nset " << axis << "tics (";
      for (unsigned int i = 0; i < values.size(); ++i)
        out << (i == 0 ? "" : ", ") << in_gnuplot(values[i]) << ' ' << i;
      out << ")\n";
    }

    void
    write_map(const RunStudy &study, const MapPanel &panel, const unsigned int number, std::ostream &out)
    {
      const bool is_line = study.sweep.size() < 2;
      out << "set title " << in_gnuplot(panel.title)
          << (panel.title.rfind("Amontons", 0) == 0 ? " font ':Bold'" : " font ':Normal'")
          << " noenhanced\nset xlabel " << in_gnuplot(study.sweep[0].label) << " noenhanced\nset ylabel "
          << in_gnuplot(is_line ? "" : study.sweep[1].label) << " noenhanced\n";
      write_ticks("x", study.sweep[0].values, out);
      write_ticks("y", is_line ? std::vector<std::string>{""} : study.sweep[1].values, out);
      out << "plot $panel_" << number
          << " using 1:2:(0.5):(0.5):3 with boxxyerror fs solid border lc rgb 'white' lc rgb variable "
             "notitle, "
             "\\\n     $panel_"
          << number << " using 1:2:4:5 with labels font ',8' tc rgb variable notitle";
      for (unsigned int i = 0; i < study.thresholds.size(); ++i)
        out << ", \\\n     $threshold_" << i << " using 1:2 with lines lw 3 dt " << i + 1
            << " lc rgb '#000000' notitle";
      out << "\n\n";
    }

    // So that neither the values along the axis nor its name run into others.
    double
    panel_width(const SweptParameter &x)
    {
      std::size_t longest = 3;
      for (const std::string &value : x.values)
        longest = std::max(longest, value.size());
      return std::max(
          {300., 100. + std::max(36., 11. * longest + 4) * x.values.size(), 80. + 8. * x.label.size()});
    }

    void
    write_legend(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
    {
      std::array<unsigned int, 7> number = {};
      for (const StudyResult &result : results)
        ++number[static_cast<unsigned int>(outcome_of(study, result))];
      out << "unset title\nunset border\nunset tics\nunset xlabel\nunset ylabel\nset lmargin 0\nset rmargin "
             "0\nset tmargin 0\nset bmargin 0\nset key center center horizontal Left reverse noenhanced "
             "samplen 1.5 width 1\nset xrange [0:1]\nset yrange [0:1]\nplot ";
      std::string separator;
      for (unsigned int i = 0; i < number.size(); ++i)
        if (number[i] > 0)
          {
            out << separator << "NaN with boxes fs solid noborder lc rgb '" << outcome_styles[i].colour
                << "' title '" << outcome_styles[i].letter << ' ' << outcome_styles[i].name << " ("
                << number[i] << ")'";
            separator = ", \\\n     ";
          }
      for (unsigned int i = 0; i < study.thresholds.size(); ++i)
        {
          out << separator << "NaN with lines lw 3 dt " << i + 1 << " lc rgb '#000000' title "
              << in_gnuplot(study.thresholds[i].label);
          separator = ", \\\n     ";
        }
      out << '\n';
    }
  } // namespace

  std::string
  cell_text(const RunStudy &study, const StudyResult &result)
  {
    const Outcome      outcome = outcome_of(study, result);
    std::ostringstream text;
    if (outcome == Outcome::solved || outcome == Outcome::cut_back)
      text << result.record.iterations;
    else if (const double error =
                 result.errors.empty() ? 0 : *std::max_element(result.errors.begin(), result.errors.end());
             outcome == Outcome::wrong && error > study.wrong_above)
      text << std::setprecision(error < 1 ? 2 : 3) << (error > 1e3 ? error : 100 * error)
           << (error > 1e3 ? "" : "%");
    else
      text << outcome_styles[static_cast<unsigned int>(outcome)].letter;
    return text.str();
  }

  // Panels side by side under the title and over the legend.
  void
  write_map_script(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
  {
    const auto         panels = map_panels(study, results);
    const double       wide = panel_width(study.sweep[0]), high = 110. + 26 * panels[0].cells.size();
    const unsigned int most      = wide * 4 < 1500 ? 4 : panels.size() == 4 ? 2 : 3;
    const unsigned int n_columns = std::min<std::size_t>(panels.size(), most),
                       n_rows    = (panels.size() + n_columns - 1) / n_columns;
    const double canvas = std::max(560., wide * n_columns), top = 44, legend = 64,
                 height = top + legend + high * n_rows;
    out << std::setprecision(8);
    write_terminal(study.file, study.stem(), canvas, height, out);
    for (unsigned int i = 0; i < panels.size(); ++i)
      write_panel_data(study, panels[i], i, out);
    write_thresholds(study, out);
    out << "set multiplot\nset border 0\nset tics scale 0 nomirror textcolor rgb '#303030'\nunset key\n"
        << "set label 1 " << in_gnuplot(study.title) << " at screen 0.5, screen " << 1 - top / 2 / height
        << " center noenhanced font ',15'\n"
        << "set label 2 'in the cells: iterations, or the error where it is wrong' at screen 0.5, screen "
        << 10 / height << " center font ',9' tc rgb '#606060'\n";
    for (unsigned int i = 0; i < panels.size(); ++i)
      {
        const unsigned int row = i / n_columns, column = i % n_columns;
        out << "set size " << wide / canvas << ", " << high / height << "\nset origin "
            << (column * wide + (canvas - wide * n_columns) / 2) / canvas << ", "
            << (legend + high * (n_rows - 1 - row)) / height << '\n';
        write_map(study, panels[i], i, out);
        if (i == 0)
          out << "unset label\n";
      }
    out << "set size 1, " << (legend - 20) / height << "\nset origin 0, " << 20 / height << '\n';
    write_legend(study, results, out);
    out << "unset multiplot\n";
  }
} // namespace Amontons

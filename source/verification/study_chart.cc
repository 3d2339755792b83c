// The chart of a study as a gnuplot script: colours tell series apart, line types and marks the quantities.
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/study_output.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

namespace Amontons
{
  namespace
  {
    struct Panel
    {
      unsigned int column;
      std::string  label;
      bool         counts; // cells or DoFs: orders are shown as guides
    };

    // Cells, DoFs, and the first column of seconds.
    std::vector<Panel>
    panels_of(const Study &study)
    {
      std::vector<Panel> panels;
      for (const std::string wanted : {"cells", "dofs", "seconds"})
        for (unsigned int c = 0; c < study.columns.size(); ++c)
          if (study.columns[c].label == wanted ||
              (wanted == "seconds" && study.columns[c].label.find(wanted) != std::string::npos))
            {
              panels.push_back({c, wanted == "dofs" ? "degrees of freedom" : wanted, wanted != "seconds"});
              break;
            }
      return panels;
    }

    // Grey lines of orders 1 and 2 from the upper left corner of the data, to where they leave it.
    void
    write_guides(const LogRange &x, const LogRange &y, const unsigned int dim, std::ostream &out)
    {
      for (const unsigned int order : {1, 2})
        {
          const double slope = double(order) / dim, start = 3 * y.upper;
          const double x_end = std::min(x.upper, x.lower * std::pow(start / y.lower, 1 / slope));
          const double y_end = start * std::pow(x_end / x.lower, -slope);
          out << "set arrow from first " << x.lower << ", first " << start << " to first " << x_end
              << ", first " << y_end << " nohead back lw 1 dt (6, 4) lc rgb '#a0a0a0'\n";
        }
    }

    void
    write_data(const Study &study, const std::vector<StudySeries> &all_series, std::ostream &out)
    {
      for (unsigned int s = 0; s < all_series.size(); ++s)
        {
          out << "$series_" << s << " << END\n#";
          for (const SummaryPath &column : study.columns)
            out << ' ' << column.label;
          for (const SummaryPath &quantity : study.quantities)
            out << ' ' << quantity.label;
          out << '\n';
          for (const StudyRow &row : all_series[s].rows)
            {
              for (const auto &numbers : {row.columns, row.errors})
                for (const double value : numbers)
                  if (value != 0 && std::isfinite(value))
                    out << std::abs(value) << ' ';
                  else
                    out << "NaN "; // no place on a logarithmic axis
              out << '\n';
            }
          out << "END\n";
        }
    }

    std::string
    label_of(const Study &study, const StudySeries &series, const unsigned int quantity)
    {
      return study.quantities[quantity].label + (series.label.empty() ? "" : ", " + series.label);
    }

    // "plot" with one curve for each series and quantity; for the legend (column < 0), without data.
    void
    write_curves(const Study                    &study,
                 const std::vector<StudySeries> &all_series,
                 const int                       column,
                 std::ostream                   &out)
    {
      static const std::vector<std::string> colours = {
          "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
      static const std::vector<unsigned int> marks     = {7, 5, 9, 13, 11, 6, 4};
      std::string                            separator = "plot ";
      for (unsigned int s = 0; s < all_series.size(); ++s)
        for (unsigned int q = 0; q < study.quantities.size(); ++q)
          {
            out << separator;
            if (column < 0)
              out << "NaN";
            else
              out << "$series_" << s << " using " << column + 1 << ":" << study.columns.size() + q + 1;
            out << " with linespoints lw 1.8 ps 0.7 dt " << q + 1 << " pt " << marks[q % marks.size()]
                << " lc rgb '" << colours[s % colours.size()] << "' "
                << (column < 0 ? "title " + in_gnuplot(label_of(study, all_series[s], q)) : "notitle");
            separator = ", \\\n     ";
          }
      if (column < 0)
        out << separator << "NaN with lines lw 1 dt (6, 4) lc rgb '#a0a0a0' title 'orders 1 and 2 in h'";
      out << "\n";
    }

    void
    write_panel(const Study                    &study,
                const std::vector<StudySeries> &all_series,
                const Panel                    &panel,
                std::ostream                   &out)
    {
      LogRange     x, y;
      unsigned int dim = 2;
      for (const StudySeries &series : all_series)
        for (const StudyRow &row : series.rows)
          {
            dim = series.dim;
            x.add(row.columns[panel.column]);
            for (const double error : row.errors)
              y.add(std::abs(error));
          }
      out << "unset arrow\nunset label\nset xlabel " << in_gnuplot(panel.label) << "\n";
      if (x.is_empty() || y.is_empty())
        {
          out << "set xrange [1:10]\nset yrange [1:10]\nset label 'no data' at graph 0.5, graph 0.5 "
                 "center\nplot NaN notitle\n";
          return;
        }
      if (panel.counts)
        write_guides(x, y, dim, out);
      x.widen(1.5);
      y.widen(4);
      out << "set xrange [" << x.lower << ":" << x.upper << "]\nset yrange [" << y.lower << ":" << y.upper
          << "]\n";
      write_curves(study, all_series, panel.column, out);
    }
  } // namespace

  // The panels side by side over a strip with the legend.
  void
  write_gnuplot_script(const Study                    &study,
                       const std::vector<StudySeries> &all_series,
                       const std::string              &stem,
                       std::ostream                   &out)
  {
    const std::vector<Panel> panels  = panels_of(study);
    const double             canvas  = 420 * panels.size();
    std::size_t              longest = 20; // of the guides
    for (const StudySeries &series : all_series)
      for (unsigned int q = 0; q < study.quantities.size(); ++q)
        longest = std::max(longest, label_of(study, series, q).size());
    const unsigned int n_labels  = all_series.size() * study.quantities.size() + 1;
    const unsigned int n_columns = std::max(1., canvas / (7 * longest + 90));
    const unsigned int n_rows    = (n_labels + n_columns - 1) / n_columns;
    const double       height = 400 + 24. * n_rows, legend = (24. * n_rows + 12) / height;
    const double       top = 36 / height, width = 1. / panels.size();

    out << std::setprecision(8);
    write_terminal(study.file, stem, canvas, height, out);
    write_data(study, all_series, out);
    out << "set multiplot\nset logscale xy\nset format xy '10^{%L}'\nset mxtics 1\nset mytics 1\n"
        << "set border 3 lw 1 lc rgb '#606060'\nset tics nomirror textcolor rgb '#303030'\n";
    bool first = true;
    for (const Panel &panel : panels)
      {
        out << "\nset size " << width << ", " << 1 - legend - top << "\nset origin "
            << (&panel - panels.data()) * width << ", " << legend << "\nset ylabel "
            << (first ? "'error'" : "''") << "\n";
        write_panel(study, all_series, panel, out);
        first = false;
      }
    out << "\nunset arrow\nunset label\nset label 1 " << in_gnuplot(study.title) << " at screen 0.5, screen "
        << 1 - top / 2 << " center noenhanced font ', 16'\nset size 1, " << legend
        << "\nset origin 0, 0\nunset border\nunset tics\nunset xlabel\nunset ylabel\n"
        << "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
        << "set key center center Left reverse noenhanced maxrows " << n_rows << " samplen 3 width "
        << -0.2 * longest << "\n"
        << "set xrange [1:10]\nset yrange [1:10]\n";
    write_curves(study, all_series, -1, out);
    out << "unset multiplot\n";
  }
} // namespace Amontons

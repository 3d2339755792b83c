// The chart of a work-precision study as a gnuplot script.
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/work_precision.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // Ticks at 1, 2 and 5 where there is less than a decade and a half.
    void
    write_axis(const std::string &axis, LogRange range, const double margin, std::ostream &out)
    {
      if (range.is_empty())
        range = {0.1, 10};
      else
        range.widen(margin);
      out << "set " << axis << "range [" << range.lower << ":" << range.upper << "]\n";
      if (range.upper / range.lower > 25)
        {
          out << "set " << axis << "tics autofreq\nset format " << axis << " '10^{%L}'\n";
          return;
        }
      out << "set format " << axis << " '%g'\nset " << axis << "tics (";
      std::string separator;
      for (double decade = std::pow(10., std::floor(std::log10(range.lower))); decade < range.upper;
           decade *= 10)
        for (const double digit : {1., 2., 5.})
          {
            out << separator << digit * decade;
            separator = ", ";
          }
      out << ")\n";
    }

    // Ours is drawn in one strong colour per curve, what it is compared with in thin greyer ones.
    bool
    is_ours(const WorkCurve &curve)
    {
      return curve.label.rfind("Amontons", 0) == 0;
    }

    std::vector<std::string>
    styles(const std::vector<WorkCurve> &curves)
    {
      static const std::vector<std::string> strong  = {"#0058a8", "#00a0c8", "#2e8b57", "#7048b0"},
                                            thin    = {"#d55e00", "#c0a020", "#cc79a7", "#8c564b", "#909090"};
      static const std::vector<unsigned int> marks  = {7, 5, 9, 13, 11};
      unsigned int                           n_ours = 0, n_others = 0;
      std::vector<std::string>               result;
      for (const WorkCurve &curve : curves)
        {
          const bool         ours = is_ours(curve);
          const unsigned int n    = ours ? n_ours++ : n_others++;
          const auto        &all  = ours ? strong : thin;
          result.push_back("with linespoints lw " + std::string(ours ? "2.6 ps 0.9" : "1.4 ps 0.6") + " pt " +
                           std::to_string(marks[n % marks.size()]) + " lc rgb '" + all[n % all.size()] + "'");
        }
      return result;
    }

    void
    write_runs(const std::vector<WorkCurve> &curves, std::ostream &out)
    {
      for (unsigned int c = 0; c < curves.size(); ++c)
        {
          out << "$curve_" << c << " << END\n# processor seconds, dofs, megabytes, solves, errors\n";
          for (const StudyResult *const run : curves[c].runs)
            if (has_answer(*run))
              {
                for (const CostKind &kind : cost_kinds)
                  out << kind.of(run->record) << ' ';
                for (const double error : run->errors)
                  if (error > 0 && std::isfinite(error))
                    out << error << ' ';
                  else
                    out << "NaN ";
                out << '\n';
              }
          out << "END\n";
        }
    }

    // Stairs: what can be had for a cost.
    void
    write_front(const std::vector<StudyResult> &results,
                const unsigned int              quantity,
                const unsigned int              kind,
                std::ostream                   &out)
    {
      std::vector<CostAndError> runs;
      for (const StudyResult &result : results)
        if (has_answer(result))
          runs.push_back({cost_kinds[kind].of(result.record), result.errors[quantity]});
      out << "$front_" << quantity << '_' << kind << " << END\n";
      for (const unsigned int i : pareto_front(runs))
        out << runs[i].cost << ' ' << runs[i].error << '\n';
      out << "END\n";
    }

    void
    write_work_panel(const RunStudy               &study,
                     const std::vector<WorkCurve> &curves,
                     const unsigned int            quantity,
                     const unsigned int            kind,
                     std::ostream                 &out)
    {
      LogRange x, y;
      for (const WorkCurve &curve : curves)
        for (const StudyResult *const run : curve.runs)
          if (has_answer(*run))
            {
              x.add(cost_kinds[kind].of(run->record));
              y.add(run->errors[quantity]);
            }
      for (const double target : study.targets)
        y.add(target);
      write_axis("x", x, 1.3, out);
      write_axis("y", y, 1.6, out);
      const auto all = styles(curves);
      out << "set xlabel '" << cost_kinds[kind].name << "'\nset ylabel "
          << (kind == 0 ? in_gnuplot("error of " + study.quantities[quantity].path.label) : "''")
          << " noenhanced\nplot $front_" << quantity << '_' << kind
          << " using 1:2 with fsteps lw 7 lc rgb '#e4e4d0' notitle";
      for (const double target : study.targets)
        out << ", \\\n     " << target << " with lines lw 1.2 dt (5, 4) lc rgb '#909090' notitle";
      for (unsigned int c = 0; c < curves.size(); ++c)
        out << ", \\\n     $curve_" << c << " using " << kind + 1 << ':' << cost_kinds.size() + quantity + 1
            << ' ' << all[c] << " notitle";
      out << "\n\n";
    }

    // Rows of a legend of so many columns as there is room for.
    unsigned int
    legend_rows(const std::vector<WorkCurve> &curves, const double width)
    {
      std::size_t longest = 20;
      for (const WorkCurve &curve : curves)
        longest = std::max(longest, curve.label.size());
      const unsigned int n = curves.size() + 2, n_columns = std::max(1., width / (8.5 * longest + 110));
      return (n + n_columns - 1) / n_columns;
    }

    void
    write_work_legend(const RunStudy               &study,
                      const std::vector<WorkCurve> &curves,
                      const unsigned int            n_rows,
                      std::ostream                 &out)
    {
      out << "unset logscale\nunset border\nunset tics\nunset xlabel\nunset ylabel\nset lmargin 0\nset "
             "rmargin 0\nset tmargin 0\nset bmargin 0\nset key center center Left reverse noenhanced "
             "samplen 3 maxrows "
          << n_rows << " width 2\nset xrange [0:1]\nset yrange [0:1]\nplot ";
      const auto all = styles(curves);
      for (unsigned int c = 0; c < curves.size(); ++c)
        out << "NaN " << all[c] << " title "
            << in_gnuplot(curves[c].label.empty() ? study.title : curves[c].label) << ", \\\n     ";
      out << "NaN with lines lw 7 lc rgb '#e4e4d0' title 'Pareto front of all'";
      if (!study.targets.empty())
        out << ", \\\n     NaN with lines lw 1.2 dt (5, 4) lc rgb '#909090' title 'targets'";
      out << '\n';
    }
  } // namespace

  void
  write_work_script(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
  {
    const auto         curves = work_curves(study, results);
    const double       n_rows = study.quantities.size(), n_columns = cost_kinds.size();
    const double       wide = 300, high = 280, top = 44, canvas = wide * n_columns;
    const unsigned int n_legend = legend_rows(curves, canvas);
    const double       legend = 22. * n_legend + 12, height = top + legend + high * n_rows;
    out << std::setprecision(8);
    write_terminal(study.file, study.stem(), canvas, height, out);
    write_runs(curves, out);
    for (unsigned int q = 0; q < study.quantities.size(); ++q)
      for (unsigned int k = 0; k < cost_kinds.size(); ++k)
        write_front(results, q, k, out);
    out << "set multiplot\nset logscale xy\nset mxtics 1\nset mytics 1\n"
        << "set border 3 lw 1 lc rgb '#606060'\nset tics nomirror textcolor rgb '#303030'\nunset key\n"
        << "set label 1 " << in_gnuplot(study.title) << " at screen 0.5, screen " << 1 - top / 2 / height
        << " center noenhanced font ',15'\n";
    for (unsigned int q = 0; q < study.quantities.size(); ++q)
      for (unsigned int k = 0; k < cost_kinds.size(); ++k)
        {
          out << "set size " << wide / canvas << ", " << high / height << "\nset origin " << k * wide / canvas
              << ", " << (legend + high * (n_rows - 1 - q)) / height << '\n';
          write_work_panel(study, curves, q, k, out);
          out << "unset label\n";
        }
    out << "set size 1, " << legend / height << "\nset origin 0, 0\n";
    write_work_legend(study, curves, n_legend, out);
    out << "unset multiplot\n";
  }
} // namespace Amontons

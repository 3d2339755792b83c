#include <amontons/verification/gnuplot.h>
#include <amontons/verification/stability_map.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace Amontons
{
  const std::array<OutcomeStyle, 7> outcome_styles = {
      {{Outcome::solved, '+', "solved", "#9fd8b4"},
       {Outcome::cut_back, 'c', "solved, cut back", "#e9dd7f"},
       {Outcome::refused, 'r', "refused with reason", "#b9c8e4"},
       {Outcome::failed, 'f', "failed", "#f0a35e"},
       {Outcome::wrong, 'W', "wrong", "#d7263d"},
       {Outcome::time_limit, 'T', "time limit", "#8a6fb0"},
       {Outcome::crash, 'X', "crash", "#303030"}}};

  namespace
  {
    const OutcomeStyle &
    style_of(const RunStudy &study, const StudyResult &result)
    {
      return outcome_styles[static_cast<unsigned int>(outcome_of(study, result))];
    }

    bool
    names_a_reason(const std::string &failure)
    {
      static const std::vector<std::string> reasons = {
          "moves apart", "friction beyond limit", "friction exceeded", "friction slides", "small strain"};
      return std::find(reasons.begin(), reasons.end(), failure) != reasons.end();
    }

    std::array<unsigned int, 7>
    count_outcomes(const RunStudy &study, const MapPanel &panel)
    {
      std::array<unsigned int, 7> result = {};
      for (const auto &row : panel.cells)
        for (const StudyResult *const cell : row)
          if (cell != nullptr)
            ++result[static_cast<unsigned int>(outcome_of(study, *cell))];
      return result;
    }

    std::size_t
    longest(const std::vector<std::string> &texts)
    {
      std::size_t result = 0;
      for (const std::string &text : texts)
        result = std::max(result, text.size());
      return result;
    }

    void
    print_panel(const RunStudy &study, const MapPanel &panel, std::ostream &out)
    {
      const SweptParameter    &x       = study.sweep[0];
      const bool               is_line = study.sweep.size() < 2;
      std::vector<std::string> names   = is_line ? std::vector<std::string>{""} : study.sweep[1].values;
      if (!is_line)
        names.push_back(study.sweep[1].label);
      const int left = longest(names) + 2, width = longest(x.values) + 2;
      out << '\n' << panel.title << (panel.title.empty() ? "" : "\n");
      if (!is_line)
        out << std::setw(left) << study.sweep[1].label << '\n';
      for (unsigned int row = panel.cells.size(); row-- > 0;)
        {
          out << std::setw(left) << names[row] << " |";
          for (const StudyResult *const cell : panel.cells[row])
            out << std::setw(width) << (cell == nullptr ? ' ' : style_of(study, *cell).letter);
          out << '\n';
        }
      out << std::string(left + 1, ' ') << '+' << std::string(width * x.values.size(), '-') << '\n'
          << std::string(left + 2, ' ');
      for (const std::string &value : x.values)
        out << std::setw(width) << value;
      out << "   " << x.label << '\n' << std::string(left + 2, ' ');
      const auto number = count_outcomes(study, panel);
      for (unsigned int i = 0; i < number.size(); ++i)
        if (number[i] > 0)
          out << "  " << outcome_styles[i].letter << ' ' << outcome_styles[i].name << ' ' << number[i];
      out << '\n';
    }

    double
    largest_error(const StudyResult &result)
    {
      double largest = 0;
      for (const double error : result.errors)
        largest = std::isfinite(error) ? std::max(largest, error) : std::numeric_limits<double>::max();
      return largest;
    }

    // Of each series the worst point that is wrong, and a crash, with commands.
    void
    print_worst(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
    {
      for (const Outcome outcome : {Outcome::wrong, Outcome::crash})
        for (unsigned int series = 0; series < study.series.size(); ++series)
          {
            const StudyResult *worst = nullptr;
            unsigned int       n     = 0;
            for (const StudyResult &result : results)
              if (result.point.series == series && outcome_of(study, result) == outcome && ++n > 0 &&
                  (worst == nullptr || largest_error(result) > largest_error(*worst)))
                worst = &result;
            if (worst == nullptr)
              continue;
            const std::string &name = study.series[series].name;
            out << '\n'
                << name << (name.empty() ? "" : ": ") << n << ' ' << style_of(study, *worst).name
                << ", the worst: "
                << (outcome == Outcome::wrong ? what_is_off(study, *worst) : worst->record.message)
                << "\n    amontons " << study.scene;
            for (const std::string &text : overrides_of(study, worst->point))
              out << " --set \"" << text << '"';
            out << '\n';
          }
    }
  } // namespace

  std::string
  what_is_off(const RunStudy &study, const StudyResult &result)
  {
    std::ostringstream text;
    text << std::setprecision(3);
    for (unsigned int q = 0; q < result.errors.size(); ++q)
      if (!(result.errors[q] <= study.wrong_above))
        text << "; " << study.quantities[q].path.path << " is off by " << result.errors[q];
    if (study.no_solution_where && evaluate(*study.no_solution_where, study, result.point) > 0)
      text << "; there is no solution";
    return text.str().empty() ? "" : text.str().substr(2);
  }

  Outcome
  outcome_of(const RunStudy &study, const StudyResult &result)
  {
    const std::string &ending = result.record.ending;
    if (ending == "time limit")
      return Outcome::time_limit;
    if (ending == "refused")
      return Outcome::refused;
    const double none = study.no_solution_where ? evaluate(*study.no_solution_where, study, result.point) : 0;
    if (ending == "not converged")
      return names_a_reason(result.record.failure) && !(none < 0) ? Outcome::refused : Outcome::failed;
    if (ending != "converged")
      return Outcome::crash;
    const auto is_small = [&](const double error) { return error <= study.wrong_above; };
    if (none > 0 || !std::all_of(result.errors.begin(), result.errors.end(), is_small))
      return Outcome::wrong;
    return result.record.cut_backs > 0 ? Outcome::cut_back : Outcome::solved;
  }

  std::vector<MapPanel>
  map_panels(const RunStudy &study, const std::vector<StudyResult> &results)
  {
    const unsigned int n_x = study.sweep[0].values.size(),
                       n_y = study.sweep.size() > 1 ? study.sweep[1].values.size() : 1,
                       n_z = study.sweep.size() > 2 ? study.sweep[2].values.size() : 1;
    std::vector<MapPanel> panels;
    for (const NamedSeries &series : study.series)
      for (unsigned int z = 0; z < n_z; ++z)
        {
          MapPanel panel;
          panel.title = series.name;
          if (n_z > 1)
            panel.title +=
                (panel.title.empty() ? "" : ", ") + study.sweep[2].label + " = " + study.sweep[2].values[z];
          panel.cells.assign(n_y, std::vector<const StudyResult *>(n_x, nullptr));
          panels.push_back(panel);
        }
    for (const StudyResult &result : results)
      {
        const auto values = [&](const unsigned int i) {
          return i < result.point.values.size() ? result.point.values[i] : 0;
        };
        panels[result.point.series * n_z + values(2)].cells[values(1)][values(0)] = &result;
      }
    return panels;
  }

  void
  print_maps(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
  {
    out << '\n' << study.title << '\n' << std::string(study.title.size(), '=') << '\n';
    out << (study.quantities.empty() ? "Solved: converged, and compared with nothing.\n" : "");
    for (const MapPanel &panel : map_panels(study, results))
      print_panel(study, panel, out);
    print_worst(study, results, out);
    double seconds = 0;
    for (const StudyResult &result : results)
      seconds += result.record.wall_seconds;
    out << '\n'
        << results.size() << " runs, " << std::setprecision(3) << seconds / results.size()
        << " s each, one after another " << duration(seconds) << ".\n"
        << std::endl;
  }

  bool
  show_stability_map(const RunStudy &study, const std::vector<StudyResult> &results, std::ostream &out)
  {
    print_maps(study, results, out);
    std::ostringstream script;
    write_map_script(study, results, script);
    return draw(study.output_directory, study.stem(), script.str(), out);
  }
} // namespace Amontons

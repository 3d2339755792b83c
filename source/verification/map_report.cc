// Of a stability study: grids as tables, and what is wrong or failed.
#include <amontons/output/svg_chart.h>
#include <amontons/verification/study_report.h>

namespace Amontons
{
  namespace
  {
    std::string
    cell_html(const RunStudy &study, const StudyResult *const result)
    {
      if (result == nullptr)
        return "<td></td>";
      const Outcome outcome = outcome_of(study, *result);
      const auto   &style   = outcome_styles[static_cast<unsigned int>(outcome)];
      const bool    dark =
          outcome == Outcome::wrong || outcome == Outcome::crash || outcome == Outcome::time_limit;
      std::string said = style.name;
      for (const std::string &text : {what_is_off(study, *result), result->record.message})
        said += text.empty() ? "" : ": " + text;
      return "<td style=\"background:" + std::string(style.colour) + (dark ? ";color:#fff" : "") +
             "\" title=\"" + escaped(said) + "\">" + escaped(cell_text(study, *result)) + "</td>";
    }

    // The largest y above, the values of x below.
    std::string
    panel_html(const RunStudy &study, const MapPanel &panel)
    {
      const SweptParameter &x       = study.sweep[0];
      const bool            is_line = study.sweep.size() < 2;
      std::string           html    = "<div>\n";
      if (!panel.title.empty())
        html += "<p><b>" + escaped(panel.title) + "</b></p>\n";
      html += "<table class=\"map\">\n";
      for (std::size_t row = panel.cells.size(); row-- > 0;)
        {
          html += "<tr>";
          if (!is_line)
            html += "<th class=\"y\">" + escaped(study.sweep[1].values[row]) + "</th>";
          for (const StudyResult *const cell : panel.cells[row])
            html += cell_html(study, cell);
          html += "</tr>\n";
        }
      html += is_line ? "<tr>" : "<tr><th></th>";
      for (const std::string &value : x.values)
        html += "<th>" + escaped(value) + "</th>";
      html += is_line ? "</tr>\n<tr>" : "</tr>\n<tr><th></th>";
      html += "<th colspan=\"" + std::to_string(x.values.size()) + "\">" + escaped(x.label) + "</th>";
      return html + "</tr></table>\n</div>\n";
    }

    std::string
    legend_html(const RunStudy &study, const std::vector<StudyResult> &results)
    {
      std::array<unsigned int, 7> number = {};
      for (const StudyResult &result : results)
        ++number[static_cast<unsigned int>(outcome_of(study, result))];
      std::string html = "<p>";
      for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] > 0)
          html += "<span class=\"swatch\" style=\"background:" + std::string(outcome_styles[i].colour) +
                  "\"></span>" + escaped(outcome_styles[i].name) + " (" + std::to_string(number[i]) + ")";
      return html + "</p>\n<p class=\"sub\">" +
             (study.sweep.size() < 2 ? "" : "Upwards: " + escaped(study.sweep[1].label) + ". ") +
             "In the cells: iterations, or the error where it is wrong; the pointer over a cell shows what "
             "its run "
             "says.</p>\n";
    }

    std::string
    failures_html(const RunStudy &study, const std::vector<StudyResult> &results)
    {
      std::string  html;
      unsigned int n = 0;
      for (const StudyResult &result : results)
        if (const Outcome outcome = outcome_of(study, result); outcome > Outcome::refused)
          {
            ++n;
            html += "<p><b>" + escaped(name_of(study, result.point)) +
                    "</b>: " + outcome_styles[static_cast<unsigned int>(outcome)].name;
            for (const std::string &text : {what_is_off(study, result), result.record.message})
              html += text.empty() ? "" : "; " + escaped(text);
            html += "</p>\n<pre>" + escaped(command_of(study.scene, overrides_of(study, result.point))) +
                    "</pre>\n";
          }
      return n > 4 ? html_details(std::to_string(n) + " runs, with the commands that show it", html) : html;
    }
  } // namespace

  std::string
  maps_as_html(const RunStudy &study, const std::vector<StudyResult> &results)
  {
    std::string maps;
    for (const MapPanel &panel : map_panels(study, results))
      maps += panel_html(study, panel);
    return html_section("Map",
                        legend_html(study, results) + "<div class=\"pictures\">\n" + maps + "</div>\n") +
           html_section("Wrong or failed", failures_html(study, results));
  }
} // namespace Amontons

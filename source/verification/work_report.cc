// Of a work-precision study: charts of error against cost, and the cheapest runs.
#include <amontons/output/svg_chart.h>
#include <amontons/output/terminal.h>
#include <amontons/verification/study_report.h>
#include <amontons/verification/work_precision.h>

namespace Amontons
{
  std::string
  targets_as_html(const RunStudy &study, const std::vector<StudyResult> &results)
  {
    std::string html;
    for (std::size_t q = 0; q < study.quantities.size() && !study.targets.empty(); ++q)
      {
        HtmlRow head = {"error of " + study.quantities[q].path.label};
        for (const double target : study.targets)
          head.push_back("at most " + short_number(target));
        std::vector<HtmlRow> rows;
        for (const WorkCurve &curve : work_curves(study, results))
          {
            rows.push_back({curve.label.empty() ? study.title : curve.label});
            for (const double target : study.targets)
              {
                const StudyResult *const run = cheapest(curve, q, target);
                rows.back().push_back(run == nullptr ? "not reached"
                                                     : short_number(run->record.processor_seconds) + " s, " +
                                                           std::to_string(run->record.dofs) + " DoFs");
              }
          }
        html += html_table(head, rows);
      }
    return html_section("The cheapest run of each", html);
  }

  std::vector<std::string>
  work_charts(const RunStudy &study, const std::vector<StudyResult> &results)
  {
    std::vector<std::string> svgs;
    for (std::size_t q = 0; q < study.quantities.size(); ++q)
      for (const CostKind &kind : cost_kinds)
        {
          Chart chart;
          chart.title   = "Error of " + study.quantities[q].path.label + " by " + kind.name;
          chart.x_label = kind.name;
          chart.y_label = "error";
          chart.log_x = chart.log_y = true;
          for (const WorkCurve &curve : work_curves(study, results))
            {
              Curve drawn{curve.label, {}, {}, true, true};
              for (const StudyResult *const run : curve.runs)
                if (has_answer(*run))
                  {
                    drawn.x.push_back(kind.of(run->record));
                    drawn.y.push_back(run->errors[q]);
                  }
              if (!drawn.x.empty())
                chart.curves.push_back(drawn);
            }
          if (!chart.curves.empty())
            svgs.push_back(svg_chart(chart));
        }
    return svgs;
  }
} // namespace Amontons

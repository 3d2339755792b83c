#include <amontons/output/files.h>
#include <amontons/output/svg_chart.h>
#include <amontons/output/terminal.h>
#include <amontons/scene/text.h>
#include <amontons/verification/gnuplot.h>
#include <amontons/verification/study_report.h>
#include <amontons/verification/work_precision.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace Amontons
{
  namespace
  {
    using Pairs = std::vector<std::pair<std::string, std::string>>;

    std::string
    plural(const std::size_t n, const std::string &one)
    {
      return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
    }

    bool
    write_page(const std::string &folder, const std::string &stem, const std::string &page, std::ostream &out)
    {
      const std::string file = (std::filesystem::path(folder) / (stem + ".html")).string();
      try
        {
          write_file(file, page);
        }
      catch (const std::exception &error)
        {
          out << error.what() << std::endl;
          return false;
        }
      out << "Wrote " << file << ", all of it on one page." << std::endl;
      return true;
    }

    // The chart that gnuplot drew; else the others.
    std::string
    chart_section(const std::string &folder, const std::string &stem, const std::vector<std::string> &others)
    {
      const std::string drawn = drawn_chart(folder, stem);
      return html_section("Chart", html_pictures(drawn.empty() ? others : std::vector<std::string>{drawn}));
    }

    // ---- convergence

    std::string
    table_of(const Study &study, const StudySeries &series)
    {
      HtmlRow     head = {varied_name(study)};
      std::size_t dofs = 0;
      for (std::size_t c = 0; c < study.columns.size(); ++c)
        {
          head.push_back(study.columns[c].label);
          if (study.columns[c].label == "dofs")
            dofs = c;
        }
      for (const SummaryPath &quantity : study.quantities)
        head.insert(head.end(), {quantity.label, "order"});
      std::vector<HtmlRow> rows;
      for (std::size_t r = 0; r < series.rows.size(); ++r)
        {
          const StudyRow &here = series.rows[r], &before = series.rows[r > 0 ? r - 1 : 0];
          rows.push_back({here.varied});
          for (const double value : here.columns)
            rows.back().push_back(value == std::round(value) && std::abs(value) < 1e15
                                      ? std::to_string(static_cast<long long>(value))
                                      : short_number(value));
          for (std::size_t q = 0; q < here.errors.size(); ++q)
            {
              const double order = observed_order(
                  before.errors[q], here.errors[q], before.columns[dofs], here.columns[dofs], series.dim);
              rows.back().push_back(short_number(here.errors[q]));
              rows.back().push_back(std::isfinite(order) ? short_number(std::round(100 * order) / 100) : "");
            }
        }
      return (series.label.empty() ? "" : "<p><b>" + escaped(series.label) + "</b></p>\n") +
             (rows.empty() ? "<p>no rows</p>\n" : html_table(head, rows));
    }

    std::string
    failures_of(const Study &study, const std::vector<StudySeries> &all_series)
    {
      std::string html;
      for (const StudySeries &series : all_series)
        for (const FailedRun &run : series.failures)
          html += "<p><b>" +
                  escaped(series.label + (series.label.empty() ? "" : ", ") + varied_name(study) + " = " +
                          run.varied) +
                  "</b>: " + escaped(run.message) + "</p>\n<pre>" +
                  escaped(command_of(study.scene, run.overrides)) + "</pre>\n";
      return html;
    }

    // Errors against the column of this name, if there is one.
    void
    add_chart(const Study                    &study,
              const std::vector<StudySeries> &all_series,
              const std::string              &column,
              std::vector<std::string>       &svgs)
    {
      Chart chart;
      chart.title   = "Errors by " + column;
      chart.x_label = column;
      chart.y_label = "error";
      chart.log_x = chart.log_y = true;
      for (std::size_t c = 0; c < study.columns.size(); ++c)
        if (study.columns[c].label == column)
          for (const StudySeries &series : all_series)
            for (std::size_t q = 0; q < study.quantities.size(); ++q)
              {
                Curve curve{study.quantities[q].label + (series.label.empty() ? "" : ", " + series.label),
                            {},
                            {},
                            true,
                            true};
                for (const StudyRow &row : series.rows)
                  {
                    curve.x.push_back(row.columns[c]);
                    curve.y.push_back(std::abs(row.errors[q]));
                  }
                if (!curve.x.empty())
                  chart.curves.push_back(curve);
              }
      if (!chart.curves.empty())
        svgs.push_back(svg_chart(chart));
    }

    // ---- runs that are processes

    std::string
    quantity_text(const StudyQuantity &quantity)
    {
      return quantity.path.path + (quantity.expected ? " = " + quantity.expected->text() : "");
    }

    Pairs
    facts_of(const RunStudy &study)
    {
      Pairs facts;
      for (const NamedSeries &series : study.series)
        if (!series.name.empty())
          facts.emplace_back("series " + series.name, join(series.overrides, " | "));
      std::vector<std::string> quantities, targets;
      for (const StudyQuantity &quantity : study.quantities)
        quantities.push_back(quantity_text(quantity));
      for (const double target : study.targets)
        targets.push_back(short_number(target));
      if (!quantities.empty())
        facts.emplace_back("quantities", join(quantities, " | "));
      if (!targets.empty())
        facts.emplace_back("targets", join(targets, ", "));
      if (study.kind == StudyKind::stability)
        facts.emplace_back("wrong above", short_number(study.wrong_above));
      if (study.no_solution_where)
        facts.emplace_back("no solution where", study.no_solution_where->text() + " > 0");
      for (const Threshold &threshold : study.thresholds)
        facts.emplace_back("threshold", threshold.label + ": y = " + threshold.y.text());
      facts.emplace_back("time limit", short_number(study.time_limit) + " s of the processor for each run");
      return facts;
    }

    std::string
    outcome_text(const RunStudy &study, const StudyResult &result)
    {
      return study.kind == StudyKind::stability
                 ? outcome_styles[static_cast<unsigned int>(outcome_of(study, result))].name
                 : result.record.ending;
    }

    // A row for each run; many of them on demand.
    std::string
    runs_section(const RunStudy &study, const std::vector<StudyResult> &results)
    {
      HtmlRow head;
      if (study.series.size() > 1 || !study.series[0].name.empty())
        head.emplace_back("series");
      const bool has_series = !head.empty();
      for (const SweptParameter &parameter : study.sweep)
        head.push_back(parameter.label);
      for (const char *const name :
           {"outcome", "increments", "iterations", "solves", "cells", "DoFs", "seconds", "MB"})
        head.emplace_back(name);
      for (const StudyQuantity &quantity : study.quantities)
        head.push_back("error of " + quantity.path.label);
      const bool has_messages = std::any_of(
          results.begin(), results.end(), [](const auto &result) { return !result.record.message.empty(); });
      if (has_messages)
        head.emplace_back("message");
      std::vector<HtmlRow> rows;
      for (const StudyResult &result : results)
        {
          const RunRecord &record = result.record;
          HtmlRow          row    = key_of(study, result.point);
          if (!has_series)
            row.erase(row.begin());
          row.insert(row.end(),
                     {outcome_text(study, result),
                      std::to_string(record.increments),
                      std::to_string(record.iterations),
                      std::to_string(record.linear_solves),
                      std::to_string(record.cells),
                      std::to_string(record.dofs),
                      short_number(record.processor_seconds),
                      short_number(record.megabytes)});
          for (const double error : result.errors)
            row.push_back(short_number(error));
          if (has_messages)
            row.push_back(record.message);
          rows.push_back(row);
        }
      const std::string table = html_table(head, rows);
      return html_section(
          "Runs", rows.size() > 40 ? html_details("All " + plural(rows.size(), "run"), table) : table);
    }

    std::string
    failures_of(const RunStudy &study, const std::vector<StudyResult> &results)
    {
      std::string html;
      for (const StudyResult &result : results)
        if (!has_answer(result))
          html += "<p><b>" + escaped(name_of(study, result.point)) +
                  "</b>: " + escaped(result.record.ending + ": " + result.record.message) + "</p>\n<pre>" +
                  escaped(command_of(study.scene, overrides_of(study, result.point))) + "</pre>\n";
      return html;
    }
  } // namespace

  std::string
  name_of(const RunStudy &study, const StudyPoint &point)
  {
    std::string name = study.series[point.series].name;
    for (std::size_t i = 0; i < study.sweep.size(); ++i)
      name +=
          (name.empty() ? "" : ", ") + study.sweep[i].label + " = " + study.sweep[i].values[point.values[i]];
    return name;
  }

  std::string
  command_of(const std::string &scene, const std::vector<std::string> &overrides)
  {
    std::string text = "amontons " + in_shell(scene);
    for (const std::string &entry : overrides)
      text += " --set " + in_shell(entry);
    return text;
  }

  std::string
  what_was_run(const std::string                 &scene,
               const std::vector<SweptParameter> &sweep,
               const std::vector<std::string>    &overrides,
               const Pairs                       &more,
               const std::string                 &command)
  {
    Pairs rows = {{"scene", scene}};
    for (const SweptParameter &parameter : sweep)
      rows.emplace_back("swept: " + parameter.label,
                        join(parameter.values, ", ") + "   (" + join(parameter.names, " & ") + ")");
    if (!overrides.empty())
      rows.emplace_back("all runs with", join(overrides, " | "));
    rows.insert(rows.end(), more.begin(), more.end());
    std::string html = "<table>";
    for (const auto &[label, text] : rows)
      html += "<tr><td>" + escaped(label) + "</td><td>" + escaped(text) + "</td></tr>\n";
    return html_section("What was run",
                        html + "</table>\n<p>Again:</p>\n<pre>" + escaped(command) + "</pre>\n");
  }

  bool
  write_report(const Study                    &study,
               const std::vector<StudySeries> &all_series,
               const std::string              &command,
               std::ostream                   &out)
  {
    const std::string stem   = std::filesystem::path(study.file).stem().string();
    std::size_t       n_rows = 0, n_failures = 0;
    std::string       tables;
    for (const StudySeries &series : all_series)
      {
        n_rows += series.rows.size();
        n_failures += series.failures.size();
        tables += table_of(study, series);
      }
    std::vector<std::string> quantities;
    for (const SummaryPath &quantity : study.quantities)
      quantities.push_back(quantity.path);
    const Pairs              more = {{"errors", join(quantities, ", ")},
                                     {"against",
                         study.against_finest ? "the last run of each table: relative differences"
                                                           : "the closed form; orders are those in h, from the DoFs"}};
    std::vector<std::string> charts;
    for (const std::string column : {"cells", "dofs", "finest_mesh_seconds", "seconds"})
      add_chart(study, all_series, column, charts);
    const std::string page =
        html_page(study.title,
                  n_failures == 0 ? "all runs converged" : plural(n_failures, "run") + " failed",
                  n_failures == 0,
                  "convergence study &middot; " + escaped(study.file) + " &middot; " + plural(n_rows, "row"),
                  what_was_run(study.scene, study.sweep, study.overrides, more, command) +
                      chart_section(study.output_directory, stem, charts) + html_section("Runs", tables) +
                      html_section("Failed", failures_of(study, all_series)));
    return write_page(study.output_directory, stem, page, out);
  }

  bool
  write_report(const RunStudy                 &study,
               const std::vector<StudyResult> &results,
               const std::string              &command,
               std::ostream                   &out)
  {
    const bool        is_map = study.kind == StudyKind::stability;
    const auto        n_bad  = std::count_if(results.begin(), results.end(), [&](const StudyResult &result) {
      return is_map ? outcome_of(study, result) > Outcome::refused : !has_answer(result);
    });
    const std::string word =
        n_bad == 0 ? (is_map ? "none wrong, none failed" : "all runs converged")
                   : std::to_string(n_bad) + (is_map ? " wrong or failed" : " without an answer");
    const std::string found =
        is_map ? maps_as_html(study, results)
               : chart_section(study.output_directory, study.stem(), work_charts(study, results)) +
                     targets_as_html(study, results);
    const std::string page =
        html_page(study.title,
                  word,
                  n_bad == 0,
                  std::string(is_map ? "stability" : "work precision") + " &middot; " + escaped(study.file) +
                      " &middot; " + plural(results.size(), "run"),
                  what_was_run(study.scene, study.sweep, study.overrides, facts_of(study), command) + found +
                      (is_map ? chart_section(study.output_directory, study.stem(), {}) : "") +
                      (is_map ? "" : html_section("Failed", failures_of(study, results))) +
                      runs_section(study, results));
    return write_page(study.output_directory, study.stem(), page, out);
  }
} // namespace Amontons

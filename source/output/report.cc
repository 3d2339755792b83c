#include <amontons/output/files.h>
#include <amontons/output/report.h>
#include <amontons/output/terminal.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    const char *const style =
        "body{font:15px/1.5 system-ui,sans-serif;color:#222;background:#f6f7f8;margin:0}"
        "main{max-width:1180px;margin:auto;padding:24px}h1{font-size:26px;margin:0 0 4px}"
        "h2{font-size:18px;margin:0 0 10px}section{background:#fff;border:1px solid "
        "#e2e5e8;border-radius:8px;"
        "padding:18px 22px;margin:16px "
        "0;overflow-x:auto}.pictures{display:flex;flex-wrap:wrap;align-items:flex-start;gap:18px}"
        "svg{max-width:100%;height:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
        "th,td{padding:3px 14px 3px 0;text-align:left;vertical-align:top;border-bottom:1px solid #eef0f2}"
        "th{font-weight:600;color:#555}td.n,th.n{text-align:right}.status{display:inline-block;padding:1px "
        "10px;"
        "border-radius:10px;color:#fff;background:#b3402a;font-size:13px}.good{background:#2a8a55}"
        "details{margin-top:10px}summary{cursor:pointer;color:#555}.sub{color:#666}pre{white-space:pre-wrap;"
        "margin:0}";

    using Row = std::vector<std::string>;

    std::string
    table(const Row &head, const std::vector<Row> &rows)
    {
      std::string html = "<table><tr>";
      for (std::size_t c = 0; c < head.size(); ++c)
        html += (c == 0 ? "<th>" : "<th class=\"n\">") + escaped(head[c]) + "</th>";
      for (const Row &row : rows)
        {
          html += "</tr>\n<tr>";
          for (std::size_t c = 0; c < row.size(); ++c)
            html += (c == 0 ? "<td>" : "<td class=\"n\">") + escaped(row[c]) + "</td>";
        }
      return html + "</tr></table>\n";
    }

    std::string
    section(const std::string &title, const std::string &content)
    {
      return content.empty() ? "" : "<section><h2>" + title + "</h2>\n" + content + "</section>\n";
    }

    std::string
    answer_section(const RunSummary &summary)
    {
      std::string html = "<table>", notes;
      for (const auto &[label, text] : answer_lines(summary))
        if (label == "note")
          notes += "<li>" + escaped(text) + "</li>\n";
        else if (text.empty())
          html += "<tr><th colspan=\"2\">" + escaped(label) + "</th></tr>\n";
        else
          html += "<tr><td>" + escaped(label) + "</td><td>" + escaped(text) + "</td></tr>\n";
      return section("Answer", html + "</table>\n") +
             section("What was modelled, and why", notes.empty() ? "" : "<ul>\n" + notes + "</ul>\n");
    }

    std::string
    pictures(const std::vector<std::string> &svgs)
    {
      std::string html;
      for (const std::string &svg : svgs)
        html += svg;
      return html.empty() ? "" : "<div class=\"pictures\">\n" + html + "</div>\n";
    }

    // Around the contact of the first pair that has one.
    Window
    zoom_window(const std::vector<PressureCurve> &curves)
    {
      Window window;
      for (const PressureCurve &curve : curves)
        if (window.half_width == 0 && curve.shown > 0)
          {
            window.centre     = {{curve.centre[0], curve.centre[1]}};
            window.half_width = 1.25 * curve.shown;
          }
      return window;
    }

    std::vector<std::string>
    mesh_pictures(const MeshPicture &mesh, const std::vector<PressureCurve> &curves)
    {
      if (mesh.empty())
        return {};
      std::vector<std::string> svgs = {svg_mesh(mesh, Window(), "Deformed mesh, von Mises stress")};
      const Window             zoom = zoom_window(curves);
      if (zoom.half_width > 0)
        svgs.push_back(svg_mesh(mesh, zoom, "Around the contact"));
      return svgs;
    }

    std::string
    text_of(const unsigned long long n)
    {
      return std::to_string(n);
    }

    std::string
    increment_table(const RunSummary &summary)
    {
      std::vector<Row> rows;
      for (const MeshSummary &mesh : summary.meshes)
        rows.push_back({text_of(mesh.increment),
                        short_number(mesh.t),
                        text_of(mesh.mesh),
                        text_of(mesh.cells),
                        text_of(mesh.dofs),
                        text_of(mesh.iterations),
                        text_of(mesh.krylov_iterations),
                        short_number(mesh.error_estimate.contact),
                        short_number(mesh.error_estimate.bulk),
                        short_number(mesh.seconds)});
      const Row head = {"increment",
                        "t",
                        "mesh",
                        "cells",
                        "DoFs",
                        "iterations",
                        "krylov",
                        "pressure error",
                        "stress error",
                        "seconds"};
      return rows.empty() ? "" : table(head, rows);
    }

    // Of all increments on each mesh; the errors are those of the last one.
    std::string
    mesh_table(const RunSummary &summary)
    {
      std::vector<Row> rows;
      for (auto mesh = summary.meshes.begin(); mesh != summary.meshes.end();)
        {
          unsigned int increments = 0, iterations = 0, most = 0, krylov = 0;
          auto         last = mesh;
          for (; mesh != summary.meshes.end() && mesh->mesh == last->mesh; last = mesh++)
            {
              ++increments;
              iterations += mesh->iterations;
              krylov += mesh->krylov_iterations;
              most = std::max(most, mesh->iterations);
            }
          rows.push_back({text_of(last->mesh),
                          text_of(last->cells),
                          text_of(last->dofs),
                          text_of(increments),
                          text_of(iterations),
                          text_of(most),
                          text_of(krylov),
                          short_number(last->error_estimate.contact),
                          short_number(last->error_estimate.bulk),
                          short_number(last->seconds)});
        }
      return table({"mesh",
                    "cells",
                    "DoFs",
                    "increments",
                    "iterations",
                    "most in one",
                    "krylov",
                    "pressure error",
                    "stress error",
                    "seconds"},
                   rows);
    }

    // Long histories: by mesh, and all of it on demand.
    std::string
    convergence_table(const RunSummary &summary)
    {
      if (summary.meshes.size() <= 24)
        return increment_table(summary);
      return mesh_table(summary) + "<details><summary>All increments</summary>\n" + increment_table(summary) +
             "</details>\n";
    }

    std::string
    probe_tables(const RunSummary &summary)
    {
      std::string html;
      for (const ProbeSummary &probe : summary.probes)
        {
          Row head;
          for (const std::string &axis : axis_names(summary.kind))
            head.push_back(axis);
          for (const std::string &axis : axis_names(summary.kind))
            head.push_back("u_" + axis);
          for (const std::string &name : stress_names(summary.kind))
            head.push_back("stress " + name);
          head.push_back("von Mises");

          std::vector<Row> rows;
          for (const ProbePoint &point : probe.points)
            {
              Row row;
              for (const std::vector<double> *values : {&point.point, &point.displacement, &point.stress})
                for (const double value : *values)
                  row.push_back(short_number(value));
              row.resize(head.size() - 1, "-");
              row.push_back(short_number(point.von_mises));
              rows.push_back(row);
            }
          html += "<p><b>" + escaped(probe.name) + "</b></p>\n" + table(head, rows);
        }
      return html;
    }

    std::string
    number_table(const std::string                   &what,
                 const std::string                   &unit,
                 const std::map<std::string, double> &values)
    {
      std::vector<Row> rows;
      for (const auto &[name, value] : values)
        rows.push_back({name, short_number(value)});
      return rows.empty() ? "" : table({what, unit}, rows);
    }

    std::string
    head(const RunSummary &summary)
    {
      const std::string title = escaped(summary.title.empty() ? summary.scene : summary.title);
      const std::string good  = summary.converged ? " good" : "";
      return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
             "</title><meta name=\"viewport\" content=\"width=device-width\"><style>" + style +
             "</style></head>\n<body><main>\n<h1>" + title + "</h1>\n<p class=\"sub\"><span class=\"status" +
             good + "\">" + escaped(summary.status()) + "</span> " + escaped(summary.scene) + " &middot; " +
             kind_name(summary.kind) + " &middot; " + std::to_string(summary.dofs) + " DoFs &middot; " +
             std::to_string(summary.ranks) + (summary.ranks == 1 ? " process" : " processes") + "</p>\n";
    }
  } // namespace

  void
  write_report(const std::string                                      &file,
               const RunSummary                                       &summary,
               const std::vector<PressureCurve>                       &curves,
               const MeshPicture                                      &mesh,
               const std::vector<std::pair<std::string, MeshPicture>> &pressure_maps)
  {
    std::vector<std::string> pressures, history, convergence;
    const auto               add = [](std::vector<std::string> &svgs, const Chart &chart) {
      if (!chart.curves.empty())
        svgs.push_back(svg_chart(chart));
    };
    for (const PressureCurve &curve : curves)
      {
        add(pressures, pressure_chart(curve));
        add(pressures, shear_chart(curve));
        add(pressures, state_map(curve));
      }
    for (const auto &[pair, picture] : pressure_maps)
      if (!picture.empty())
        pressures.push_back(svg_mesh(picture, Window(), "Pressure on the surface, " + pair));
    for (const Chart &chart : history_charts(summary))
      add(history, chart);
    add(convergence, iteration_chart(summary));
    add(convergence, error_chart(summary));

    write_file(file,
               head(summary) + answer_section(summary) + section("Along the contact", pictures(pressures)) +
                   section("Load history", pictures(history)) +
                   section("Mesh", pictures(mesh_pictures(mesh, curves))) +
                   section("Convergence", pictures(convergence) + convergence_table(summary)) +
                   section("Probes", probe_tables(summary)) +
                   section("Checks", number_table("check", "value", summary.checks)) +
                   section("Time", number_table("phase", "seconds", summary.cost.timing)) +
                   "</main></body></html>\n");
  }
} // namespace Amontons

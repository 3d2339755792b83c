#include <amontons/output/files.h>
#include <amontons/output/html.h>
#include <amontons/output/report.h>
#include <amontons/output/terminal.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
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
      return html_section("Answer", html + "</table>\n") +
             html_section("What was modelled, and why", notes.empty() ? "" : "<ul>\n" + notes + "</ul>\n");
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
    mesh_pictures(const MeshPicture &mesh, const std::vector<PressureCurve> &curves, const Units &units)
    {
      if (mesh.empty())
        return {};
      std::vector<std::string> svgs = {
          svg_mesh(mesh, Window(), with_unit("Deformed mesh, von Mises stress", units.pressure()))};
      const Window zoom = zoom_window(curves);
      if (zoom.half_width > 0)
        svgs.push_back(svg_mesh(mesh, zoom, with_unit("Around the contact", units.pressure())));
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
      std::vector<HtmlRow> rows;
      for (const MeshSummary &mesh : summary.meshes)
        rows.push_back({text_of(mesh.increment),
                        short_number(mesh.t),
                        text_of(mesh.mesh),
                        text_of(mesh.cells),
                        text_of(mesh.dofs),
                        text_of(mesh.iterations),
                        text_of(mesh.krylov_iterations),
                        short_number(mesh.error_estimate.contact),
                        short_number(mesh.error_estimate.shear),
                        short_number(mesh.error_estimate.bulk),
                        short_number(mesh.seconds)});
      const HtmlRow head = {"increment",
                            "t",
                            "mesh",
                            "cells",
                            "DoFs",
                            "iterations",
                            "krylov",
                            "pressure error",
                            "shear error",
                            "stress error",
                            "seconds"};
      return rows.empty() ? "" : html_table(head, rows);
    }

    // Of all increments on each mesh; the errors are those of the last one.
    std::string
    mesh_table(const RunSummary &summary)
    {
      std::vector<HtmlRow> rows;
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
                          short_number(last->error_estimate.shear),
                          short_number(last->error_estimate.bulk),
                          short_number(last->seconds)});
        }
      return html_table({"mesh",
                         "cells",
                         "DoFs",
                         "increments",
                         "iterations",
                         "most in one",
                         "krylov",
                         "pressure error",
                         "shear error",
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
          const std::string length = summary.units.length, pressure = summary.units.pressure();
          HtmlRow           head;
          for (const std::string &axis : axis_names(summary.kind))
            head.push_back(with_unit(axis, length));
          for (const std::string &axis : axis_names(summary.kind))
            head.push_back(with_unit("u_" + axis, length));
          for (const std::string &name : stress_names(summary.kind))
            head.push_back(with_unit("stress " + name, pressure));
          head.push_back(with_unit("von Mises", pressure));

          std::vector<HtmlRow> rows;
          for (const ProbePoint &point : probe.points)
            {
              HtmlRow row;
              for (const std::vector<double> *values : {&point.point, &point.displacement, &point.stress})
                for (const double value : *values)
                  row.push_back(short_number(value));
              row.resize(head.size() - 1, "-");
              row.push_back(short_number(point.von_mises));
              rows.push_back(row);
            }
          html += "<p><b>" + escaped(probe.name) + "</b></p>\n" + html_table(head, rows);
        }
      return html;
    }

    std::string
    number_table(const std::string                   &what,
                 const std::string                   &unit,
                 const std::map<std::string, double> &values)
    {
      std::vector<HtmlRow> rows;
      rows.reserve(values.size());
      for (const auto &[name, value] : values)
        rows.push_back({name, short_number(value)});
      return rows.empty() ? "" : html_table({what, unit}, rows);
    }

    // Beside the status.
    std::string
    facts(const RunSummary &summary)
    {
      return escaped(summary.scene) + " &middot; " + kind_name(summary.kind) + " &middot; " +
             std::to_string(summary.dofs) + " DoFs &middot; " + std::to_string(summary.ranks) +
             (summary.ranks == 1 ? " process" : " processes") +
             (summary.units.are_known()
                  ? " &middot; units " + escaped(summary.units.length) + ", " + escaped(summary.units.force)
                  : "");
    }
  } // namespace

  void
  write_report(const std::string                        &file,
               const RunSummary                         &summary,
               const std::vector<PressureCurve>         &curves,
               const MeshPicture                        &mesh,
               const std::map<std::string, MeshPicture> &pressure_maps,
               const std::vector<std::string>           &bodies)
  {
    std::vector<std::string> pressures, history, convergence;
    const auto               add = [](std::vector<std::string> &svgs, const Chart &chart) {
      if (!chart.curves.empty())
        svgs.push_back(svg_chart(chart));
    };
    for (const PressureCurve &curve : curves)
      {
        add(pressures, pressure_chart(curve, summary.units));
        add(pressures, shear_chart(curve, summary.units));
        add(pressures, state_map(curve, summary.units));
        if (const auto found = pressure_maps.find(curve.pair);
            found != pressure_maps.end() && !found->second.empty())
          pressures.push_back(svg_mesh(found->second,
                                       Window(),
                                       with_unit("Pressure on the surface (middles of faces), " + curve.pair,
                                                 summary.units.pressure()),
                                       axis_names(curve, summary.units)));
      }
    for (const Chart &chart : history_charts(summary))
      add(history, chart);
    add(convergence, iteration_chart(summary));
    add(convergence, error_chart(summary));

    const std::string content =
        answer_section(summary) + html_section("Bodies", html_pictures(bodies)) +
        html_section("Along the contact", html_pictures(pressures)) +
        html_section("Load history", html_pictures(history)) +
        html_section("Mesh", html_pictures(mesh_pictures(mesh, curves, summary.units))) +
        html_section("Convergence", html_pictures(convergence) + convergence_table(summary)) +
        html_section("Probes", probe_tables(summary)) +
        html_section("Checks", number_table("check", "value", summary.checks)) +
        html_section("Time", number_table("phase", "seconds", summary.cost.timing));
    write_file(file,
               html_page(summary.title.empty() ? summary.scene : summary.title,
                         summary.status(),
                         summary.converged,
                         facts(summary),
                         content));
  }
} // namespace Amontons

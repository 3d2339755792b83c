// What the report shows: rows of the load history, numbers of charts and tables, pictures of friction.
#include "check.h"

#include <amontons/output/report.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace test_report
{
using namespace Amontons;

MeshSummary
row(const unsigned int mesh, const unsigned int increment, const double t)
{
  MeshSummary result;
  result.mesh      = mesh;
  result.increment = increment;
  result.t         = t;
  PairSummary pair;
  pair.name             = "pair";
  pair.normal_force     = {0, -10};
  pair.tangential_force = {-3 * t, 0};
  pair.peak_pressure    = t;
  result.pairs          = {pair};
  result.external_work = result.contact_work = result.dissipation = t;
  return result;
}

bool
has_chart(const std::vector<Chart> &charts, const std::string &title)
{
  for (const Chart &chart : charts)
    if (chart.title == title)
      return true;
  return false;
}

void
check_history()
{
  RunSummary summary;
  // Replay: two passes, the first with smaller increments.
  summary.meshes = {row(0, 1, 0.5), row(0, 2, 1), row(0, 3, 2), row(1, 1, 1), row(1, 2, 2)};
  auto pass      = last_pass(summary);
  check::is_true(pass.size() == 2 && pass[0] == &summary.meshes[3] && pass[1] == &summary.meshes[4],
                 "replay");

  // Refined on the way: the last mesh of each increment.
  summary.meshes = {row(0, 1, 1), row(1, 1, 1), row(1, 2, 2)};
  pass           = last_pass(summary);
  check::is_true(pass.size() == 2 && pass[0] == &summary.meshes[1], "transfer");
  const auto charts = history_charts(summary);
  for (const std::string title :
       {"Normal force", "Tangential force", "Peak pressure", "Where the work goes", "Work of friction"})
    check::is_true(has_chart(charts, title), title);
  check::is_close(charts[0].curves[0].y[1], 10, 1e-14, "normal force");
  check::is_close(charts[1].curves[0].y[1], -6, 1e-14, "tangential force along x");
  check::is_true(!has_chart(charts, "Size of contact and stick"), "no sizes where nothing slips");

  summary.meshes = {row(0, 1, 1), row(1, 1, 1)};
  check::is_true(history_charts(summary).empty(), "no history in a single increment");
}

// A surface along x, pressed from below (outward normal -y).
std::vector<ContactNode>
surface(const double bound)
{
  std::vector<ContactNode> table(5);
  for (unsigned int i = 0; i < table.size(); ++i)
    {
      table[i].pair     = "pair";
      table[i].X        = Point<3>(i, 0, 0);
      table[i].arc      = i;
      table[i].normal   = Point<3>(0, -1, 0);
      table[i].area     = 1;
      table[i].pressure = 2;
      table[i].traction = Point<3>(0.25 * i, 0, 0);
      table[i].bound    = bound;
      table[i].state    = i < 4 ? ContactStatus::stick : ContactStatus::slip;
    }
  return table;
}

void
check_shear()
{
  PairSummary pair;
  pair.name             = "pair";
  pair.centre           = {2, 0};
  pair.tangential_force = {2, 0};
  const auto with       = pressure_curves(surface(1), {pair}, 2);
  check::is_close(with[0].shear[4], 1, 1e-14, "shear along the walk");
  const Chart chart = shear_chart(with[0]);
  check::is_true(chart.curves.size() == 5, "two bounds, the shear, and the nodes that stick and slip");
  check::is_true(state_map(with[0]).curves.empty(), "no map in the plane");
  const auto without = pressure_curves(surface(std::nan("")), {pair}, 2);
  check::is_true(shear_chart(without[0]).curves.empty(), "frictionless: none");

  const auto space = pressure_curves(surface(1), {pair}, 3);
  check::is_true(space[0].axes == std::array<unsigned int, 2>{{0, 2}}, "seen along y");
  check::is_true(state_map(space[0]).curves.size() == 3, "tractions and two states");
}

// What a pair is compared with is drawn beside it, and beside no other.
void
check_reference()
{
  PairSummary pair;
  pair.name             = "pair";
  pair.centre           = {2, 0};
  pair.tangential_force = {2, 0};
  ReferenceTractions reference;
  reference.pressure = [](const double s) { return 10 - s; };
  const auto curve   = pressure_curves(surface(1), {pair}, 2, reference)[0];
  check::is_true(curve.exact_name == "closed form" && curve.exact_shear.empty(), "pressure alone is known");
  check::is_close(curve.exact_s.front(), -2, 1e-12, "from the first node");
  check::is_close(curve.exact_pressure.front(), 8, 1e-12, "pressure at the distance from the centre");
  reference.shear = [](const double s) { return s; };
  check::is_close(
      pressure_curves(surface(1), {pair}, 2, reference)[0].exact_shear.back(), 2, 1e-12, "shear, too");
  reference.pair = "other";
  check::is_true(pressure_curves(surface(1), {pair}, 2, reference)[0].exact_name.empty(), "of another pair");
}

const Chart &
chart_of(const std::vector<Chart> &charts, const std::string &title)
{
  static const Chart none;
  for (const Chart &chart : charts)
    if (chart.title == title)
      return chart;
  check::is_true(false, "no chart " + title);
  return none;
}

void
expect_curve(const Chart               &chart,
             const unsigned int         c,
             const std::vector<double> &x,
             const std::vector<double> &y)
{
  check::is_true(c < chart.curves.size(), chart.title + ": curves");
  if (c < chart.curves.size())
    check::is_true(chart.curves[c].x == x && chart.curves[c].y == y,
                   chart.title + ": curve " + std::to_string(c));
}

// Increments at t = 1 and 2 with distinct numbers: each chart shows its own.
RunSummary
numbered_history()
{
  RunSummary summary;
  for (const double t : {1., 2.})
    {
      MeshSummary  mesh      = row(0, t, t);
      PairSummary &pair      = mesh.pairs[0];
      pair.normal_force      = {3 * t, -4 * t};
      pair.tangential_force  = {-6 * t, 8 * t};
      pair.peak_pressure     = 10 * t;
      pair.contact_size      = 11 * t;
      pair.stick_size        = 12 * t;
      pair.n_open            = 1;
      pair.n_stick           = 2;
      pair.n_slip            = 3;
      mesh.external_work     = 13 * t;
      mesh.energy            = 14 * t;
      mesh.contact_work      = 15 * t;
      mesh.dissipation       = 16 * t;
      mesh.iterations        = 17 + t;
      mesh.krylov_iterations = 20 + t;
      mesh.cells             = 100 + t;
      mesh.dofs              = 200 + t;
      mesh.seconds           = 0.5 * t;
      mesh.error_estimate    = {0.25 * t, 0.125 * t};
      mesh.probes            = {{"tip", {{{7, 8}, {-0.6 * t, 0.8 * t}, {1.5, 2.5, 3.5, 4.5}, 5.5}}}};
      summary.meshes.push_back(mesh);
    }
  summary.probes              = summary.meshes.back().probes;
  summary.pairs               = summary.meshes.back().pairs;
  summary.checks["balance"]   = 0.375;
  summary.cost.timing["mesh"] = 0.625;
  return summary;
}

void
check_numbers_of_charts()
{
  const auto                charts = history_charts(numbered_history());
  const std::vector<double> t = {1, 2}, from_rest = {0, 1, 2};
  expect_curve(chart_of(charts, "Normal force"), 0, t, {5, 10});
  // along the tangential force, to the side where its largest component is positive
  expect_curve(chart_of(charts, "Tangential force"), 0, t, {10, 20});
  expect_curve(chart_of(charts, "Peak pressure"), 0, t, {10, 20});
  expect_curve(chart_of(charts, "Size of contact and stick"), 0, t, {11, 22});
  expect_curve(chart_of(charts, "Size of contact and stick"), 1, t, {12, 24});
  expect_curve(chart_of(charts, "Where the work goes"), 0, from_rest, {0, 13, 26});
  expect_curve(chart_of(charts, "Where the work goes"), 1, from_rest, {0, 14, 28});
  expect_curve(chart_of(charts, "Where the work goes"), 2, from_rest, {0, 15, 30});
  expect_curve(chart_of(charts, "Work of friction"), 0, from_rest, {0, 16, 32});
  expect_curve(chart_of(charts, "Iterations per increment, last mesh"), 0, t, {18, 19});
  const Chart &hysteresis = chart_of(charts, "Hysteresis, pair");
  check::is_close(hysteresis.curves[0].x[1], 2, 1e-14, "hysteresis: displacement along the force");
  check::is_close(hysteresis.curves[0].y[1], 20, 1e-14, "hysteresis: force");

  // Changes by iteration of the meshes of the last increment; errors by DoFs at the last time.
  RunSummary summary;
  for (const unsigned int increment : {1, 2, 2})
    {
      NewtonSummary newton;
      newton.increment          = increment;
      newton.mesh               = summary.newton.size();
      newton.active_set_changes = {5 + newton.mesh, 2, 0};
      summary.newton.push_back(newton);
    }
  const Chart iterations = iteration_chart(summary);
  check::is_close(iterations.curves.size(), 2, 0, "iterations of the last increment");
  expect_curve(iterations, 0, {1, 2, 3}, {6, 2, 0});
  expect_curve(iterations, 1, {1, 2, 3}, {7, 2, 0});
  for (const double n : {1., 2.})
    {
      MeshSummary mesh    = row(n, 1, 1);
      mesh.dofs           = 100 * n;
      mesh.error_estimate = {0.5 / n, 0.25 / n};
      ReferenceSummary reference;
      reference.errors["contact_size"] = -0.125 / n;
      mesh.reference                   = reference;
      summary.meshes.push_back(mesh);
    }
  const Chart errors = error_chart(summary);
  expect_curve(errors, 0, {100, 200}, {0.25, 0.125});
  expect_curve(errors, 1, {100, 200}, {0.5, 0.25});
  expect_curve(errors, 2, {100, 200}, {0.125, 0.0625});
}

// The tables of the page, row by row.
void
check_tables()
{
  const std::string folder = std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp";
  const std::string file   = folder + "/amontons_test_report.html";
  write_report(file, numbered_history(), {}, {}, {});
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::remove(file.c_str());
  const auto cells = [](const std::vector<std::string> &words) {
    std::string html = "<tr>";
    for (std::size_t c = 0; c < words.size(); ++c)
      html += (c == 0 ? "<td>" : "<td class=\"n\">") + words[c] + "</td>";
    return html + "</tr>";
  };
  for (const auto &line :
       {std::vector<std::string>{"1", "1", "0", "101", "201", "18", "21", "0.125", "-", "0.25", "0.5"},
        {"2", "2", "0", "102", "202", "19", "22", "0.25", "-", "0.5", "1"},
        {"7", "8", "-1.2", "1.6", "1.5", "2.5", "3.5", "4.5", "5.5"},
        {"balance", "0.375"},
        {"mesh", "0.625"}})
    check::is_true(text.str().find(cells(line)) != std::string::npos, "table: " + cells(line));
  check::is_true(text.str().find("<td>  normal force</td><td>10   (6, -8)</td>") != std::string::npos,
                 "answer");
}

void
check_broken_line()
{
  Chart chart;
  chart.curves          = {{"", {0, 1, NAN, 2, 3}, {0, 1, NAN, 0, 1}, true, false}};
  const std::string svg = svg_chart(chart), path = svg.substr(svg.find("<path"), 120);
  check::is_true(std::count(path.begin(), path.end(), 'M') == 2, "two pieces: " + path);
}

int
main(int, char **)
{
  check_history();
  check_numbers_of_charts();
  check_tables();
  check_shear();
  check_reference();
  check_broken_line();
  return check::result();
}
} // namespace test_report

// The pictures of friction: which rows the load history takes, and what the charts show.
#include "check.h"

#include <amontons/output/report.h>

#include <algorithm>

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
      table[i].state    = i < 4 ? ContactState::stick : ContactState::slip;
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

void
check_broken_line()
{
  Chart chart;
  chart.curves          = {{"", {0, 1, NAN, 2, 3}, {0, 1, NAN, 0, 1}, true, false}};
  const std::string svg = svg_chart(chart), path = svg.substr(svg.find("<path"), 120);
  check::is_true(std::count(path.begin(), path.end(), 'M') == 2, "two pieces: " + path);
}

int
main()
{
  check_history();
  check_shear();
  check_broken_line();
  return check::result();
}

// Long load programs get a line per increment, and the table of iterations only where one fails; the answer
// has every number that there is.
#include "text_checks.h"

#include <amontons/output/terminal.h>

#include <algorithm>
#include <sstream>

namespace test_terminal
{
using namespace Amontons;

std::string
run(const unsigned int n_increments, const bool fails, const bool quiet = false)
{
  Scene scene;
  scene.n_increments = n_increments;
  std::ostringstream text;
  Terminal           terminal(MPI_COMM_WORLD, quiet, &text);
  terminal.scene(scene, 1);
  IterationLine line;
  line.iteration = 1;
  line.residual  = 0.125;
  terminal.mesh(1, 0.5, 0, 10, 20);
  terminal.iteration(line);
  terminal.estimate(EstimateSummary());
  terminal.mesh(1, fails ? 0.25 : 0.75, 0, 10, 20); // cut back, or solved once more
  terminal.iteration(line);
  terminal.estimate(EstimateSummary());
  RunSummary summary;
  summary.converged = true;
  terminal.answer(summary);
  return text.str();
}

using Lines = std::vector<std::pair<std::string, std::string>>;

PairSummary
pair(const std::string &name)
{
  PairSummary pair;
  pair.name             = name;
  pair.normal_force     = {-30, 40};
  pair.tangential_force = {8, 6};
  pair.peak_pressure    = 123.456789;
  pair.contact_size     = 0.75;
  pair.stick_size       = 0.5;
  pair.n_open           = 3;
  pair.n_stick          = 4;
  pair.n_slip           = 5;
  return pair;
}

// Every number that there is, in words.
void
check_answer()
{
  RunSummary summary;
  summary.converged      = false;
  summary.message        = "why";
  summary.pairs          = {pair("one")};
  summary.error_estimate = {0.0123, 0.25};
  summary.energy         = 17.5;
  summary.meshes.resize(1);
  summary.meshes[0].external_work = 31.25;
  summary.meshes[0].contact_work  = 4;
  summary.meshes[0].dissipation   = 3.5;
  summary.probes                  = {{"p", {{{1, 2}, {0.5, -0.25}, {1, 2, 3, 4}, 6.5}, {{9, 9}, {}, {}}}},
                                     {"long", std::vector<ProbePoint>(5)}};
  ReferenceSummary reference;
  reference.closed_form            = "hertz_line";
  reference.errors["contact_size"] = 0.002;
  reference.errors["pressure_l2"]  = 0.03;
  reference.values["contact_size"] = {{0.75, 0.76}};
  summary.reference                = reference;
  summary.cells                    = 100;
  summary.dofs                     = 222;
  summary.cost.wall_seconds        = 1.5;
  summary.notes                    = {"a note"};
  const Lines wanted               = {{"status", "not converged: why"},
                                      {"pair one", ""},
                                      {"  normal force", "50   (-30, 40)"},
                                      {"  tangential force", "(8, 6)"},
                                      {"  peak pressure", "123.46"},
                                      {"  contact half-width", "0.75   (Hertz-equivalent)"},
                                      {"  stick half-width", "0.5   (Hertz-equivalent, of bound less shear)"},
                                      {"  nodes", "3 open, 4 stick, 5 slip"},
                                      {"estimated error of the pressure", "25 %"},
                                      {"estimated error of the stress", "1.23 %"},
                                      {"strain energy", "17.5"},
                                      {"external work", "31.25"},
                                      {"work of friction", "3.5"},
                                      {"probe p", "at (1, 2): displacement (0.5, -0.25); von Mises 6.5"},
                                      {"", "at (9, 9): displacement -; von Mises -"},
                                      {"against hertz_line", ""},
                                      {"  error of contact_size", "0.2 %   (0.75, exact 0.76)"},
                                      {"  error of pressure_l2", "3 %"},
                                      {"finest mesh", "100 cells, 222 DoFs"},
                                      {"time", "1.5 s"},
                                      {"note", "a note"}};
  const Lines found                = answer_lines(summary);
  check::is_close(found.size(), wanted.size(), 0, "lines of the answer");
  for (unsigned int i = 0; i < std::min(found.size(), wanted.size()); ++i)
    check::is_true(found[i] == wanted[i],
                   "'" + found[i].first + "', '" + found[i].second + "'; expected '" + wanted[i].first +
                       "', '" + wanted[i].second + "'");

  // Round contacts have radii; forces of axisymmetric scenes are those of the full turn. What is rounding
  // beside the normal force is no tangential force, and all that touches is no contact size.
  summary.kind                      = ProblemType::axisymmetric;
  summary.pairs[0].tangential_force = {0, 4e-11};
  summary.pairs[0].normal_force     = {1e-13, 50};
  const Lines round                 = answer_lines(summary);
  const auto  has = [](const Lines &lines, const std::string &label, const std::string &text) {
    return std::find(lines.begin(), lines.end(), std::make_pair(label, text)) != lines.end();
  };
  check::is_true(has(round, "  normal force", "50   (0, 50), full turn"), "full turn");
  check::is_true(has(round, "  contact radius", "0.75   (Hertz-equivalent)"), "radius of the contact");
  check::is_true(has(round, "  stick radius", "0.5   (Hertz-equivalent, of bound less shear)"),
                 "radius of stick");
  const auto mentions = [](const Lines &lines, const std::string &label) {
    return std::any_of(lines.begin(), lines.end(), [&](const auto &line) { return line.first == label; });
  };
  check::is_true(!mentions(round, "  tangential force"), "rounding is no tangential force");
  summary.pairs[0].n_open = 0;
  check::is_true(!mentions(answer_lines(summary), "  contact radius"), "no size where all nodes touch");
  summary.pairs[0]         = pair("slides");
  summary.pairs[0].n_stick = 0;
  check::is_true(!mentions(answer_lines(summary), "  stick radius"), "no stick size where nothing sticks");
}

// The tables of the iteration.
void
check_lines()
{
  std::ostringstream text;
  Terminal           terminal(MPI_COMM_WORLD, false, &text);
  terminal.mesh(2, 0.5, 3, 10, 20);
  IterationLine line;
  line.iteration         = 4;
  line.residual          = 0.00125;
  line.n_open            = 5;
  line.n_stick           = 6;
  line.n_slip            = 7;
  line.changes           = 8;
  line.krylov_iterations = 9;
  terminal.iteration(line);
  terminal.estimate({0.5, 0.25});
  const std::string wanted = "\nIncrement 2 to t = 0.5, mesh 3: 10 cells, 20 DoFs\n"
                             "  iteration   residual     open    stick     slip  changed   krylov\n"
                             "          4   1.25e-03        5        6        7        8        9\n"
                             "  estimated relative error: contact pressure 0.25, stress 0.5\n";
  check::is_true(text.str() == wanted, text.str());
}

// The table of long load programs: one for each mesh, with a blank line before it.
void
check_brief_lines()
{
  Scene scene;
  scene.n_increments = 13;
  std::ostringstream text;
  Terminal           terminal(MPI_COMM_WORLD, false, &text);
  terminal.scene(scene, 1);
  const std::size_t begin = text.str().size();
  IterationLine     line;
  line.residual          = 0.00125;
  line.n_open            = 5;
  line.n_stick           = 6;
  line.n_slip            = 7;
  line.krylov_iterations = 9;
  terminal.mesh(3, 0.5, 1, 10, 20);
  terminal.iteration(line);
  terminal.iteration(line);
  terminal.estimate({0.5, 0.25});
  const std::string found = text.str().substr(begin);
  const std::string wanted =
      "\nMesh 1: 10 cells, 20 DoFs\n"
      "  increment            t  iterations   residual     open    stick     slip   "
      "krylov  pressure error\n"
      "          3          0.5           2   1.25e-03        5        6        7       "
      "18            0.25\n";
  check::is_true(found == wanted, found);
}

// What was said after the last increment is not said again with the answer, what was said before it is.
void
check_notes()
{
  std::ostringstream text;
  Terminal           terminal(MPI_COMM_WORLD, false, &text);
  RunSummary         summary;
  summary.notes = {"early", "late", "new"};
  terminal.note("early");
  terminal.mesh(1, 1, 0, 10, 20);
  terminal.note("late");
  terminal.answer(summary);
  for (const char *const note : {"early", "late", "new"})
    check::is_close(
        check::count(text.str(), std::string("note: ") + note + "\n"), note[0] == 'e' ? 2 : 1, 0, note);
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                columns = "  iteration   residual";
  check::is_true(check::count(run(12, false), columns) == 2, "short: a table for each");
  check::is_true(check::count(run(13, false), columns) == 0, "long: no table\n" + run(13, false));
  check::is_true(check::count(run(13, false), "increment            t") == 1, "long: one head for each mesh");
  check::is_true(check::count(run(13, false), "1.25e-01") == 2, "long: a line per increment");
  check::is_true(check::count(run(13, true), columns) == 1, "long: the table of the increment that failed");
  check::is_true(run(13, true, true).empty(), "quiet");
  check_answer();
  check_lines();
  check_brief_lines();
  check_notes();
  return check::result();
}
} // namespace test_terminal

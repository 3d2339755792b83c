// Long load programs get a line per increment, and the table of iterations only where one fails.
#include "check.h"

#include <amontons/output/terminal.h>

#include <sstream>

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
  summary.status = "converged";
  terminal.answer(summary);
  return text.str();
}

unsigned int
count(const std::string &text, const std::string &part)
{
  unsigned int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                columns = "  iteration   residual";
  check::is_true(count(run(12, false), columns) == 2, "short: a table for each");
  check::is_true(count(run(13, false), columns) == 0, "long: no table\n" + run(13, false));
  check::is_true(count(run(13, false), "increment            t") == 1, "long: one head for each mesh");
  check::is_true(count(run(13, false), "1.25e-01") == 2, "long: a line per increment");
  check::is_true(count(run(13, true), columns) == 1, "long: the table of the increment that failed");
  check::is_true(run(13, true, true).empty(), "quiet");
  return check::result();
}

// What a user sees while a scene runs. Rank 0 prints; with `quiet` nobody does.
#pragma once

#include <amontons/output/summary.h>

#include <chrono>
#include <fstream>
#include <set>

namespace Amontons
{
  // One step of the semismooth Newton iteration.
  struct IterationLine
  {
    unsigned int iteration = 0;
    double       residual  = unknown; // relative
    unsigned int n_open = 0, n_stick = 0, n_slip = 0;
    unsigned int changes           = 0; // nodes that changed their state
    unsigned int krylov_iterations = 0; // 0: direct solver
  };

  // Load programs of more than 12 increments get a line per increment, and the table of its iterations only
  // where one fails; shorter ones a table per increment and mesh.
  class Terminal
  {
  public:
    // stream: std::cout, or another one in tests (then never taken for a terminal).
    Terminal(const MPI_Comm communicator, const bool quiet, std::ostream *stream = nullptr);

    // All lines so far and from now on go to this file, too, quiet or not; added to what it holds.
    void
    log_to(const std::string &file);

    // The scene in one paragraph.
    void
    scene(const Scene &scene, const unsigned int n_ranks);
    // "Increment 1 of 1, mesh 3: 1280 cells, 10754 DoFs", and the head of the iteration's columns.
    void
    mesh(const unsigned int       increment,
         const double             t,
         const unsigned int       mesh,
         const unsigned long long cells,
         const unsigned long long dofs);
    void
    iteration(const IterationLine &line);
    void
    estimate(const EstimateSummary &estimate);
    void
    note(const std::string &text);
    // The closing answer.
    void
    answer(const RunSummary &summary);

    // How much of `what` is done, 0 to 1; a bar with the time left on work of more than 2 seconds where the
    // output is a terminal, else a line at most every 5 seconds. A fraction of 1 ends it.
    void
    progress(const std::string &what, const double fraction);

  private:
    void
    line(const std::string &text); // wipes a bar first
    void
    paragraph(const std::string &text);
    void
    show_iterations(); // of the increment that failed

    using Clock = std::chrono::steady_clock;

    std::ostream &stream;
    const bool    quiet, is_tty, is_root;
    std::string   unlogged; // lines before log_to()
    std::ofstream log;
    bool          bar_shown = false;
    std::string   work; // what the bar is about

    // The increment that is being solved, where each gets a line.
    bool                       brief = false;
    std::string                heading;
    unsigned int               increment_number = 0;
    double                     increment_end    = 0;
    int                        mesh_shown       = -1;
    std::vector<IterationLine> iterations;
    std::set<std::string>      notes_said; // since it began: the answer does not say them again

    Clock::time_point work_started, last_line;
  };

  // Of the load program if none is cut back.
  unsigned int
  planned_increments(const Scene &scene);

  // The paragraph of `Terminal::scene`.
  std::string
  describe_scene(const Scene &scene, const unsigned int n_ranks);

  // Lines of the closing answer (also used by the report): label and text.
  std::vector<std::pair<std::string, std::string>>
  answer_lines(const RunSummary &summary);

  // Short text of a number for people: 5 significant digits.
  std::string
  short_number(const double number);
} // namespace Amontons

#include <amontons/output/terminal.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include <unistd.h>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int line_width = 100, label_width = 34;
    constexpr unsigned int most_tables = 12; // of iterations; after as many increments each gets a line

    // Breaks the text between words; lines after the first start with `indent` blanks.
    std::string
    wrap(const std::string &text, const unsigned int indent)
    {
      std::string result, word;
      std::size_t column = indent;
      for (std::size_t i = 0; i <= text.size(); ++i)
        if (i < text.size() && (text[i] != ' ' || text[i + 1] == '%')) // a number and its unit
          word += text[i];
        else
          {
            if (column > indent && column + 1 + word.size() > line_width)
              {
                result += "\n" + std::string(indent, ' ');
                column = indent;
              }
            else if (column > indent)
              {
                result += " ";
                ++column;
              }
            result += word;
            column += word.size();
            word.clear();
          }
      return result;
    }

    template <typename... Arguments>
    std::string
    format(const char *pattern, const Arguments... arguments)
    {
      char text[200];
      std::snprintf(text, sizeof(text), pattern, arguments...);
      return text;
    }

    std::string
    duration(const double seconds)
    {
      if (seconds < 100)
        return format("%.0f s", seconds);
      if (seconds < 6000)
        return format("%.0f min", seconds / 60);
      return format("%.1f h", seconds / 3600);
    }

    const char *const iteration_columns =
        "  iteration   residual     open    stick     slip  changed   krylov";

    std::string
    residual_text(const double residual)
    {
      return std::isfinite(residual) ? format("%9.2e", residual) : "        -";
    }

    std::string
    iteration_text(const IterationLine &l)
    {
      return format("  %9u  %s %8u %8u %8u %8u %8u",
                    l.iteration,
                    residual_text(l.residual).c_str(),
                    l.n_open,
                    l.n_stick,
                    l.n_slip,
                    l.changes,
                    l.krylov_iterations);
    }

    double
    seconds_since(const std::chrono::steady_clock::time_point &start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  } // namespace

  Terminal::Terminal(const MPI_Comm communicator, const bool quiet, std::ostream *other)
      : stream(other != nullptr ? *other : std::cout),
        quiet(quiet || Utilities::MPI::this_mpi_process(communicator) != 0),
        // (mpirun gives its processes terminals, whatever it writes to itself)
        is_tty(other == nullptr && isatty(STDOUT_FILENO) == 1 &&
               Utilities::MPI::n_mpi_processes(communicator) == 1),
        is_root(Utilities::MPI::this_mpi_process(communicator) == 0)
  {
  }

  void
  Terminal::log_to(const std::string &file)
  {
    std::error_code error;
    if (!is_root || log.is_open())
      return;
    if (std::filesystem::is_symlink(file, error))
      std::filesystem::remove(file, error);
    log.open(file, std::ios::app);
    log << unlogged << std::flush;
    unlogged.clear();
  }

  void
  Terminal::line(const std::string &text)
  {
    if (log.is_open())
      log << text << std::endl;
    else if (is_root)
      unlogged += text + "\n";
    if (quiet)
      return;
    if (bar_shown)
      stream << "\r\033[K";
    bar_shown = false;
    stream << text << std::endl;
    last_line = Clock::now();
  }

  void
  Terminal::paragraph(const std::string &text)
  {
    line(wrap(text, 0));
  }

  void
  Terminal::scene(const Scene &scene, const unsigned int n_ranks)
  {
    brief = planned_increments(scene) > most_tables;
    paragraph(describe_scene(scene, n_ranks));
  }

  void
  Terminal::mesh(const unsigned int       increment,
                 const double             t,
                 const unsigned int       mesh,
                 const unsigned long long cells,
                 const unsigned long long dofs)
  {
    if (brief && increment == increment_number && static_cast<int>(mesh) == mesh_shown && t < increment_end)
      show_iterations(); // it was cut back
    if (!brief && increment > most_tables)
      {
        brief      = true;
        mesh_shown = -1;
      }
    const std::string size = format("mesh %u: %llu cells, %llu DoFs", mesh, cells, dofs);
    heading                = format("Increment %u to t = %g, ", increment, t) + size;
    increment_number       = increment;
    increment_end          = t;
    iterations.clear();
    notes_said.clear();
    if (!brief)
      {
        line("");
        line(heading);
        line(iteration_columns);
      }
    else if (static_cast<int>(mesh) != mesh_shown)
      {
        line("");
        line("M" + size.substr(1));
        line("  increment            t  iterations   residual     open    stick     slip   krylov  pressure "
             "error");
      }
    mesh_shown = mesh;
  }

  void
  Terminal::iteration(const IterationLine &l)
  {
    iterations.push_back(l);
    if (!brief)
      line(iteration_text(l));
  }

  void
  Terminal::show_iterations()
  {
    line(heading);
    line(iteration_columns);
    for (const IterationLine &l : iterations)
      line(iteration_text(l));
  }

  void
  Terminal::estimate(const EstimateSummary &estimate)
  {
    if (!brief)
      {
        line("  estimated relative error: contact pressure " + short_number(estimate.contact) +
             (std::isnan(estimate.shear) ? "" : ", shear " + short_number(estimate.shear)) + ", stress " +
             short_number(estimate.bulk) +
             (std::isnan(estimate.quantity) ? "" : ", target quantity " + short_number(estimate.quantity)));
        return;
      }
    const IterationLine last   = iterations.empty() ? IterationLine() : iterations.back();
    unsigned int        krylov = 0;
    for (const IterationLine &l : iterations)
      krylov += l.krylov_iterations;
    line(format("  %9u %12.6g %11u  %s %8u %8u %8u %8u %15s",
                increment_number,
                increment_end,
                static_cast<unsigned int>(iterations.size()),
                residual_text(last.residual).c_str(),
                last.n_open,
                last.n_stick,
                last.n_slip,
                krylov,
                short_number(estimate.contact).c_str()));
  }

  void
  Terminal::note(const std::string &text)
  {
    line("  note: " + wrap(text, 8));
    notes_said.insert(text);
  }

  void
  Terminal::answer(const RunSummary &summary)
  {
    if (brief && !summary.converged && !iterations.empty())
      show_iterations();
    line("");
    for (const auto &[label, text] : answer_lines(summary))
      if (label == "note")
        {
          if (notes_said.count(text) == 0)
            note(text);
        }
      else if (text.empty())
        line(label);
      else
        line(label + std::string(label_width - std::min<std::size_t>(label_width - 1, label.size()), ' ') +
             wrap(text, label_width));
  }

  void
  Terminal::progress(const std::string &what, const double fraction)
  {
    if (quiet)
      return;
    if (what != work)
      {
        work         = what;
        work_started = last_line = Clock::now();
      }
    const double elapsed = seconds_since(work_started);
    if (fraction >= 1)
      {
        if (bar_shown)
          stream << "\r\033[K" << std::flush;
        bar_shown = false;
        work.clear();
        return;
      }
    if (elapsed < 2 || (!is_tty && seconds_since(last_line) < 5))
      return;

    const std::string left = fraction > 0 ? ", " + duration(elapsed / fraction - elapsed) + " left" : "";
    const std::string done = format(" %3.0f %%", 100 * fraction) + left;
    if (!is_tty)
      {
        line("  " + what + ":" + done);
        return;
      }
    const unsigned int n_full = std::lround(30 * std::max(0., fraction));
    stream << "\r\033[K  " << what << " [" << std::string(n_full, '#') << std::string(30 - n_full, '.') << "]"
           << done << std::flush;
    bar_shown = true;
  }
} // namespace Amontons

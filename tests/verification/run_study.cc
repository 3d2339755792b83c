// Studies of processes: what their files say, that a killed one goes on, what is solved and what is wrong,
// the Pareto front and the targets.
#include <amontons/verification/process_study.h>
#include <amontons/verification/run_table.h>
#include <amontons/verification/study_report.h>
#include <amontons/verification/work_precision.h>

#include <text_checks.h>

#include <deal.II/base/mpi.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace test_run_study
{
using namespace Amontons;
namespace fs = std::filesystem;

namespace
{
  std::atomic<unsigned int> n_runs;

  std::string
  read_text(const std::string &file)
  {
    std::ifstream      in(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  double
  value_of(const std::vector<std::string> &overrides, const std::string &name)
  {
    for (const std::string &text : overrides)
      if (text.find(name + " = ") != std::string::npos)
        return std::stod(text.substr(text.find('=') + 1));
    return 0;
  }

  // F: force. It holds if friction >= 0.3; 0.7 makes it wrong, 0.8 hangs, 0.9 crashes, and two increments are
  // cut back.
  RunEnd
  fake(const RunOrder &order)
  {
    ++n_runs;
    const double friction = value_of(order.overrides, "Friction"), steps = value_of(order.overrides, "Steps");
    RunEnd       end;
    end.processor_seconds = 0.5 * steps;
    end.megabytes         = 100 + steps;
    if (friction == 0.8)
      end.kind = RunEnd::Kind::time_limit;
    if (friction == 0.9)
      end.kind = RunEnd::Kind::signal, end.code = 11;
    if (friction == 0.75)
      end.code = 1, end.last_words = "scene.prm:3: found '0.75', a number, \"odd\"; allowed: others";
    if (end.kind != RunEnd::Kind::ended || !end.last_words.empty())
      return end;
    boost::property_tree::ptree tree;
    const bool                  holds = friction >= 0.3;
    tree.put("status", holds ? "converged" : "not converged");
    tree.put("failure", holds ? "" : friction < 0.2 ? "friction beyond limit" : "no states");
    tree.put("message", holds ? "" : "friction cannot hold it, whatever, at (1, 2)");
    tree.put("cut_backs", steps == 2 ? 3 : 0);
    tree.put("linear_solves", 7);
    tree.put("dofs", 1000 * steps);
    tree.put("cells", 10);
    tree.put("force", friction == 0.7 ? 11 : 10 * friction);
    tree.put("error", 1 / (steps * steps));
    boost::property_tree::ptree solve, solves;
    solve.put("iterations", 4);
    solves.push_back({"", solve});
    tree.add_child("newton", solves);
    end.code    = holds ? 0 : 1;
    end.summary = tree;
    return end;
  }

  const std::string map_text = "set Kind = stability\n"
                               "set Title = A map\n"
                               "set Expected = force = 10*y\n"
                               "set No solution where = 0.3 - y\n"
                               "set Threshold = limit: 0.3 + 0*x\n"
                               "subsection Sweep\n"
                               "set 1 = Steps: 1, 2, 4\n"
                               "set 2 = Contact a/Friction: 0.1, 0.25, 0.3, 0.7, 0.75, 0.8, 0.9\n"
                               "end\n";

  std::string
  run(const std::string &name,
      const std::string &text,
      const RunProcess  &process  = fake,
      const int          expected = 0)
  {
    std::ofstream(name + ".prm") << "set Scene = scene.prm\nset Output = out_" << name << "\n" << text;
    std::ostringstream out;
    n_runs = 0;
    check::is_true(run_process_study(StudyEntries(name + ".prm"), {"", 2}, process, out) == expected,
                   name + ": return value");
    return out.str();
  }

  void
  message(const std::string &text, const std::string &part)
  {
    try
      {
        run("wrong", text);
        check::is_true(false, "no error for " + text);
      }
    catch (const InputError &error)
      {
        check::contains(error.what(), part);
      }
  }

  void
  maps()
  {
    const std::string printed = run("map", map_text);
    std::cout << printed;
    check::is_true(n_runs == 21, "21 runs");
    check::contains(printed, "  0.9 |  X  X  X\n");
    check::contains(printed, "  0.8 |  T  T  T\n");
    check::contains(printed, " 0.75 |  r  r  r\n");
    check::contains(printed, "  0.7 |  W  W  W\n");
    check::contains(printed, "  0.3 |  +  c  +\n");
    check::contains(printed, " 0.25 |  f  f  f\n");
    check::contains(printed, "  0.1 |  r  r  r\n");
    check::contains(printed, "force is off by 0.571");
    check::contains(printed, "--set \"Contact a/Friction = 0.7\"");
    check::contains(read_text("out_map/map.gp"), "$threshold_0 << END");
    check::is_true(!fs::exists("out_map/map_runs"), "folders of runs are gone");
    const std::string page = read_text("out_map/map.html");
    for (const std::string text :
         {"<h1>A map</h1>",
          ">12 wrong or failed<",
          "<td>swept: Friction</td><td>0.1, 0.25, 0.3, 0.7, 0.75, 0.8, 0.9   (Contact a/Friction)</td>",
          "<td>threshold</td><td>limit: y = 0.3 + 0*x</td>",
          "<td>no solution where</td><td>0.3 - y &gt; 0</td>",
          "<pre>amontons study map.prm</pre>",
          "</span>wrong (3)",
          "title=\"wrong: force is off by 0.571\">57%</td>",
          "<b>Steps = 4, Friction = 0.7</b>: wrong; force is off by 0.571",
          "--set 'Contact a/Friction = 0.7'</pre>",
          "found '0.75', a number, &quot;odd&quot;; allowed: others"})
      check::contains(page, text);
    check::is_true(run("map", map_text).find("of which 21 are known") != std::string::npos && n_runs == 0,
                   "nothing is run twice");
  }

  // Wherever the file ends, the study ends with the same.
  void
  goes_on()
  {
    const std::string csv = "out_map/map.csv", whole = read_text(csv), map = run("map", map_text);
    const std::string table = map.substr(map.find("\nA map\n"));
    for (std::size_t length = 0; length < whole.size(); length += 97)
      {
        fs::resize_file(csv, length);
        const std::string again = run("map", map_text);
        check::is_true(read_text(csv) == whole, "the same file after " + std::to_string(length));
        check::is_true(again.substr(again.find("\nA map\n")) == table, "the same table");
        check::is_true(length < 400 || n_runs < 21, "goes on after " + std::to_string(length));
      }
    // A signal stops it where it is.
    fs::remove(csv);
    const std::string stopped = run(
        "map",
        map_text,
        [](const RunOrder &order) {
          if (n_runs == 9)
            std::raise(SIGTERM);
          return fake(order);
        },
        128 + SIGTERM);
    check::contains(stopped, "the same command goes on");
    check::is_true(n_runs < 14, "stopped");
    run("map", map_text);
    check::is_true(n_runs > 6 && n_runs < 13 && read_text(csv) == whole, "the rest is run, and the same");
    const std::string other = run("map", map_text + "set Overrides = A/B = 1\n");
    check::contains(other, "out_map/map.csv.old");
    check::is_true(n_runs == 21, "another study begins anew");
  }

  void
  outcomes()
  {
    RunStudy study;
    study.quantities.resize(1);
    StudyResult result;
    result.record.ending = "converged";
    result.errors        = {0.02};
    check::is_true(outcome_of(study, result) == Outcome::wrong, "beyond the tolerance");
    study.wrong_above = 0.03;
    check::is_true(outcome_of(study, result) == Outcome::solved, "within the tolerance");
    result.errors = {std::numeric_limits<double>::quiet_NaN()};
    check::is_true(outcome_of(study, result) == Outcome::wrong, "not known");
    result.record.ending  = "not converged";
    result.record.failure = "moves apart";
    check::is_true(outcome_of(study, result) == Outcome::refused, "with a reason");
    result.record.failure = "broken laws";
    check::is_true(outcome_of(study, result) == Outcome::failed, "without a reason");
  }

  void
  fronts()
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto   front =
        pareto_front({{3, 0.1}, {1, 0.5}, {2, 0.6}, {3, 0.2}, {5, 0.1}, {6, 0.05}, {7, nan}, {0.5, 0}});
    check::is_true(front == std::vector<unsigned int>({1, 0, 5}), "the Pareto front");

    const std::string text =
        "set Kind = work precision\nset Title = Work\nset Quantities = error\n"
        "set Targets = 0.01, 0.1, 1e-6\n"
        "subsection Sweep\nset 1 = Contact a/Friction: 0.5, 0.1\nset 2 = Steps: 1, 4, 10\nend\n"
        "subsection Series Amontons (dual mortar)\nset Overrides = M = a\nend\n"
        "subsection Series other\nset Overrides = M = b\nend\n";
    const std::string printed = run("work", text);
    std::cout << printed;
    check::is_true(n_runs == 12, "12 runs");
    check::contains(printed, "Amontons (dual mortar), Friction = 0.5\n");
    check::contains(printed, "1.00e-02 *");
    check::contains(
        printed,
        "Amontons (dual mortar), Friction = 0.5  2 s, 4000 dofs (4)  5 s, 10000 dofs (10)  not reached");
    check::contains(
        printed,
        "other, Friction = 0.1                          not reached           not reached  not reached");
    const std::string script = read_text("out_work/work.gp");
    check::contains(script, "$front_0_3 << END");
    check::contains(script, "0.1 with lines");
    // The four panels stand beside each other, in the upper part of the picture.
    double      right = 0;
    std::size_t at = 0, n_panels = 0;
    while (n_panels < 4 && (at = script.find("set size ", at + 1)) < script.size()) // then the legend
      {
        double wide = 0, high = 0, left = 0, low = 0;
        std::sscanf(script.c_str() + at, "set size %lf, %lf\nset origin %lf, %lf", &wide, &high, &left, &low);
        check::is_close(left, right, 1e-7, "a panel begins where the last one ends", 1);
        check::is_true(high > 0.4 && low > 0 && low + high < 1, "its height");
        right = left + wide;
        ++n_panels;
      }
    check::is_close(right, 1, 1e-7, "panels as wide as the picture");
    check::is_true(n_panels == 4, "a panel for each cost");
    const std::string page = read_text("out_work/work.html");
    for (const std::string text :
         {">6 without an answer<",
          "<td>series other</td><td>M = b</td>",
          "<td>targets</td><td>0.1, 0.01, 1e-06</td>",
          "<th class=\"n\">at most 0.01</th>",
          "<td class=\"n\">5 s, 10000 DoFs</td><td class=\"n\">not reached</td>",
          "<b>other, Friction = 0.1, Steps = 10</b>: not converged: friction cannot hold",
          "--set 'M = b' --set 'Contact a/Friction = 0.1' --set 'Steps = 10'</pre>"})
      check::contains(page, text);
    // Without gnuplot, charts of our own: error against each cost.
    const RunStudy study = read_run_study(StudyEntries("work.prm"));
    StudyResult    result;
    result.point                    = {1, {0, 2}};
    result.record.ending            = "converged";
    result.record.processor_seconds = 2;
    result.record.dofs              = 30;
    result.record.megabytes         = 4;
    result.record.linear_solves     = 5;
    result.errors                   = {0.5};
    const auto charts               = work_charts(study, {result});
    check::is_true(charts.size() == 4 && work_charts(study, {}).empty(), "a chart for each cost");
    check::contains(charts.at(1), "Error of error by degrees of freedom");
    check::contains(charts.at(1), ">other, Friction = 0.5<");
  }

  void
  tables()
  {
    check::is_true(split_csv_line("a,\"b,\"\"c\"\"\",,d") == RunTable::Row({"a", "b,\"c\"", "", "d"}),
                   "quotes");
    SweptParameter parameter{{"Body a/Cells = {}, {}", "Body b/Cells"}, {"3", "44"}, ""};
    check::is_true(parameter.overrides(1) ==
                       std::vector<std::string>({"Body a/Cells = 44, 44", "Body b/Cells = 44"}),
                   "templates");
  }

  void
  messages()
  {
    const std::string sweep = "subsection Sweep\nset 1 = A/B: 1, x\nset 2 = A/C: 1, 2\nend\n";
    message("set Kind = stabilty\n",
            "wrong.prm:3: Kind: found 'stabilty' (did you mean 'stability'?); allowed: convergence, work "
            "precision");
    message(
        "set Kind = stability\nset Per mesh = true\n",
        "wrong.prm:4: Per mesh: it has no meaning in a study of the kind stability; allowed: Kind, Scene");
    message("set Kind = work precision\nset Wrong above = 1\n",
            "wrong.prm:4: Wrong above: it has no meaning");
    message("set Kind = stability\nset Time limit = never\n" + sweep,
            "wrong.prm:4: Time limit: found 'never'; allowed: a positive number");
    message("set Kind = stability\n", "nothing is swept");
    message("set Kind = stability\nset Expected = force\n" + sweep,
            "wrong.prm:4: Expected: found 'force'; allowed: PATH");
    message("set Kind = stability\nset Expected = force = 3*x\n" + sweep, "the values of 'B' are no numbers");
    message("set Kind = stability\nset Expected = force = 3*\n" + sweep, "wrong.prm:4: Expected");
    message("set Kind = stability\nset Threshold = a line\n" + sweep,
            "wrong.prm:4: Threshold: found 'a line'");
    message(
        "set Kind = stability\nset Expected = forse = 1\nsubsection Sweep\nset 1 = A/Friction: 0.5\nend\n",
        "found 'forse', which the summary does not have (did you mean 'force'?)");
    message("set Kind = stability\nsubsection Sweep\nset Label 3 = a\nend\n",
            "wrong.prm:5: Sweep/Label 3: found a label");
    message("set Kind = stability\nsubsection Sweep\nset 1 = A/B = 3: 1, 2\nend\n",
            "does not say where the value stands");
    message("set Kind = stability\nsubsection Sweep\nset 4 = A: 1\nset 1 = B: 1\nset 2 = C: 1\nset 3 = D: "
            "1\nend\n",
            "wrong.prm:5: Sweep/4: a map has two axes");
    message("set Kind = work precision\n" + sweep, "Quantities: no quantity is given");
    message("set Kind = work precision\nset Quantities = error\nset Targets = 0.1, small\n" + sweep,
            "wrong.prm:5: Targets: found 'small'");
    message("set Kind = stability\nsubsection Serie a\nset Overrides = A = 1\nend\n",
            "wrong.prm:4: Serie a: found the section 'Serie a'; allowed: Sweep, Series NAME");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  fs::remove_all("run_study_files");
  fs::create_directories("run_study_files");
  fs::current_path("run_study_files");
  std::ofstream("scene.prm") << "set Title = nothing\n";
  maps();
  goes_on();
  outcomes();
  fronts();
  tables();
  messages();
  return check::result();
}
} // namespace test_run_study

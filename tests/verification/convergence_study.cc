// A study of a known error C / N gives the order 2 in 2D, in tables, CSV and chart, from many runs or from
// many meshes.
#include <amontons/verification/convergence_study.h>
#include <amontons/verification/study_output.h>

#include <text_checks.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_convergence_study
{
using namespace Amontons;
namespace fs = std::filesystem;
using Tree   = boost::property_tree::ptree;

namespace
{
  std::vector<std::vector<std::string>> calls;

  // The value of the override "... NAME = value".
  double
  value_of(const std::vector<std::string> &overrides, const std::string &name, const double otherwise)
  {
    for (const std::string &text : overrides)
      if (text.find(name + " = ") != std::string::npos)
        return std::stod(text.substr(text.find('=') + 1));
    return otherwise;
  }

  Tree
  mesh(const double n, const double degree)
  {
    Tree tree;
    tree.put("cells", n / (degree * degree));
    tree.put("dofs", 2 * n);
    tree.put("seconds", 1e-4 * n);
    tree.put("reference.errors.contact_size", 3 * std::pow(n, -degree));
    tree.put("reference.errors.pressure_l2", 5 * std::pow(n, -degree / 2));
    tree.put("reference.force", 10 + std::pow(n, -1));
    return tree;
  }

  Tree
  fake(const std::string &, const std::vector<std::string> &overrides)
  {
    calls.push_back(overrides);
    const double refinements = value_of(overrides, "Refinements", 5);
    if (refinements == 13)
      throw std::runtime_error("no convergence");
    const double degree = value_of(overrides, "Degree", 1);
    Tree         tree   = mesh(16 * std::pow(4, refinements), degree);
    tree.put("dimension", 2);
    tree.put("finest_mesh_seconds", tree.get<double>("seconds"));
    tree.put("wall_seconds", 2 * tree.get<double>("seconds"));
    Tree meshes;
    meshes.push_back({"", mesh(16, degree)}); // of an earlier increment: no row
    for (unsigned int i = 0; i <= refinements; ++i)
      meshes.push_back({"", mesh(16 * std::pow(4, i), degree)}), meshes.back().second.put("increment", 1);
    tree.add_child("meshes", meshes);
    return tree;
  }

  // Writes NAME.prm with `text`, runs it, and returns what was printed.
  std::string
  study(const std::string &name, const std::string &text, const int expected = 0)
  {
    std::ofstream(name + ".prm") << "set Scene = ../scene.prm\nset Output = out_" << name << "\n" << text;
    std::ostringstream out;
    calls.clear();
    check::is_true(run_convergence_study(name + ".prm", fake, out, MPI_COMM_WORLD) == expected,
                   name + ": return value");
    for (const std::string ending : {".csv", ".gp", ".html"})
      check::is_true(fs::exists("out_" + name + "/" + name + ending), name + ending + " exists");
    if (std::system("command -v gnuplot >/dev/null 2>&1") == 0)
      check::is_true(fs::exists("out_" + name + "/" + name + ".svg"), name + ".svg exists");
    return out.str();
  }

  std::string
  page(const std::string &name)
  {
    std::ostringstream text;
    text << std::ifstream("out_" + name + "/" + name + ".html").rdbuf();
    return text.str();
  }

  std::vector<std::vector<std::string>>
  csv(const std::string &name)
  {
    std::ifstream                         file("out_" + name + "/" + name + ".csv");
    std::vector<std::vector<std::string>> rows;
    std::string                           line, cell;
    while (std::getline(file, line))
      {
        rows.emplace_back();
        std::istringstream cells(line + ",");
        while (std::getline(cells, cell, ','))
          rows.back().push_back(cell);
      }
    return rows;
  }

  void
  message(const std::string &text, const std::string &part)
  {
    try
      {
        study("wrong", text);
        check::is_true(false, "no error for " + text);
      }
    catch (const InputError &error)
      {
        check::contains(error.what(), part);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  fs::create_directories("convergence_study_files");
  fs::current_path("convergence_study_files");
  const std::string quantities =
      "set Quantities = reference.errors.contact_size, reference.errors.pressure_l2\n";

  const std::string printed =
      study("uniform",
            quantities + "set Title = Cylinder on a plane: uniform_refinement, known errors\n"
                         "set Overrides = A/B = 1 | C/D = x\nsubsection Sweep\n"
                         "set 1 = Discretization/Degree: 1, 2\n"
                         "set 2 = Body a/Refinements & Body b/Refinements: 1, 2, 3, 4\nend\n");
  std::cout << printed;
  check::is_true(calls.size() == 8 && calls[0].size() == 5, "eight runs with five overrides");
  check::is_true(calls[7][4] == "Body b/Refinements = 4" && calls[7][1] == "C/D = x",
                 "overrides of the last run");
  check::contains(printed, "2.00");
  check::contains(printed, "Degree = 2");
  auto rows = csv("uniform");
  check::is_true(rows.size() == 9, "eight rows and a header");
  check::is_true(rows[1][7].empty(), "no order in the first row");
  for (unsigned int r = 1; r < rows.size(); ++r)
    if (!rows[r][7].empty())
      check::is_close(std::stod(rows[r][7]), r > 4 ? 4 : 2, 1e-8, "order");
  for (const std::string text : {"<h1>Cylinder on a plane: uniform_refinement, known errors</h1>",
                                 "class=\"status good\">all runs converged<",
                                 "<td>swept: Degree</td><td>1, 2   (Discretization/Degree)</td>",
                                 "<td>all runs with</td><td>A/B = 1 | C/D = x</td>",
                                 "<pre>amontons study uniform.prm</pre>",
                                 "<b>Degree = 2</b>",
                                 "<svg"})
    check::contains(page("uniform"), text);
  // Refinements 3 after 2 with linear elements: 2048 unknowns, 3/1024, a quarter of that before.
  check::contains(
      page("uniform"),
      "<td>3</td><td class=\"n\">1024</td><td class=\"n\">2048</td><td class=\"n\">0.1024</td><td "
      "class=\"n\">0.2048</td><td class=\"n\">0.0029297</td><td class=\"n\">2</td>");
  check::is_close(observed_order(1, .25, 100, 400, 2), 2, 1e-12, "order in 2D");
  check::is_close(observed_order(1, .25, 100, 800, 3), 2, 1e-12, "order in 3D");

  study("adaptive",
        quantities + "set Per mesh = true\nsubsection Sweep\nset 1 = Discretization/Degree: 1, 2\nend\n");
  rows = csv("adaptive");
  check::is_true(calls.size() == 2 && rows.size() == 13, "two runs of six meshes");
  check::is_close(std::stod(rows[3][6]), 2, 1e-8, "order of an adaptive series");

  study("finest",
        "set Quantities = reference.force, meshes.1.reference.force\nset Against = finest\nset Vary = "
        "1\nsubsection Sweep\n"
        "set 1 = B/Refinements: 1 | 2 | 8\nset 2 = Discretization/Degree: 1\nend\n");
  rows = csv("finest");
  check::is_true(rows.size() == 3, "the last run is the reference");
  check::is_close(std::stod(rows[2][7]), 2, 1e-2, "order against the finest");

  const std::string failed =
      study("failed", quantities + "subsection Sweep\nset 1 = B/Refinements: 1, 13\nend\n", 1);
  check::contains(failed, "no convergence");
  for (const std::string text : {">1 run failed<",
                                 "<b>Refinements = 13</b>: no convergence",
                                 "<pre>amontons ../scene.prm --set 'B/Refinements = 13'</pre>"})
    check::contains(page("failed"), text);

  message(quantities + "set Agianst = finest\n",
          "wrong.prm:4: Agianst: there is no such entry (did you mean 'Against'?)");
  message(quantities + "set Against = finnest\n", "found 'finnest'; allowed: closed form, finest");
  message(quantities + "subsection Sweep\nset 1 = Degree\nend\n", "wrong.prm:5");
  message("set Quantities = reference.errors.contact_sise\nsubsection Sweep\nset 1 = A/B: 1\nend\n",
          "wrong.prm:3: Quantities: found 'reference.errors.contact_sise', which the summary does not have "
          "(did you mean");
  return check::result();
}
} // namespace test_convergence_study

// Each row of history.csv has the fields of the header, also where meshes know different things; each number
// stands under its name.
#include "check.h"

#include <amontons/output/history.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace test_history
{
using namespace Amontons;

// Each number stands under its name.
void
check_columns(const std::string &file)
{
  MeshSummary row;
  row.increment         = 2;
  row.mesh              = 3;
  row.t                 = 0.4;
  row.cells             = 5;
  row.dofs              = 6;
  row.iterations        = 7;
  row.krylov_iterations = 8;
  row.residual          = 0.9;
  row.pairs.resize(2);
  for (unsigned int i = 0; i < 2; ++i)
    {
      PairSummary &pair     = row.pairs[i];
      const double shift    = 100 * i;
      pair.name             = i == 0 ? "a" : "b";
      pair.normal_force     = {10 + shift, 11 + shift};
      pair.tangential_force = {12 + shift, 13 + shift};
      pair.peak_pressure    = 14 + shift;
      pair.contact_size     = 15 + shift;
      pair.stick_size       = 16 + shift;
      pair.n_open           = 17 + shift;
      pair.n_stick          = 18 + shift;
      pair.n_slip           = 19 + shift;
    }
  row.error_estimate = {0.21, 0.22};
  row.energy         = 23;
  row.external_work  = 24;
  row.contact_work   = 25;
  row.dissipation    = 22.5;
  row.probes         = {
              {"p", {{{0, 0}, {31, 32}, {33, 34, 35, 36}, 37}}},
              {"line", {{{0, 0}, {41, 42}, {43, 44, 45, 46}, 47}, {{0, 0}, {51, 52}, {53, 54, 55, 56}, 57}}}};

  const std::map<std::string, double> plane        = {{"increment", 2},
                                                      {"t", 0.4},
                                                      {"mesh", 3},
                                                      {"cells", 5},
                                                      {"dofs", 6},
                                                      {"iterations", 7},
                                                      {"krylov", 8},
                                                      {"residual", 0.9},
                                                      {"a.normal_force_x", 10},
                                                      {"a.normal_force_y", 11},
                                                      {"a.tangential_force_x", 12},
                                                      {"a.tangential_force_y", 13},
                                                      {"a.peak_pressure", 14},
                                                      {"a.contact_size", 15},
                                                      {"a.stick_size", 16},
                                                      {"a.n_open", 17},
                                                      {"a.n_stick", 18},
                                                      {"a.n_slip", 19},
                                                      {"b.normal_force_x", 110},
                                                      {"b.normal_force_y", 111},
                                                      {"b.tangential_force_x", 112},
                                                      {"b.tangential_force_y", 113},
                                                      {"b.peak_pressure", 114},
                                                      {"b.contact_size", 115},
                                                      {"b.stick_size", 116},
                                                      {"b.n_open", 117},
                                                      {"b.n_stick", 118},
                                                      {"b.n_slip", 119},
                                                      {"error_bulk", 0.21},
                                                      {"error_contact", 0.22},
                                                      {"energy", 23},
                                                      {"external_work", 24},
                                                      {"contact_work", 25},
                                                      {"dissipation", 22.5},
                                                      {"contact_work_minus_dissipation", 2.5},
                                                      {"p.u_x", 31},
                                                      {"p.u_y", 32},
                                                      {"p.stress_xx", 33},
                                                      {"p.stress_yy", 34},
                                                      {"p.stress_zz", 35},
                                                      {"p.stress_xy", 36},
                                                      {"p.von_mises", 37},
                                                      {"line[0].u_x", 41},
                                                      {"line[0].von_mises", 47},
                                                      {"line[1].u_y", 52},
                                                      {"line[1].stress_xy", 56},
                                                      {"line[1].von_mises", 57}};
  const std::map<std::string, double> axisymmetric = {{"a.normal_force_r", 10},
                                                      {"a.normal_force_z", 11},
                                                      {"p.u_r", 31},
                                                      {"p.u_z", 32},
                                                      {"p.stress_rr", 33},
                                                      {"p.stress_zz", 34},
                                                      {"p.stress_tt", 35},
                                                      {"p.stress_rz", 36}};
  for (const auto &[kind, wanted] : {std::make_pair(ProblemType::plane_stress, plane),
                                     std::make_pair(ProblemType::axisymmetric, axisymmetric)})
    {
      write_history(file, {row}, kind);
      std::ifstream                 stream(file);
      std::string                   header, numbers, name, number;
      std::map<std::string, double> found;
      std::getline(stream, header);
      std::getline(stream, numbers);
      std::istringstream names(header), values(numbers);
      while (std::getline(names, name, ',') && std::getline(values, number, ','))
        found[name] = std::strtod(number.c_str(), nullptr);
      for (const auto &[column, value] : wanted)
        {
          check::is_true(found.count(column) == 1, "column " + column);
          check::is_close(found[column], value, 0, column);
        }
    }
  std::remove(file.c_str());
}

int
main(int, char **)
{
  MeshSummary plain;
  plain.increment = 1;
  plain.pairs.resize(1);
  plain.pairs[0].name            = "a, b";
  MeshSummary friction           = plain;
  friction.pairs[0].stick_size   = 0.5;
  friction.pairs[0].normal_force = {0, -2};
  friction.external_work         = 3;
  friction.contact_work          = 2;
  friction.dissipation           = 0.5;
  const std::string folder       = std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp";
  const std::string file         = folder + "/amontons_test_history.csv";
  write_history(file, {plain, friction, plain}, ProblemType::plane_strain);

  std::ifstream            stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  std::remove(file.c_str());
  check::is_true(lines.size() == 4, "a header and three rows");
  // The name of the pair is quoted, with a comma in it, once for each of its columns.
  const auto commas = [](const std::string &line) { return std::count(line.begin(), line.end(), ','); };
  check::is_true(commas(lines[0]) - 10 == commas(lines[1]), "fields of the first row: " + lines[1]);
  check::is_true(commas(lines[1]) == commas(lines[2]) && commas(lines[2]) == commas(lines[3]),
                 "all rows alike");
  check::is_true(lines[0].find("contact_work_minus_dissipation") != std::string::npos, "header: " + lines[0]);
  const std::string end = ",3,2,0.5,1.5";
  check::is_true(lines[2].size() > end.size() && lines[2].substr(lines[2].size() - end.size()) == end,
                 "works of the second row: " + lines[2]);
  check::is_true(lines[1].substr(lines[1].size() - 16) == ",nan,nan,nan,nan", "first row: " + lines[1]);
  check_columns(file);
  return check::result();
}
} // namespace test_history

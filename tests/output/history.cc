// Each row of history.csv has the fields of the header, also where meshes know different things.
#include "check.h"

#include <amontons/output/history.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

using namespace Amontons;

int
main()
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
  write_history(file, {plain, friction, plain}, Kind::plane_strain);

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
  return check::result();
}

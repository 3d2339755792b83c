// summary.json: each number stands under its name, unknown ones are null, and what is not there is left out.
#include "check.h"

#include <amontons/output/summary.h>

#include <boost/property_tree/json_parser.hpp>

#include <cstdlib>
#include <filesystem>

#include <unistd.h>

namespace test_summary
{
using namespace Amontons;
using Tree = boost::property_tree::ptree;

const std::string file =
    (std::filesystem::temp_directory_path() / ("amontons_summary_" + std::to_string(getpid()) + ".json"))
        .string();

Tree
written(const RunSummary &summary)
{
  write_summary(summary, file);
  Tree tree;
  boost::property_tree::read_json(file, tree);
  std::remove(file.c_str());
  return tree;
}

// Element i of an array.
const Tree &
item(const Tree &array, const unsigned int i)
{
  return std::next(array.begin(), i)->second;
}

void
expect(const Tree &tree, const std::string &path, const std::string &text)
{
  const auto found = tree.get_optional<std::string>(path);
  check::is_true(found.has_value() && *found == text,
                 path + ": '" + (found ? *found : std::string("nothing")) + "', expected '" + text + "'");
}

void
expect_list(const Tree &tree, const std::string &path, const std::vector<std::string> &texts)
{
  const auto found = tree.get_child_optional(path);
  check::is_true(found.has_value() && found->size() == texts.size(), path + ": size");
  for (unsigned int i = 0; found && i < std::min(found->size(), texts.size()); ++i)
    check::is_true(item(*found, i).data() == texts[i],
                   path + ": " + item(*found, i).data() + ", expected " + texts[i]);
}

PairSummary
numbered_pair()
{
  PairSummary pair;
  pair.name                 = "a";
  pair.normal_force         = {1.5, 2.5};
  pair.tangential_force     = {3.5, 4.5};
  pair.peak_pressure        = 5.5;
  pair.contact_size         = 6.5;
  pair.stick_size           = 7.5;
  pair.centre               = {8.5, 9.5};
  pair.n_open               = 10;
  pair.n_stick              = 11;
  pair.n_slip               = 12;
  pair.n_without_multiplier = 13;
  return pair;
}

void
expect_pair(const Tree &tree)
{
  expect(tree, "name", "a");
  expect_list(tree, "normal_force", {"1.5", "2.5"});
  expect_list(tree, "tangential_force", {"3.5", "4.5"});
  expect(tree, "peak_pressure", "5.5");
  expect(tree, "contact_size", "6.5");
  expect(tree, "stick_size", "7.5");
  expect_list(tree, "centre", {"8.5", "9.5"});
  expect(tree, "n_open", "10");
  expect(tree, "n_stick", "11");
  expect(tree, "n_slip", "12");
  expect(tree, "n_without_multiplier", "13");
}

int
main(int, char **)
{
  RunSummary summary;
  summary.converged               = true;
  summary.message                 = "a message";
  summary.scene                   = "scene.prm";
  summary.title                   = "A title";
  summary.kind                    = ProblemType::axisymmetric;
  summary.dofs                    = 20;
  summary.cells                   = 21;
  summary.ranks                   = 22;
  summary.failure                 = "a kind";
  summary.n_cut_backs             = 76;
  summary.cost                    = {23.5, {{"mesh", 24.5}}, 77, 25.5, 26.5};
  summary.energy                  = 27.5;
  summary.error_estimate          = {28.5, 29.5};
  summary.pairs                   = {numbered_pair()};
  summary.reactions               = {{"wall", "b/left", {30.5, 31.5}, {32.5}}};
  summary.checks["force_balance"] = 33.5;
  summary.notes                   = {"one note"};
  summary.probes                  = {{"p", {{{34.5, 35.5}, {36.5, 37.5}, {38.5, 39.5, 40.5, 41.5}, 42.5}}},
                                     {"outside", {{{1, 1}, {}, {}}}}};
  NewtonSummary newton;
  newton.increment          = 50;
  newton.mesh               = 51;
  newton.dofs               = 52;
  newton.cells              = 53;
  newton.iterations         = 2;
  newton.active_set_changes = {54, 55};
  newton.krylov_iterations  = 56;
  newton.residual           = 57.5;
  newton.residuals          = {58.5, 57.5};
  summary.newton            = {newton};
  MeshSummary mesh;
  mesh.increment      = 60;
  mesh.mesh           = 61;
  mesh.t              = 62.5;
  mesh.cells          = 63;
  mesh.dofs           = 64;
  mesh.iterations     = 65;
  mesh.seconds        = 66.5;
  mesh.pairs          = {numbered_pair()};
  mesh.error_estimate = {67.5, 68.5};
  mesh.energy         = 69.5;
  summary.meshes      = {mesh};
  mesh.external_work  = 70.5;
  mesh.contact_work   = 71.5;
  mesh.dissipation    = 72.5;
  ReferenceSummary reference;
  reference.closed_form            = "hertz";
  reference.errors["contact_size"] = 73.5;
  reference.values["contact_size"] = {{74.5, 75.5}};
  mesh.reference = summary.reference = reference;
  summary.meshes.push_back(mesh);

  const Tree tree = written(summary);
  expect(tree, "status", "converged");
  expect(tree, "message", "a message");
  expect(tree, "scene", "scene.prm");
  expect(tree, "title", "A title");
  expect(tree, "dimension", "2");
  expect(tree, "kind", "axisymmetric");
  expect(tree, "dofs", "20");
  expect(tree, "cells", "21");
  expect(tree, "ranks", "22");
  expect(tree, "wall_seconds", "23.5");
  expect(tree, "timing.mesh", "24.5");
  expect(tree, "failure", "a kind");
  expect(tree, "cut_backs", "76");
  expect(tree, "linear_solves", "77");
  expect(tree, "one_linear_solve_seconds", "25.5");
  expect(tree, "finest_mesh_seconds", "26.5");
  expect(tree, "energy", "27.5");
  expect(tree, "error_estimate.bulk", "28.5");
  expect(tree, "error_estimate.contact", "29.5");
  expect_pair(item(tree.get_child("pairs"), 0));
  const Tree &reaction = item(tree.get_child("reactions"), 0);
  expect(reaction, "condition", "wall");
  expect(reaction, "boundary", "b/left");
  expect_list(reaction, "force", {"30.5", "31.5"});
  expect_list(reaction, "moment", {"32.5"});
  expect(tree, "checks.force_balance", "33.5");
  expect_list(tree, "notes", {"one note"});

  const Tree &point = item(item(tree.get_child("probes"), 0).get_child("points"), 0);
  expect(item(tree.get_child("probes"), 0), "name", "p");
  expect_list(point, "point", {"34.5", "35.5"});
  expect_list(point, "displacement", {"36.5", "37.5"});
  expect(point, "stress.rr", "38.5");
  expect(point, "stress.zz", "39.5");
  expect(point, "stress.tt", "40.5");
  expect(point, "stress.rz", "41.5");
  expect(point, "von_mises", "42.5");
  expect(item(item(tree.get_child("probes"), 1).get_child("points"), 0), "displacement", "null");

  const Tree &solve = item(tree.get_child("newton"), 0);
  expect(solve, "increment", "50");
  expect(solve, "mesh", "51");
  expect(solve, "dofs", "52");
  expect(solve, "cells", "53");
  expect(solve, "iterations", "2");
  expect_list(solve, "active_set_changes", {"54", "55"});
  expect(solve, "krylov_iterations", "56");
  expect(solve, "residual", "57.5");
  expect_list(solve, "residuals", {"58.5", "57.5"});

  const Tree &first = item(tree.get_child("meshes"), 0), &second = item(tree.get_child("meshes"), 1);
  expect(second, "increment", "60");
  expect(second, "mesh", "61");
  expect(second, "t", "62.5");
  expect(second, "cells", "63");
  expect(second, "dofs", "64");
  expect(second, "iterations", "65");
  expect(second, "seconds", "66.5");
  expect_pair(item(second.get_child("pairs"), 0));
  expect(second, "error_estimate.bulk", "67.5");
  expect(second, "error_estimate.contact", "68.5");
  expect(second, "energy", "69.5");
  expect(second, "external_work", "70.5");
  expect(second, "contact_work", "71.5");
  expect(second, "dissipation", "72.5");
  for (const Tree *of : {&tree, &second})
    {
      expect(*of, "reference.closed_form", "hertz");
      expect(*of, "reference.errors.contact_size", "73.5");
      expect_list(*of, "reference.values.contact_size", {"74.5", "75.5"});
    }
  check::is_true(first.count("dissipation") == 0 && first.count("reference") == 0,
                 "left out where not known");

  const Tree nothing = written(RunSummary());
  expect(nothing, "status", "not converged");
  expect(nothing, "energy", "null");
  expect(nothing, "error_estimate.contact", "null");
  return check::result();
}
} // namespace test_summary

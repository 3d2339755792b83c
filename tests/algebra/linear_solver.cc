// A factorisation whose workspace is too small is made again with more; one that memory does not hold is told
// as that, and nothing is written to stderr beside it. A solve that is given up fails at that step, and all
// further ones at once.
#include "check.h"

#include <amontons/algebra/linear_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace test_linear_solver
{
using namespace Amontons;

// n^3 nodes of a grid, the seven-point Laplacian, with a slope that makes it unsymmetric.
LA::SparseMatrix
laplacian(const unsigned int n, const bool symmetric)
{
  const IndexSet         all = complete_index_set(n * n * n);
  DynamicSparsityPattern pattern(n * n * n);
  const auto             for_neighbours = [&](const auto &visit) {
    for (unsigned int i = 0; i < n * n * n; ++i)
      for (unsigned int stride = 1, place = i; stride < n * n * n; stride *= n, place /= n)
        {
          if (place % n > 0)
            visit(i, i - stride, -1.);
          if (place % n + 1 < n)
            visit(i, i + stride, symmetric ? -1. : -0.5);
        }
  };
  for (unsigned int i = 0; i < n * n * n; ++i)
    pattern.add(i, i);
  for_neighbours([&](const unsigned int i, const unsigned int j, const double) { pattern.add(i, j); });
  LA::SparseMatrix matrix;
  matrix.reinit(all, all, pattern, MPI_COMM_SELF);
  for (unsigned int i = 0; i < n * n * n; ++i)
    matrix.set(i, i, 6.5);
  for_neighbours(
      [&](const unsigned int i, const unsigned int j, const double value) { matrix.set(i, j, value); });
  matrix.compress(VectorOperation::insert);
  return matrix;
}

// What a solve wrote to stderr.
template <typename Function>
std::string
said(const Function &function)
{
  char      name[] = "linear_solver_XXXXXX";
  const int file = mkstemp(name), before = dup(STDERR_FILENO);
  std::fflush(stderr);
  dup2(file, STDERR_FILENO);
  function();
  std::fflush(stderr);
  dup2(before, STDERR_FILENO);
  close(before);
  close(file);
  std::ostringstream text;
  text << std::ifstream(name).rdbuf();
  std::remove(name);
  return text.str();
}

LinearSolveReport
solve(const unsigned int n, const bool symmetric, const int workspace, double &error, std::string &words)
{
  LinearSolverParameters parameters;
  parameters.type               = "direct";
  parameters.direct_package     = "Amesos_Mumps";
  parameters.workspace          = workspace;
  const LA::SparseMatrix matrix = laplacian(n, symmetric);
  LA::Vector             x(complete_index_set(n * n * n), MPI_COMM_SELF), rhs(x), expected(x);
  for (unsigned int i = 0; i < n * n * n; ++i)
    expected(i) = std::sin(i);
  expected.compress(VectorOperation::insert);
  matrix.vmult(rhs, expected);
  LinearSolver      solver(parameters, 3, 1, symmetric);
  LinearSolveReport report;
  words = said([&] { report = solver.solve(matrix, x, rhs, 1e-10); });
  x -= expected;
  error = x.linfty_norm();
  return report;
}

// after: how often it is asked before it is. Three unknowns to a node, as multigrid takes them: of 15^3.
void
give_up(const bool symmetric, const unsigned int after)
{
  LinearSolverParameters parameters;
  parameters.type               = "cg";
  const LA::SparseMatrix matrix = laplacian(15, symmetric);
  LA::Vector             x(complete_index_set(matrix.m()), MPI_COMM_SELF), rhs(x);
  rhs                  = 1;
  unsigned int n_asked = 0;
  LinearSolver solver(parameters, 3, 1, symmetric, [&]() { return n_asked++ == after; });
  for (const unsigned int asked : {after + 1, after + 1})
    {
      const auto report = solver.solve(matrix, x, rhs, 1e-12 * rhs.l2_norm());
      check::is_true(!report.success && report.given_up && n_asked == asked,
                     "given up after " + std::to_string(after) + " questions: asked " +
                         std::to_string(n_asked));
    }
}

// A hierarchy of the matrix before serves on; it is made anew once it has cost as many steps more as that
// takes, and a system that is solved already takes none.
void
keep_hierarchy()
{
  LinearSolverParameters parameters;
  parameters.type         = "cg";
  LA::SparseMatrix matrix = laplacian(15, false), changed = laplacian(15, false);
  for (unsigned int i = 0; i < changed.m(); i += 40) // some rows are stiffer
    changed.set(i, i, 65);
  changed.compress(VectorOperation::insert);
  LA::Vector x(complete_index_set(matrix.m()), MPI_COMM_SELF), rhs(x);
  rhs                    = 1;
  const double tolerance = 1e-8 * rhs.l2_norm();
  const auto   steps     = [&](LinearSolver &solver, const LA::SparseMatrix &of) {
    const auto report = solver.solve(of, x, rhs, tolerance);
    check::is_true(report.success, "multigrid solves");
    return report.iterations;
  };
  LinearSolver       other(parameters, 3, 1, false);
  const unsigned int fresh = steps(other, changed);
  LinearSolver       solver(parameters, 3, 1, false);
  steps(solver, matrix);
  solver.matrix_changed(changed.m() / 15);
  unsigned int n = 0, lost = 0;
  for (unsigned int now = steps(solver, changed); now > fresh && n < 20; now = steps(solver, changed), ++n)
    lost += now - fresh;
  check::is_true(n > 1 && n < 20 && lost > 15 && lost < 60, // a single solve that loses 60 ends at once
                 "a new hierarchy takes " + std::to_string(fresh) + " steps; the old one took " +
                     std::to_string(lost) + " more in " + std::to_string(n) + " solves");
  x = 1;
  check::is_true(solver.solve(changed, x, rhs, 2 * rhs.l2_norm()).iterations == 0 && x.l2_norm() == 0,
                 "nothing to solve");
}

// More columns than are solved at once, one of them zero.
void
many_columns(const bool symmetric, const std::string &package)
{
  LinearSolverParameters parameters;
  parameters.type                = "direct";
  parameters.direct_package      = package;
  const LA::SparseMatrix  matrix = laplacian(9, symmetric);
  LA::Vector              x(complete_index_set(matrix.m()), MPI_COMM_SELF), rhs(x);
  std::vector<LA::Vector> expected, columns;
  for (unsigned int k = 0; k < 40; ++k)
    {
      for (unsigned int i = 0; i < matrix.m(); ++i)
        x(i) = k == 7 ? 0 : std::sin(i * (k + 1));
      x.compress(VectorOperation::insert);
      matrix.vmult(rhs, x);
      expected.push_back(x);
      columns.push_back(rhs);
    }
  LinearSolver solver(parameters, 2, 1, symmetric);
  for (const bool has_factors : {false, true})
    {
      auto solutions = columns;
      check::is_true(solver.has_factors() == has_factors, "factors: those of the solve before");
      solver.solve(matrix, solutions);
      double error = 0;
      for (unsigned int k = 0; k < columns.size(); ++k)
        {
          solutions[k] -= expected[k];
          error = std::max(error, solutions[k].linfty_norm());
        }
      check::is_true(error < 1e-12, package + ": columns are off by " + std::to_string(error));
    }
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  double                           error = 0;
  std::string                      words;
  for (const bool symmetric : {true, false})
    for (const int workspace : {20, -95})
      {
        const std::string what =
            std::string(symmetric ? "symmetric" : "unsymmetric") + ", workspace " + std::to_string(workspace);
        const LinearSolveReport report = solve(14, symmetric, workspace, error, words);
        check::is_true(report.success && !report.no_memory, what + " is solved");
        check::is_true(error < 1e-12, what + ": error " + std::to_string(error));
        check::is_true(words.empty(), what + " says '" + words + "'");
      }

  for (const bool symmetric : {true, false})
    for (const unsigned int after : {0, 1, 3}) // before the first step, at its start, at the sixteenth
      give_up(symmetric, after);
  keep_hierarchy();
  for (const bool symmetric : {true, false})
    for (const char *const package : {"Amesos_Mumps", "Amesos_Klu"})
      many_columns(symmetric, package);

  std::ifstream("/proc/self/statm") >> error; // pages of addresses
  rlimit limit;
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = rlim_t(error) * sysconf(_SC_PAGESIZE) + (rlim_t(60) << 20);
  setrlimit(RLIMIT_AS, &limit);
  const LinearSolveReport report = solve(40, true, 20, error, words);
  check::is_true(!report.success && report.no_memory, "64000 unknowns do not fit into 60 MB");
  check::is_true(words.empty(), "without memory it says '" + words + "'");
  return check::result();
}
} // namespace test_linear_solver

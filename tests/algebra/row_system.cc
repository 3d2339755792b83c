// The tangent of large sliding is C_test^T (K + further + diagonal) on what the supports leave, with the
// written rows in the place of eliminated test functions; multigrid's matrix is C_test^T (K + diagonal)
// C_trial. Cells with and without constraints, friction, a second assembly with another set.
#include "check.h"

#include <amontons/algebra/row_system.h>

#include <deal.II/base/mpi.h>

#include <random>

namespace test_row_system
{
using namespace Amontons;

using Matrix = FullMatrix<double>;
using Dofs   = std::vector<types::global_dof_index>;

const unsigned int n_nodes = 10, n_components = 2, n = n_nodes * n_components;
std::mt19937       generator(1);

double
random_number()
{
  return std::uniform_real_distribution<double>(-1, 1)(generator);
}

Matrix
random_matrix(const unsigned int rows, const unsigned int columns)
{
  Matrix result(rows, columns);
  for (unsigned int i = 0; i < rows; ++i)
    for (unsigned int j = 0; j < columns; ++j)
      result(i, j) = random_number();
  return result;
}

Dofs
dofs_of(const std::vector<unsigned int> &nodes)
{
  Dofs result;
  for (const unsigned int node : nodes)
    for (unsigned int c = 0; c < n_components; ++c)
      result.push_back(n_components * node + c);
  return result;
}

// Node 0 is held, 1 along x only; 9 hangs between 7 and 8.
Constraints
make_supports()
{
  Constraints supports(complete_index_set(n));
  for (const unsigned int dof : {0, 1, 2})
    supports.add_line(dof);
  for (unsigned int c = 0; c < n_components; ++c)
    {
      supports.add_line(18 + c);
      supports.add_entry(18 + c, 14 + c, 0.5);
      supports.add_entry(18 + c, 16 + c, 0.5);
    }
  supports.close();
  return supports;
}

// Column j: what unit displacement of DoF j means for all; 0 for constrained j.
Matrix
expansion(const Constraints &constraints)
{
  Matrix result(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for_each_entry(constraints, i, [&](const auto j, const double weight) { result(i, j) += weight; });
  return result;
}

void
add_block(const Matrix &block, const Dofs &rows, const Dofs &columns, Matrix &sum)
{
  for (unsigned int i = 0; i < rows.size(); ++i)
    for (unsigned int j = 0; j < columns.size(); ++j)
      sum(rows[i], columns[j]) += block(i, j);
}

// left^T A right
Matrix
condensed(const Matrix &left, const Matrix &A, const Matrix &right)
{
  Matrix half(n, n), result(n, n);
  left.Tmmult(half, A);
  half.mmult(result, right);
  return result;
}

void
compare(const LA::SparseMatrix &found,
        const Matrix           &expected,

        const std::string &what)
{
  double error = 0;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      error = std::max(error, std::abs(found.el(i, j) - expected(i, j)));
  check::is_close(error, 0, 1e-14, what, 1);
}

struct Problem
{
  Problem()
      : supports(make_supports()),
        nodes({{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 6, 7}, {6, 7, 8, 9}, {1, 3, 8, 9}}),
        system(complete_index_set(n), complete_index_set(n), n_components, MPI_COMM_SELF)
  {
    for (const auto &of_cell : nodes)
      {
        const Matrix a = random_matrix(8, 8);
        Matrix       k(8, 8);
        a.mTmult(k, a);
        dofs.push_back(dofs_of(of_cell));
        matrices.push_back(k);
      }
    cells.n      = dofs.size();
    cells.dofs   = [&](const unsigned int c) -> const Dofs   &{ return dofs[c]; };
    cells.matrix = [&](const unsigned int c) { return matrices[c]; };
  }

  // equations: of trial functions, with `test` where there is friction.
  void
  check_with(const std::vector<ContactEquation> &equations, const std::string &what)
  {
    const ContactConstraints contact(supports, equations);
    std::vector<LocalMatrix> further = {{dofs_of({2, 3, 6}), dofs_of({4, 9}), random_matrix(6, 4)},
                                        {{10}, dofs_of({1, 7}), random_matrix(1, 4)}};
    std::vector<ContactRow>  rows;
    std::vector<bool>        is_written(n, false);
    for (const auto &pivot : contact.pivots())
      {
        check::is_true(pivot.has_value(), what + ": all equations have pivots");
        rows.push_back({*pivot, {{{*pivot, 1.}, {12, random_number()}, {19, random_number()}}, 0.1}});
        is_written[*pivot] = true;
      }
    LA::Vector diagonal(complete_index_set(n), MPI_COMM_SELF);
    diagonal = 0.;
    for (const unsigned int dof : {3, 6, 7, 13})
      diagonal(dof) = 0.3 + dof;
    diagonal.compress(VectorOperation::insert);

    system.link(supports, contact, further, rows);
    system.assemble(cells, supports, contact, further, &diagonal, rows, true);

    Matrix K(n, n), with_further;
    for (unsigned int c = 0; c < cells.n; ++c)
      add_block(matrices[c], dofs[c], dofs[c], K);
    for (unsigned int i = 0; i < n; ++i)
      K(i, i) += diagonal(i);
    with_further = K;
    for (const auto &part : further)
      add_block(part.matrix, part.rows, part.columns, with_further);

    const Matrix test = expansion(contact.test()), trial = expansion(contact.trial()),
                 free = expansion(supports);
    Matrix expected   = condensed(test, with_further, free);
    for (unsigned int i = 0; i < n; ++i)
      if (supports.is_constrained(i))
        expected(i, i) = system.row_scale(i);
    for (const auto &row : rows)
      for (const auto &[dof, coefficient] : row.equation.coefficients)
        for_each_entry(supports, dof, [&](const auto j, const double weight) {
          expected(row.row, j) += system.row_scale(row.row) * weight * coefficient;
        });
    compare(system.matrix(), expected, what + ": tangent");

    expected = condensed(test, K, trial);
    for (unsigned int i = 0; i < n; ++i)
      if (contact.trial().is_constrained(i))
        expected(i, i) = system.row_scale(i);
    compare(*system.eliminated_form().matrix, expected, what + ": multigrid's matrix");
    for (const auto &[dof, entry] : system.eliminated_form().written)
      check::is_true(is_written[dof] && entry == system.matrix().el(dof, dof), what + ": written rows");
  }

  const Constraints                            supports;
  const std::vector<std::vector<unsigned int>> nodes;
  std::vector<Dofs>                            dofs;
  std::vector<Matrix>                          matrices;
  CellMatrices                                 cells;
  RowSystem                                    system;
};

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Problem                                  problem;
  // node 2 on 6 and the hanging node, node 4 beside it
  ContactEquation slip  = {{{{4, 0.6}, {5, 0.8}, {12, -0.3}, {13, -0.4}, {18, -0.3}, {19, -0.4}}, 0.1},
                           {4, 5}};
  ContactEquation other = {{{{9, 1.}, {13, -0.25}, {17, -0.75}}, 0.}, {8, 9}};
  problem.check_with({}, "all open");
  problem.check_with({slip}, "one node");
  problem.check_with({slip, other}, "two nodes");
  slip.test = {{4, 0.6 - 0.24}, {5, 0.8 + 0.18}, {12, -0.18}, {13, -0.49}, {18, -0.18}, {19, -0.49}};
  problem.check_with({slip, other}, "friction");
  problem.check_with({other}, "one opens");
  return check::result();
}
} // namespace test_row_system

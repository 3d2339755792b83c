#include <amontons/algebra/direct_factorisation.h>
#include <amontons/base/blas_threads.h>
#include <amontons/base/silent_errors.h>

#include <Amesos.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    // As of rigid bodies with fine meshes. What orders the unknowns by itself (PORD) takes the square of the
    // number of such rows.
    bool
    is_mostly_diagonal(const Epetra_CrsMatrix &matrix)
    {
      int alone = 0, all = 0;
      for (int row = 0; row < matrix.NumMyRows(); ++row)
        alone += matrix.NumMyEntries(row) <= 1;
      matrix.Comm().SumAll(&alone, &all, 1);
      return 2.0 * all > matrix.NumGlobalRows64();
    }
  } // namespace

  DirectFactorisation::DirectFactorisation(const LA::SparseMatrix &matrix,
                                           const std::string      &package,
                                           const bool              symmetric,
                                           const int               workspace,
                                           const bool              is_plane)
      : matrix(matrix.trilinos_matrix()), workspace(workspace)
  {
    if (package != "Amesos_Klu")
      {
        // Nested dissection (PORD, which MUMPS takes beyond small matrices) leaves less fill in space only,
        // and in the plane takes longer than the factorisation (doc/benchmarks.md).
        mumps =
            std::make_unique<Mumps>(this->matrix, symmetric, is_plane || is_mostly_diagonal(this->matrix));
        return;
      }
    problem.SetOperator(const_cast<Epetra_CrsMatrix *>(&this->matrix));
    klu.reset(Amesos().Create(package, problem));
    Teuchos::ParameterList list;
    list.set("PrintTiming", false);
    klu->SetParameters(list);
  }

  // MUMPS foresees its workspace in the symbolic part; pivots that it has to delay need more.
  bool
  DirectFactorisation::factorise()
  {
    const SilentErrors silence; // KLU speaks there
    if (klu)
      {
        const bool success =
            (symbolic || klu->SymbolicFactorization() == 0) && klu->NumericFactorization() == 0;
        symbolic = true;
        return !is_anywhere(!success);
      }
    constexpr int most_workspace = 5120;
    for (;; workspace = std::max(4 * workspace, 80), symbolic = false)
      {
        int code = symbolic ? 0 : mumps->analyse(workspace);
        if (code >= 0)
          {
            const BlasThreads threads(is_large() ? BlasThreads::available() : 1);
            code = mumps->factorise();
          }
        symbolic = true;
        if (!is_anywhere(code < 0))
          return true;
        const auto is_in = [&](const std::initializer_list<int> &codes) {
          return is_anywhere(std::find(codes.begin(), codes.end(), code) != codes.end());
        };
        const bool is_too_small = is_in({-8, -9, -11, -12, -14, -15, -17, -20});
        no_memory               = is_in({-5, -7, -13, -19}) || is_too_small;
        if (!is_too_small || workspace >= most_workspace)
          return false;
      }
  }

  // Below, threads cost more than they give (doc/benchmarks.md).
  bool
  DirectFactorisation::is_large() const
  {
    constexpr double operations = 2e9;
    return matrix.Comm().NumProc() == 1 && mumps->n_operations() > operations;
  }

  bool
  DirectFactorisation::is_anywhere(const bool here) const
  {
    int one = here ? 1 : 0, all = 0;
    matrix.Comm().MaxAll(&one, &all, 1);
    return all != 0;
  }

  void
  DirectFactorisation::vmult(LA::Vector &x, const LA::Vector &rhs) const
  {
    if (mumps)
      {
        x = rhs;
        return mumps->solve(x.trilinos_vector());
      }
    problem.SetLHS(&x.trilinos_vector());
    problem.SetRHS(const_cast<Epetra_MultiVector *>(&rhs.trilinos_vector()));
    klu->Solve();
  }

  void
  DirectFactorisation::solve(std::vector<LA::Vector> &columns) const
  {
    if (!mumps)
      {
        for (auto &column : columns)
          vmult(column, LA::Vector(column));
        return;
      }
    Epetra_MultiVector all(matrix.RowMap(), columns.size(), false);
    for (unsigned int k = 0; k < columns.size(); ++k)
      all(k)->Update(1, columns[k].trilinos_vector(), 0);
    mumps->solve(all);
    for (unsigned int k = 0; k < columns.size(); ++k)
      columns[k].trilinos_vector().Update(1, *all(k), 0);
  }
} // namespace Amontons

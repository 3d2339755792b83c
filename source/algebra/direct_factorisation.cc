#include <amontons/algebra/direct_factorisation.h>
#include <amontons/base/blas_threads.h>
#include <amontons/base/silent_errors.h>

#include <Amesos.h>
#include <Amesos_Mumps.h>
#include <Epetra_CrsMatrix.h>
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
                                           const int               workspace)
      : workspace(workspace)
  {
    problem.SetOperator(const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
    solver.reset(Amesos().Create(package, problem));
    Teuchos::ParameterList list;
    list.set("MatrixProperty", symmetric ? "SPD" : "general");
    list.set("PrintTiming", false);
    solver->SetParameters(list);
    mumps = dynamic_cast<Amesos_Mumps *>(solver.get());
    if (mumps != nullptr && is_mostly_diagonal(matrix.trilinos_matrix()))
      mumps->SetICNTL(7, 0); // approximate minimum degree
  }

  // MUMPS foresees its workspace in the symbolic part; pivots that it has to delay need more.
  bool
  DirectFactorisation::factorise()
  {
    const SilentErrors silence; // Amesos repeats there what MUMPS returns
    constexpr int      most_workspace = 5120;
    for (;; workspace = std::max(4 * workspace, 80), symbolic = false)
      {
        if (mumps != nullptr)
          mumps->SetICNTL(14, workspace);
        bool              success = symbolic || solver->SymbolicFactorization() == 0;
        const BlasThreads threads(success && is_large() ? BlasThreads::available() : 1);
        success  = success && solver->NumericFactorization() == 0;
        symbolic = true;
        if (!is_anywhere(!success))
          return true;
        const int  code  = mumps != nullptr ? mumps->GetINFOG()[0] : 0; // INFOG(1)
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
    constexpr double operations = 2e9; // RINFOG(1), foreseen for the elimination
    return mumps != nullptr && problem.GetOperator()->Comm().NumProc() == 1 &&
           mumps->GetRINFOG()[0] > operations;
  }

  bool
  DirectFactorisation::is_anywhere(const bool here) const
  {
    int one = here ? 1 : 0, all = 0;
    problem.GetOperator()->Comm().MaxAll(&one, &all, 1);
    return all != 0;
  }

  void
  DirectFactorisation::vmult(LA::Vector &x, const LA::Vector &rhs) const
  {
    problem.SetLHS(&x.trilinos_vector());
    problem.SetRHS(const_cast<Epetra_MultiVector *>(&rhs.trilinos_vector()));
    solver->Solve();
  }
} // namespace Amontons

// A sparse factorisation by MUMPS, or by KLU through Amesos.
#pragma once

#include <amontons/algebra/mumps.h>
#include <amontons/base/linear_algebra.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>

#include <string>

namespace Amontons
{
  // The symbolic factorisation is made once (the pattern stays), the numerical one when asked for. `matrix`
  // must live as long. All of it is collective.
  class DirectFactorisation
  {
  public:
    // package: as LinearSolverParameters have it. workspace: of MUMPS, percent more than it foresees.
    // is_plane: the bodies are.
    DirectFactorisation(const LA::SparseMatrix &matrix,
                        const std::string      &package,
                        const bool              symmetric,
                        const int               workspace,
                        const bool              is_plane);

    // False: the matrix is singular, or there is no memory.
    bool
    factorise();

    void
    vmult(LA::Vector &x, const LA::Vector &rhs) const;
    // Of many right-hand sides at once, each in its place.
    void
    solve(std::vector<LA::Vector> &columns) const;

    bool
    lacks_memory() const
    {
      return no_memory;
    }

  private:
    bool
    is_large() const;
    bool
    is_anywhere(const bool here) const;

    const Epetra_CrsMatrix            &matrix;
    mutable Epetra_LinearProblem       problem; // of KLU
    std::unique_ptr<Amesos_BaseSolver> klu;
    std::unique_ptr<Mumps>             mumps; // or this
    int                                workspace;
    bool                               symbolic = false, no_memory = false;
  };
} // namespace Amontons

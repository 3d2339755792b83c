// A sparse factorisation by one of Amesos' packages.
#pragma once

#include <amontons/base/linear_algebra.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>

#include <memory>
#include <string>

class Amesos_Mumps;

namespace Amontons
{
  // The symbolic factorisation is made once (the pattern stays), the numerical one when asked for. `matrix`
  // must live as long. All of it is collective.
  class DirectFactorisation
  {
  public:
    // workspace: of MUMPS, percent more than it foresees.
    DirectFactorisation(const LA::SparseMatrix &matrix,
                        const std::string      &package,
                        const bool              symmetric,
                        const int               workspace);

    // False: the matrix is singular, or there is no memory.
    bool
    factorise();

    void
    vmult(LA::Vector &x, const LA::Vector &rhs) const;

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

    mutable Epetra_LinearProblem       problem;
    std::unique_ptr<Amesos_BaseSolver> solver;
    Amesos_Mumps                      *mumps = nullptr; // if it is that
    int                                workspace;
    bool                               symbolic = false, no_memory = false;
  };
} // namespace Amontons

// A sparse factorisation by MUMPS, whose C interface is used as it is: Amesos' solves one right-hand side
// after another, which costs five times as much as 16 and more at once.
#pragma once

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_MultiVector.h>

#include <memory>
#include <vector>

namespace Amontons
{
  // `matrix` must live as long, with its pattern. All of it is collective.
  class Mumps
  {
  public:
    // symmetric: positive definite, too; one triangle is read. by_fill: unknowns are ordered by approximate
    // minimum fill, not as MUMPS likes.
    Mumps(const Epetra_CrsMatrix &matrix, const bool symmetric, const bool by_fill);
    ~Mumps();
    Mumps(const Mumps &) = delete;
    Mumps &
    operator=(const Mumps &) = delete;

    // INFOG(1) of MUMPS' manual: not negative on success.
    // workspace: percent more than MUMPS foresees.
    int
    analyse(const int workspace);
    int
    factorise();

    // Each column in its place.
    void
    solve(Epetra_MultiVector &columns);

    // Operations that the elimination takes, foreseen by analyse().
    double
    n_operations() const;

  private:
    struct Instance; // of MUMPS
    int
    run(const int job);

    const Epetra_CrsMatrix   &matrix;
    std::unique_ptr<Instance> instance;
    const bool                symmetric;
    std::vector<int>          rows, columns; // of the entries of this rank, from 1
    std::vector<double>       values;
    Epetra_Map                on_first; // all of a vector on rank 0, where MUMPS expects it
    Epetra_Import             to_first;
  };
} // namespace Amontons

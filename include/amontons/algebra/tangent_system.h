// The linear system of one Newton step where gaps depend on displacements in a nonlinear way: test functions
// are constrained as in CondensedSystem, displacements by equations of their own.
#pragma once

#include <amontons/algebra/condensed_system.h>
#include <amontons/algebra/linear_solver.h>

namespace Amontons
{
  // sum coefficient du = value, written into the matrix row of a DoF that test functions leave.
  struct WrittenRow
  {
    types::global_dof_index row;
    LinearEquation          equation;
  };

  // A matrix with rows and columns of its own.
  struct RectangularMatrix
  {
    std::vector<types::global_dof_index> rows, columns;
    FullMatrix<double>                   matrix;
  };

  // The gap of a node on a curved surface also depends on its neighbours, so that eliminated components would
  // refer to each other. Hence C_test^T K on all displacements that the supports leave, where the test
  // functions of closed nodes leave one row for each of their equations; the linearised gap or stick equation
  // is written there (DESIGN.md section 1).
  class TangentSystem
  {
  public:
    TangentSystem(const IndexSet &locally_owned, const IndexSet &relevant, MPI_Comm communicator);

    // supports: homogeneous. test: supports and equations(). further: each on one rank. diagonal (may be
    // null) is added to the entries of its DoFs. rows: those of other ranks are left out; scaled by the
    // largest stiffness.
    void
    assemble(const CellMatrices                   &cells,
             const Constraints                    &supports,
             const ContactConstraints             &test,
             const std::vector<RectangularMatrix> &further,
             const LA::Vector                     *diagonal,
             const std::vector<WrittenRow>        &rows,
             const bool                            with_eliminated_form);

    // For multigrid, if it was asked for each time: the same with displacements that obey test.trial(), too.
    // `test` of the last assemble() must still be there.
    EliminatedForm
    eliminated_form() const;

    const LA::SparseMatrix &
    matrix() const
    {
      return system;
    }
    // Of the values of written rows on the right hand side.
    double
    row_scale() const
    {
      return diagonal_scale;
    }

  private:
    // Which DoFs stand in for others: all that the pattern has to know beside the cells.
    using Links = std::map<types::global_dof_index, std::vector<types::global_dof_index>>; // sorted
    void
    make_pattern(const CellMatrices &cells, const Constraints &supports, const bool with_eliminated_form);
    bool
    add_links(const Constraints                    &supports,
              const ContactConstraints             &test,
              const std::vector<RectangularMatrix> &further,
              const std::vector<WrittenRow>        &rows);

    const IndexSet                       locally_owned, relevant;
    const MPI_Comm                       communicator;
    LA::SparseMatrix                     system, eliminated;
    const ContactConstraints            *constraints = nullptr;
    std::vector<types::global_dof_index> written;    // rows, owned
    Links                                replaced;   // test functions: by DoF that is or was eliminated
    Links                                coupled;    // further matrices and rows: columns by row
    std::vector<bool>                    is_surface; // by cell: has DoFs that others replace
    bool                                 has_pattern    = false;
    double                               diagonal_scale = 1;
  };
} // namespace Amontons

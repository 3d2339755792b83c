// The linear system of one Newton step where gaps depend on displacements in a nonlinear way: test functions
// are constrained as in EliminatedSystem, displacements by equations of their own.
#pragma once

#include <amontons/algebra/eliminated_system.h>
#include <amontons/algebra/direct_scatter.h>
#include <amontons/algebra/linear_solver.h>
#include <amontons/algebra/node_pattern.h>

namespace Amontons
{
  // sum coefficient du = value, written into the matrix row of a DoF that test functions leave.
  struct ContactRow
  {
    types::global_dof_index row;
    LinearEquation          equation;
  };

  // The gap of a node on a curved surface also depends on its neighbours, so that eliminated components would
  // refer to each other. Hence C_test^T K on all displacements that the supports leave, where the test
  // functions of closed nodes leave one row for each of their equations; the linearised gap or stick equation
  // is written there (doc/introduction.md, (24)).
  class RowSystem
  {
  public:
    RowSystem(const IndexSet    &locally_owned,
              const IndexSet    &relevant,
              const unsigned int n_components,
              MPI_Comm           communicator);

    // Whether assemble() with these makes the matrices anew: what refers to them must go. Before each one.
    bool
    link(const Constraints              &supports,
         const ContactConstraints       &test,
         const std::vector<LocalMatrix> &further,
         const std::vector<ContactRow>  &rows);

    // supports: homogeneous, always on the same DoFs. test: supports and equations(). further: each on one
    // rank. diagonal (may be null) is added to the entries of its DoFs. rows: those of other ranks are left
    // out.
    void
    assemble(const CellMatrices             &cells,
             const Constraints              &supports,
             const ContactConstraints       &test,
             const std::vector<LocalMatrix> &further,
             const LA::Vector               *diagonal,
             const std::vector<ContactRow>  &rows,
             const bool                      with_eliminated_form);

    // For multigrid, if it was asked for each time: the same with displacements that obey test.trial(), too.
    // `test` of the last assemble() must still be there.
    EliminatedForm
    eliminated_form() const;

    const LA::SparseMatrix &
    matrix() const
    {
      return system;
    }
    // Factor of an owned written row: its value on the right hand side gets it, too.
    double
    row_scale(const types::global_dof_index row) const;

  private:
    using Links = std::map<types::global_dof_index, Nodes>;
    Nodes
    nodes_of(const std::vector<types::global_dof_index> &dofs, const Constraints &constraints) const;
    bool
    gather_nodes(const std::vector<types::global_dof_index> &dofs,
                 const Constraints                          &supports,
                 Nodes                                      &nodes) const;
    void
    link_block(const std::vector<types::global_dof_index> &rows,
               const std::vector<types::global_dof_index> &columns,
               const Constraints                          &supports,
               bool                                       &is_new);
    void
    make_pattern(const CellMatrices &cells, const Constraints &supports, const bool with_eliminated_form);
    void
    add_diagonal(const LA::Vector *diagonal, const Constraints &supports, LA::SparseMatrix &matrix) const;
    // Of the DoFs of other ranks that rows of this rank's pivots are shared out to. Collective.
    struct OwnersOfShares
    {
      IndexSet                  dofs;
      std::vector<unsigned int> ranks; // in their order
    };
    OwnersOfShares
    owners_of_shares(const ContactConstraints &test) const;
    void
    condense_rows(const ContactConstraints &test,
                  const OwnersOfShares     &owners,
                  LA::SparseMatrix         &matrix) const;
    void
    condense_columns(const ContactConstraints &test, LA::SparseMatrix &matrix) const;
    void
    measure_stiffness(const CellMatrices &cells, const Constraints &supports);
    void
    write_rows(const std::vector<ContactRow> &rows, const Constraints &supports);
    void
    fill_empty_rows(LA::SparseMatrix &matrix, const Constraints &owners) const;

    const IndexSet                       locally_owned, relevant;
    const unsigned int                   n_components;
    const MPI_Comm                       communicator;
    LA::SparseMatrix                     system, eliminated;
    const ContactConstraints            *constraints = nullptr;
    std::vector<types::global_dof_index> written; // rows, owned
    // All that the pattern has to know beside the cells.
    Links replaced; // test functions: by DoF that is or was eliminated
    Links coupled;  // further matrices and rows: by node of the row
    std::set<std::pair<std::size_t, std::size_t>> linked_blocks; // rows and columns, as hash values
    std::vector<unsigned int>                     surface;       // cells with DoFs that others replace
    DirectScatter                                 scatter;
    std::vector<unsigned int>                     constrained; // cells that it does not serve
    LA::Vector                                    stiffness; // diagonal, of DoFs on `surface` or constrained
    bool                                          pattern_is_old = true;
    double                                        diagonal_scale = 1;
  };
} // namespace Amontons

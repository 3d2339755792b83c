// The linear system of the increments: C^T K C on what the supports and the closed nodes leave free:
// doc/introduction.md, (12).
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/algebra/contact_constraints.h>
#include <amontons/base/local_matrix.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <set>

namespace Amontons
{
  // C^T r for a raw vector r over all DoFs (owned part): what constrained DoFs carry goes to those that they
  // depend on.
  LA::Vector
  condense(const LA::Vector &raw, const Constraints &constraints, const LA::Vector &like);

  // The DoFs that constraints own have no equation of their own.
  void
  zero_constrained(const Constraints &constraints, const IndexSet &owned, LA::Vector &vector);

  // constraints.distribute(owned), and a copy that is readable at relevant DoFs. Their vectors are there
  // already; AffineConstraints would find out each time which DoFs of other ranks it needs.
  void
  distribute(const Constraints &constraints, LA::Vector &owned, LA::Vector &readable);
  // The same of a change of what obeys them already: without their inhomogeneities.
  void
  distribute_change(const Constraints &constraints, LA::Vector &owned, LA::Vector &readable);

  // A linear scene does not change between iterations but for the closed nodes. So cells without a DoF of a
  // possible slave node (the bulk) are assembled once per mesh; a change of state restores their sum in the
  // rows that the few others reach, and adds these again. The sparsity pattern holds all `candidates`, so
  // that it is rebuilt only when a node outside of them closes.
  class EliminatedSystem
  {
  public:
    EliminatedSystem(const IndexSet &locally_owned, const IndexSet &relevant, MPI_Comm communicator);

    // candidates: equations of all nodes that may close on this mesh, after substitution of the supports.
    // diagonal (may be null): assemble() adds none elsewhere.
    void
    setup(const CellMatrices                 &cells,
          const Constraints                  &supports,
          const std::vector<ContactEquation> &candidates,
          const LA::Vector                   *diagonal);

    // C_test^T (K + further) C_trial. diagonal (may be null): added to the diagonal entry of each DoF before
    // condensation. further: each on one rank; their DoFs must be those of one of the candidates.
    void
    assemble(const CellMatrices             &cells,
             const ContactConstraints       &constraints,
             const LA::Vector               *diagonal,
             const std::vector<LocalMatrix> &further);

    const LA::SparseMatrix &
    matrix() const
    {
      return system;
    }

  private:
    void
    assemble_bulk(const CellMatrices      &cells,
                  const Constraints       &supports,
                  const std::vector<bool> &is_surface);
    void
    add_missing_diagonals(const Constraints &constraints);
    void
    save_bulk_rows(const std::set<types::global_dof_index> &reached);
    void
    restore_bulk_rows();

    const IndexSet            locally_owned, relevant;
    const MPI_Comm            communicator;
    std::vector<unsigned int> surface_cells;
    LA::SparseMatrix          system;
    std::vector<int>          saved_rows; // local indices
    std::vector<double>       saved_values;
    LA::Vector                stiffness; // of DoFs without an equation: the sum of the cells' diagonals
  };
} // namespace Amontons

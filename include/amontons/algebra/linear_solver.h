// Linear systems: CG with algebraic multigrid and rigid-body modes, or a direct solver.
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/base/parameters.h>
#include <amontons/base/stop_request.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/trilinos_precondition.h>

#include <memory>

namespace Amontons
{
  class DirectFactorisation;

  struct LinearSolverParameters : ParameterGroup
  {
    std::string  type           = "automatic"; // automatic | direct | cg
    std::string  direct_package = "automatic"; // automatic | Amesos_Mumps | Amesos_Klu
    double       tolerance      = 0;           // a tenth of that of the contact solver
    unsigned int max_iterations = 2000;
    int          workspace      = 20; // of MUMPS, at first: percent more than it foresees

    void
    declare(ParameterHandler &prm) override;
  };

  // For systems with written rows (see RowSystem): multigrid works on another matrix, where the DoFs of
  // these rows are eliminated. Applied to r: w = r/diagonal on the written rows, z = multigrid of r - A w
  // elsewhere, and what z means for the eliminated DoFs is added.
  struct EliminatedForm
  {
    const LA::SparseMatrix                                 *matrix      = nullptr;
    const Constraints                                      *constraints = nullptr; // homogeneous
    std::vector<std::pair<types::global_dof_index, double>> written; // owned rows and their diagonals in A
  };

  struct LinearSolveReport
  {
    bool         success    = true;
    bool         no_memory  = false; // that is why it failed
    bool         given_up   = false; // or this
    unsigned int iterations = 0;     // Krylov; 1 for a direct solve
  };

  // For which a factorisation is worth more.
  struct SolverPurpose
  {
    bool nearly_incompressible = false; // some material is, of which multigrid takes many steps
    bool has_many_columns      = false; // one matrix often serves many right hand sides
  };

  // Symmetric positive definite systems by CG; unsymmetric ones (slip with friction) by GMRES. While the
  // contact set moves, matrices differ by a few rows: the direct solver keeps its factorisation as the
  // preconditioner of a few Krylov steps (a change of rank k costs about k of them), and multigrid keeps its
  // hierarchy.
  class LinearSolver
  {
  public:
    // symmetric: that all matrices are. gives_up: asked before each solve and in every eighth Krylov
    // step; once true, all further solves fail at once. degree: of the elements; rows of quadratic ones in
    // space are long.
    LinearSolver(const LinearSolverParameters &parameters,
                 const int                     dim,
                 const unsigned int            degree,
                 const bool                    symmetric,
                 const GivesUp                &gives_up = {},
                 const SolverPurpose          &purpose  = {});
    ~LinearSolver();

    // Rigid-body modes (values at all owned DoFs, by mode), or empty: translations are not enough for
    // elasticity.
    void
    set_near_null_space(std::vector<std::vector<double>> modes);

    // The matrix has changed in the rows of this many nodes, or altogether (all_rows): the preconditioner
    // must be rebuilt, else it is kept while it serves. The matrix object and its sparsity pattern must stay
    // the same over the life of this object.
    void
                                  matrix_changed(const unsigned int n_nodes);
    static constexpr unsigned int all_rows = static_cast<unsigned int>(-1);

    // All values have changed, within the same object and pattern: a factorisation is made anew but for its
    // symbolic part, multigrid keeps its hierarchy while it serves.
    void
    values_changed();

    // Solves to |r| <= tolerance; the direct solver ignores it. x: owned, initial guess 0.
    LinearSolveReport
    solve(const LA::SparseMatrix &matrix,
          LA::Vector             &x,
          const LA::Vector       &rhs,
          const double            tolerance,
          const EliminatedForm   *eliminated = nullptr);

    // Many right-hand sides, each in its place.
    void
    solve(const LA::SparseMatrix &matrix, std::vector<LA::Vector> &columns);

    bool
    is_direct(const types::global_dof_index n_dofs) const;

    // Factors of the matrix as it is: a solve costs little.
    bool
    has_factors() const
    {
      return direct != nullptr && !factorisation_is_old;
    }

    // For the solves that come.
    void
    set_gives_up(const GivesUp &now)
    {
      gives_up = now;
      given_up = false;
    }

  private:
    void
    build_preconditioner(const LA::SparseMatrix &matrix);
    // By CG, or GMRES; throws SolverControl::NoConvergence.
    template <typename Preconditioner>
    void
    run_krylov(SolverControl          &control,
               const LA::SparseMatrix &matrix,
               LA::Vector             &x,
               const LA::Vector       &rhs,
               const Preconditioner   &preconditioner);
    bool
    is_given_up();

    const LinearSolverParameters                      &parameters;
    const int                                          dim;
    const bool                                         symmetric;
    const unsigned int                                 most_direct; // unknowns, if automatic
    GivesUp                                            gives_up;
    bool                                               given_up = false;
    std::vector<std::vector<double>>                   modes;
    std::unique_ptr<TrilinosWrappers::PreconditionAMG> amg;
    bool                                               amg_is_old = true;
    std::unique_ptr<DirectFactorisation>               direct;
    bool                                               factorisation_is_old = true;
    bool                                               all_values_are_new   = false;
    unsigned int n_changed        = 0;     // nodes, since the matrix was factorised or its hierarchy made
    double       steps_per_decade = 0;     // of the Krylov solver with a new hierarchy
    double       n_lost           = 0;     // steps, since then, that a new one would have saved
    double       lost_per_change  = 0;     // likewise, at once, the last time that n_changed was large
    bool         multigrid_fails  = false; // or takes longer than a factorisation

    LinearSolveReport
    solve_directly(const LA::SparseMatrix &matrix,
                   LA::Vector             &x,
                   const LA::Vector       &rhs,
                   const double            tolerance);
  };
} // namespace Amontons

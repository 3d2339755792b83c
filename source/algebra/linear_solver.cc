#include <amontons/algebra/direct_factorisation.h>
#include <amontons/algebra/linear_solver.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Import.h>
#include <Epetra_MultiVector.h>
#include <Epetra_Vector.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_utils.h>

#include <algorithm>
#include <exception>
#include <limits>

namespace Amontons
{
  void
  LinearSolverParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Linear solver");
    prm.add_parameter(
        "Type",
        type,
        "direct (a sparse factorisation), cg (conjugate gradients with algebraic multigrid) or "
        "automatic: direct for plane problems up to 150000 unknowns and 3D ones up to 5000 (40000 with "
        "quadratic elements, 30000 where a Poisson ratio is 0.49 or more; with friction and small strain "
        "20000, and 100000 with quadratic elements).",
        Patterns::Selection("automatic|direct|cg"));
    prm.add_parameter(
        "Direct package",
        direct_package,
        "Trilinos' name of the direct solver; automatic: the fastest measured (doc/benchmarks).",
        Patterns::Selection("automatic|Amesos_Mumps|Amesos_Klu"));
    prm.add_parameter(
        "Tolerance",
        tolerance,
        "Residual, relative to the forces, to which systems are solved once the contact set is found. 0: a "
        "tenth of 'Contact solver/Tolerance'.",
        Patterns::Double(0, 1e-2));
    prm.add_parameter("Maximum iterations", max_iterations, "Of the Krylov solver.", Patterns::Integer(1));
    prm.leave_subsection();
  }

  namespace
  {
    using CrsMatrix = std::unique_ptr<Epetra_CrsMatrix>;

    // The columns of A where `kept` is not zero.
    CrsMatrix
    columns_of(const Epetra_CrsMatrix &A, const LA::Vector &kept)
    {
      Epetra_Vector is_kept(A.ColMap());
      if (A.Importer() != nullptr)
        is_kept.Import(kept.trilinos_vector(), *A.Importer(), Insert);
      else
        is_kept.Update(1., kept.trilinos_vector(), 0.);
      auto                result = std::make_unique<Epetra_CrsMatrix>(Copy, A.RowMap(), A.ColMap(), 0);
      std::vector<double> values;
      std::vector<int>    columns;
      for (int row = 0; row < A.NumMyRows(); ++row)
        {
          double *value;
          int     n, *column;
          A.ExtractMyRowView(row, n, value, column);
          values.clear();
          columns.clear();
          for (int k = 0; k < n; ++k)
            if (is_kept[column[k]] != 0 && value[k] != 0)
              {
                values.push_back(value[k]);
                columns.push_back(column[k]);
              }
          if (!columns.empty())
            result->InsertMyValues(row, columns.size(), values.data(), columns.data());
        }
      result->FillComplete(A.DomainMap(), A.RangeMap());
      return result;
    }

    // What displacements mean for the eliminated DoFs of the written rows, zero in all other rows.
    CrsMatrix
    distribution(const Epetra_CrsMatrix &A, const EliminatedForm &form)
    {
      auto                result = std::make_unique<Epetra_CrsMatrix>(Copy, A.RowMap(), 0);
      std::vector<double> values;
      std::vector<int>    columns;
      for (const auto &entry : form.written)
        if (const auto *line = form.constraints->get_constraint_entries(entry.first))
          {
            values.clear();
            columns.clear();
            for (const auto &[dof, weight] : *line)
              {
                values.push_back(weight);
                columns.push_back(dof);
              }
            result->InsertGlobalValues(entry.first, columns.size(), values.data(), columns.data());
          }
      result->FillComplete(A.DomainMap(), A.RangeMap());
      return result;
    }

    class EliminatingPreconditioner
    {
    public:
      EliminatingPreconditioner(const LA::SparseMatrix                  &A,
                                const EliminatedForm                    &form,
                                const TrilinosWrappers::PreconditionAMG &multigrid,
                                const LA::Vector                        &like)
          : multigrid(multigrid)
      {
        for (LA::Vector *vector : {&inverse_diagonal, &others, &w, &rest})
          vector->reinit(like, true);
        inverse_diagonal = 0;
        others           = 1;
        for (const auto &[dof, diagonal] : form.written)
          {
            inverse_diagonal(dof) = 1 / diagonal;
            others(dof)           = 0;
          }
        inverse_diagonal.compress(VectorOperation::insert);
        others.compress(VectorOperation::insert);
        written_columns = columns_of(A.trilinos_matrix(), inverse_diagonal);
        eliminated_rows = distribution(A.trilinos_matrix(), form);
      }

      void
      vmult(LA::Vector &z, const LA::Vector &r) const
      {
        w = r;
        w.scale(inverse_diagonal);
        written_columns->Multiply(false, w.trilinos_vector(), rest.trilinos_vector());
        rest.sadd(-1, 1, r);
        rest.scale(others);
        multigrid.vmult(z, rest);
        z.scale(others);
        eliminated_rows->Multiply(false, z.trilinos_vector(), rest.trilinos_vector());
        z += rest;
        z += w;
      }

    private:
      const TrilinosWrappers::PreconditionAMG &multigrid;
      LA::Vector                               inverse_diagonal, others; // others: 1 where it is 0
      CrsMatrix                                written_columns, eliminated_rows;
      mutable LA::Vector                       w, rest;
    };
  } // namespace

  namespace
  {
    // Unknowns up to which a factorisation takes no longer than multigrid (doc/benchmarks.md).
    unsigned int
    most_to_factorise(const int dim, const unsigned int degree, const SolverPurpose &purpose)
    {
      if (dim == 2)
        return 150000;
      if (degree > 1)
        return purpose.has_many_columns ? 100000 : 40000;
      return purpose.nearly_incompressible ? 30000 : purpose.has_many_columns ? 20000 : 5000;
    }
  } // namespace

  LinearSolver::LinearSolver(const LinearSolverParameters &parameters,
                             const int                     dim,
                             const unsigned int            degree,
                             const bool                    symmetric,
                             const GivesUp                &gives_up,
                             const SolverPurpose          &purpose)
      : parameters(parameters), dim(dim), symmetric(symmetric),
        most_direct(most_to_factorise(dim, degree, purpose)), gives_up(gives_up)
  {
  }

  // Ranks free factors together, and an error may end the program on one of them first.
  LinearSolver::~LinearSolver()
  {
    if (std::uncaught_exceptions() > 0)
      {
        (void)direct.release(); // NOLINT(bugprone-unused-return-value): lost
        (void)amg.release();    // NOLINT(bugprone-unused-return-value)
      }
  }

  bool
  LinearSolver::is_given_up()
  {
    given_up = given_up || (gives_up && gives_up());
    return given_up;
  }

  // GMRES preconditions from the right, so that its residual is that of the system.
  template <typename Preconditioner>
  void
  LinearSolver::run_krylov(SolverControl          &control,
                           const LA::SparseMatrix &matrix,
                           LA::Vector             &x,
                           const LA::Vector       &rhs,
                           const Preconditioner   &preconditioner)
  {
    const auto run = [&](auto &&solver) {
      solver.connect([this](const unsigned int step, const double, const LA::Vector &) {
        // Ranks that share cores wait for each other: not at every step.
        return (step % 8 == 0 ? is_given_up() : given_up) ? SolverControl::failure
                                                          : SolverControl::success; // the other slot decides
      });
      solver.solve(matrix, x, rhs, preconditioner);
    };
    if (symmetric)
      run(SolverCG<LA::Vector>(control));
    else
      run(SolverGMRES<LA::Vector>(control, SolverGMRES<LA::Vector>::AdditionalData(152, true)));
    if (given_up) // which CG does not tell of its first step
      throw SolverControl::NoConvergence(control.last_step(), control.last_value());
  }

  void
  LinearSolver::set_near_null_space(std::vector<std::vector<double>> new_modes)
  {
    modes      = std::move(new_modes);
    amg_is_old = true;
  }

  bool
  LinearSolver::is_direct(const types::global_dof_index n_dofs) const
  {
    if (parameters.type == "automatic")
      return n_dofs <= most_direct;
    return parameters.type == "direct";
  }

  void
  LinearSolver::matrix_changed(const unsigned int n_nodes)
  {
    factorisation_is_old = true;
    if (n_nodes == all_rows)
      {
        direct.reset();
        amg.reset();
      }
    else
      n_changed += n_nodes;
  }

  void
  LinearSolver::values_changed()
  {
    factorisation_is_old = true;
    all_values_are_new   = true;
  }

  void
  LinearSolver::build_preconditioner(const LA::SparseMatrix &matrix)
  {
    Teuchos::ParameterList list;
    list.set("default values", "SA");
    list.set("ML output", 0);
    list.set("max levels", 10);
    list.set("aggregation: type", "Uncoupled");
    list.set("aggregation: threshold", 0.01);
    list.set("eigen-analysis: type", "cg"); // ML's power method ends too early on large matrices
    list.set("smoother: type", "Chebyshev");
    list.set("smoother: sweeps", 2);
    list.set("coarse: max size", 500);
    list.set("coarse: type", "Amesos-KLU");
    list.set("PDE equations", dim);
    std::unique_ptr<Epetra_MultiVector> null_space;
    if (!modes.empty())
      {
        null_space = std::make_unique<Epetra_MultiVector>(matrix.trilinos_matrix().DomainMap(), modes.size());
        for (unsigned int m = 0; m < modes.size(); ++m)
          for (unsigned int i = 0; i < modes[m].size(); ++i)
            (*null_space)[m][i] = modes[m][i];
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", int(modes.size()));
        list.set("null space: vectors", null_space->Values());
      }
    amg = std::make_unique<TrilinosWrappers::PreconditionAMG>();
    // ML estimates eigenvalues from random vectors and goes on with its sequence from one hierarchy to the
    // next: begun anew, a run that is resumed iterates as one that was never stopped. Each rank has its own
    // sequence.
    const MPI_Comm communicator = matrix.get_mpi_communicator();
    const double   share        = (1. + dealii::Utilities::MPI::this_mpi_process(communicator)) /
                         (1. + dealii::Utilities::MPI::n_mpi_processes(communicator));
    ML_set_random_seed(std::numeric_limits<int>::max() * (1 - share));
    amg->initialize(matrix, list);
    amg_is_old = false;
    n_lost     = 0;
    n_changed  = 0;
  }

  namespace
  {
    LinearSolveReport
    abandoned(LinearSolveReport report)
    {
      report.success  = false;
      report.given_up = true;
      return report;
    }

    // One step of iterative refinement: x += A^-1 (b - A x).
    template <typename Inverse>
    void
    refine(const Inverse &inverse, const LA::SparseMatrix &matrix, LA::Vector &x, const LA::Vector &rhs)
    {
      LA::Vector rest(rhs), correction(rhs);
      matrix.residual(rest, x, rhs);
      inverse.vmult(correction, rest);
      x += correction;
    }
  } // namespace

  LinearSolveReport
  LinearSolver::solve_directly(const LA::SparseMatrix &matrix,
                               LA::Vector             &x,
                               const LA::Vector       &rhs,
                               const double            tolerance)
  {
    LinearSolveReport report;
    //! [stale factorisation]
    if (direct && factorisation_is_old && !all_values_are_new && n_changed <= (symmetric ? 20 : 6))
      {
        // Beyond about 20 solves a new factorisation is cheaper (2D: one costs some 10 to 20 of them).
        ReductionControl control(20, dim == 3 ? tolerance : 0, symmetric ? 1e-13 : 1e-12);
        try
          {
            run_krylov(control, matrix, x, rhs, *direct);
            report.iterations = control.last_step();
            return report;
            //! [stale factorisation]
          }
        catch (const SolverControl::NoConvergence &)
          {
            report.iterations = control.last_step();
            if (given_up)
              return abandoned(report);
          }
      }
    if (!direct)
      direct = std::make_unique<DirectFactorisation>(
          matrix, parameters.direct_package, symmetric, parameters.workspace, dim == 2);
    const bool is_new = factorisation_is_old;
    if (is_new && !direct->factorise())
      {
        report.success   = false;
        report.no_memory = direct->lacks_memory();
        direct.reset();
        return report;
      }
    factorisation_is_old = false;
    all_values_are_new   = false;
    n_changed            = 0;
    direct->vmult(x, rhs);
    if (is_new && symmetric) // partly covered faces magnify rounding
      refine(*direct, matrix, x, rhs);
    ++report.iterations;
    report.success = std::isfinite(x.l2_norm());
    return report;
  }

  LinearSolveReport
  LinearSolver::solve(const LA::SparseMatrix &matrix,
                      LA::Vector             &x,
                      const LA::Vector       &rhs,
                      const double            tolerance,
                      const EliminatedForm   *eliminated)
  {
    LinearSolveReport report;
    x = 0;
    if (rhs.l2_norm() == 0)
      return report;
    if (is_given_up())
      return abandoned(report);
    if (is_direct(matrix.m()) || multigrid_fails)
      return solve_directly(matrix, x, rhs, tolerance);
    if (rhs.l2_norm() <= tolerance)
      return report;
    // Once an old hierarchy has cost as many steps more than a new one would have as making that takes, it is
    // made: never more than twice what the best choice costs. So it is where many nodes have changed and it
    // would cost that at once, by what it cost for each of them when it was so last.
    constexpr double       new_hierarchy = 20; // steps, measured in 3D: 15 to 28
    constexpr unsigned int many          = 50;
    amg_is_old           = amg_is_old || (n_changed >= many && n_changed * lost_per_change > new_hierarchy);
    const double decades = std::max(1., std::log10(rhs.l2_norm() / tolerance));
    for (const bool retry : {false, true})
      {
        const bool fresh = amg_is_old || !amg || retry;
        if (fresh)
          build_preconditioner(eliminated != nullptr ? *eliminated->matrix : matrix);
        const double  most = !fresh      ? decades * steps_per_decade + 3 * new_hierarchy
                             : symmetric ? parameters.max_iterations
                                         : 300;
        SolverControl control(std::min<double>(parameters.max_iterations, most), tolerance);
        try
          {
            x = 0;
            if (eliminated != nullptr)
              run_krylov(control, matrix, x, rhs, EliminatingPreconditioner(matrix, *eliminated, *amg, rhs));
            else
              run_krylov(control, matrix, x, rhs, *amg);
            report.iterations += control.last_step();
            report.success  = true;
            multigrid_fails = fresh && (!symmetric || parameters.type == "automatic") &&
                              control.last_step() > 150 && matrix.m() <= 30000;
            if (fresh)
              steps_per_decade = control.last_step() / decades;
            else
              {
                const double lost = std::max(0., control.last_step() - decades * steps_per_decade);
                n_lost += lost;
                if (n_changed >= many)
                  lost_per_change = lost / n_changed;
              }
            amg_is_old = n_lost > new_hierarchy;
            break;
          }
        catch (const SolverControl::NoConvergence &failure)
          {
            report.iterations += failure.last_step;
            report.success = false;
            if (given_up)
              return abandoned(report);
            if (fresh)
              break;
          }
      }
    // Not what multigrid is made for, but small enough: factorise it after all, and what follows.
    if (!report.success && matrix.m() <= 100000)
      {
        const unsigned int n = report.iterations;
        multigrid_fails      = true;
        report               = solve_directly(matrix, x, rhs, tolerance);
        report.iterations += n;
      }
    return report;
  }

  void
  LinearSolver::solve(const LA::SparseMatrix &matrix, std::vector<LA::Vector> &columns)
  {
    if (has_factors())
      return direct->solve(columns);
    for (auto &column : columns)
      solve(matrix, column, LA::Vector(column), 0);
  }
} // namespace Amontons

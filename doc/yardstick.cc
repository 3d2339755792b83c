// What one linear solve takes on a machine without any contact: an elastic cube of n^3 linear elements under
// its own weight, written as a deal.II tutorial would write it (pattern, assembly, ML with translations, CG
// to a relative residual). Against `one_linear_solve_seconds`:
//   ninja -C build yardstick && OMP_NUM_THREADS=1 build/yardstick 32 1e-8
#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/timer.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/numerics/vector_tools.h>

#include <iostream>

using namespace dealii;

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc != 3)
    {
      std::cerr << "usage: yardstick CELLS_PER_EDGE RELATIVE_RESIDUAL\n";
      return 2;
    }
  const unsigned int n   = std::stoul(argv[1]);
  const double tolerance = std::stod(argv[2]), mu = 1 / 2.6, lambda = 0.3 / 1.3 / 0.4; // E = 1, nu = 0.3

  Triangulation<3> triangulation;
  GridGenerator::subdivided_hyper_cube(triangulation, n, 0, 1, true);
  const FESystem<3> fe(FE_Q<3>(1), 3);
  DoFHandler<3>     dof_handler(triangulation);
  dof_handler.distribute_dofs(fe);
  AffineConstraints<double> constraints;
  VectorTools::interpolate_boundary_values(dof_handler, 4, Functions::ZeroFunction<3>(3), constraints);
  constraints.close();

  Timer      timer, all;
  const auto lap = [&](const std::string &what) {
    std::cout << what << " " << timer.wall_time() << "\n";
    timer.restart();
  };
  DynamicSparsityPattern pattern(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, pattern, constraints, false);
  const IndexSet                 dofs = complete_index_set(dof_handler.n_dofs());
  TrilinosWrappers::SparseMatrix A;
  A.reinit(dofs, pattern, MPI_COMM_WORLD);
  TrilinosWrappers::MPI::Vector b(dofs), x(dofs);
  lap("pattern");

  const QGauss<3>    quadrature(2);
  FEValues<3>        values(fe, quadrature, update_values | update_gradients | update_JxW_values);
  const unsigned int n_local = fe.n_dofs_per_cell();
  FullMatrix<double> K(n_local, n_local);
  Vector<double>     f(n_local);
  std::vector<types::global_dof_index> indices(n_local);
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      values.reinit(cell);
      K = 0;
      f = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        for (unsigned int i = 0; i < n_local; ++i)
          {
            const unsigned int c = fe.system_to_component_index(i).first;
            const auto         g = values.shape_grad(i, q) * values.JxW(q);
            for (unsigned int j = 0; j < n_local; ++j)
              {
                const unsigned int d = fe.system_to_component_index(j).first;
                const auto        &h = values.shape_grad(j, q);
                K(i, j) += lambda * g[c] * h[d] + mu * (g[d] * h[c] + (c == d ? g * h : 0.));
              }
            f(i) -= c == 2 ? values.shape_value(i, q) * values.JxW(q) : 0.;
          }
      cell->get_dof_indices(indices);
      constraints.distribute_local_to_global(K, f, indices, A, b);
    }
  A.compress(VectorOperation::add);
  b.compress(VectorOperation::add);
  lap("assembly");

  TrilinosWrappers::PreconditionAMG::AdditionalData data;
  DoFTools::extract_constant_modes(dof_handler, ComponentMask(3, true), data.constant_modes);
  TrilinosWrappers::PreconditionAMG preconditioner;
  preconditioner.initialize(A, data);
  lap("multigrid set-up");

  SolverControl control(1000, tolerance * b.l2_norm());
  SolverCG<TrilinosWrappers::MPI::Vector>(control).solve(A, x, b, preconditioner);
  lap("CG");
  std::cout << dof_handler.n_dofs() << " DoFs, " << control.last_step() << " iterations, " << all.wall_time()
            << " s\n";
}

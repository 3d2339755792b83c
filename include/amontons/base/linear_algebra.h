// Linear algebra types used throughout: Trilinos (Epetra) vectors and matrices, distributed over MPI.
#pragma once

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <boost/container/flat_map.hpp>

namespace Amontons
{
  using namespace dealii;

  namespace LA
  {
    using Vector       = TrilinosWrappers::MPI::Vector;
    using SparseMatrix = TrilinosWrappers::SparseMatrix;
  } // namespace LA

  using Constraints = AffineConstraints<double>;

  // By degree of freedom, sorted: of equations, gradients and forces that know few of them.
  using Coefficients = boost::container::flat_map<types::global_dof_index, double>;

  inline void
  add(Coefficients &sum, const double factor, const Coefficients &term)
  {
    for (const auto &[dof, value] : term)
      sum[dof] += factor * value;
  }
} // namespace Amontons

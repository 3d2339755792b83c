// The stiffness of all bodies, cell by cell: assembled once per mesh for linear scenes.
#pragma once

#include <amontons/discretization/discretization.h>
#include <amontons/elasticity/linear_elastic.h>

namespace Amontons
{
  template <int dim>
  class ElasticityOperator
  {
  public:
    explicit ElasticityOperator(const Discretization<dim> &discretization);

    // K_e = int B^T C B over every owned cell of a deformable body.
    void
    assemble();

    // After a change of the mesh, until the next assemble().
    void
    clear()
    {
      cells.clear();
      values.clear();
    }

    unsigned int
    n_cells() const
    {
      return cells.size();
    }
    FullMatrix<double>
    matrix(const unsigned int c) const;
    double
    diagonal(const unsigned int c, const unsigned int i) const
    {
      return values[c * n_values + i * (i + 1) / 2 + i];
    }
    const std::vector<types::global_dof_index> &
    dofs(const unsigned int c) const
    {
      return cells[c].dofs;
    }
    types::material_id
    body(const unsigned int c) const
    {
      return cells[c].body;
    }

    // K u on unconstrained degrees of freedom (hanging nodes as if they were free); u readable at relevant
    // DoFs.
    LA::Vector
    apply(const LA::Vector &u) const;

    // Norm of diag(K) u: what rounding is measured against.
    double
    rounding_scale(const LA::Vector &u) const;

    // Stress at the points of `values` (reinited on the cell; update flags as StrainOperator needs), from the
    // same projected strain as the stiffness.
    std::vector<Voigt<dim>>
    stresses(const FEValues<dim>                                  &values,
             const typename DoFHandler<dim>::active_cell_iterator &cell,
             const LA::Vector                                     &u) const;

    static UpdateFlags
    needed_flags();

  private:
    struct CellStiffness
    {
      std::vector<types::global_dof_index> dofs;
      types::material_id                   body;
    };

    const Discretization<dim>      &discretization;
    std::vector<LinearElastic<dim>> materials; // per body
    std::vector<CellStiffness>      cells;
    const std::size_t               n_values; // per cell
    std::vector<double>             values;   // of the cells' lower triangles, row by row
  };
} // namespace Amontons

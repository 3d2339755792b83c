// A continuous stress field in every body from the discontinuous one of the finite elements.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>

namespace Amontons
{
  // Nodal stresses sigma* by superconvergent patch recovery (Zienkiewicz and Zhu 1992): around every vertex
  // inside a body, a polynomial of total degree p is fitted to sigma_h at the p^dim Gauss points of the cells
  // that meet there; a node takes the value of the patches of its cell's vertices, weighted by their hat
  // functions. Nodes on the surface of a body (and beside hanging nodes) take the polynomials of the inner
  // vertices of their cells, so that sigma* is as accurate on the surface as inside. Cells without any inner
  // vertex (bodies one cell thick) extrapolate from their own Gauss points. Averages over a node's cells make
  // sigma* unique; hanging nodes follow their parents. Stresses that are polynomials of degree p on patches
  // are reproduced. (Averages of extrapolated Gauss values would not do: for quadratic elements they
  // reproduce the error of sigma_h, and the estimate falls below the error by one order.) To be made anew
  // with every mesh. Zero on carriers and rigid bodies.
  template <int dim>
  class StressRecovery
  {
  public:
    StressRecovery(const Discretization<dim> &discretization, const ElasticityOperator<dim> &elasticity);

    // Collective; displacement readable at relevant DoFs.
    void
    recover(const LA::Vector &displacement);

    const DoFHandler<dim> &
    dof_handler() const
    {
      return scalar_dofs;
    } // scalar, same degree as the displacement
    const std::vector<LA::Vector> &
    stress() const
    {
      return components;
    } // n_voigt, readable at relevant DoFs

    // Where `values` of the next function are reinited: this cell of the mesh.
    template <typename Cell>
    typename DoFHandler<dim>::active_cell_iterator
    cell_of(const Cell &cell) const
    {
      return {&dof_handler().get_triangulation(), cell->level(), cell->index(), &dof_handler()};
    }

    // sigma* at the quadrature points of `values`, which must be reinited on a cell of dof_handler() (FE is
    // that of dof_handler()).
    std::vector<Voigt<dim>>
    values_at(const FEValuesBase<dim> &values) const;

    // sigma_h at the points of QGauss(p + 1) in an owned cell of a deformable body, by active cell.
    const std::vector<Voigt<dim>> &
    unsmoothed(const unsigned int active_cell) const
    {
      return gauss_stresses[active_cell];
    }

    // Small strain: ElasticityOperator::energy_of_neglected_stress, of all bodies. Collective.
    double
    energy_of_neglected_stress() const;

  private:
    const Discretization<dim>     &discretization;
    const ElasticityOperator<dim> &elasticity;
    DoFHandler<dim>                scalar_dofs;
    Constraints                    hanging;
    std::vector<LA::Vector>        components;

    std::vector<std::vector<Voigt<dim>>> gauss_stresses;       // by active cell
    double                               neglected_energy = 0; // of this rank's cells
  };
} // namespace Amontons

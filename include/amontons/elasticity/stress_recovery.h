// A continuous stress field in every body from the discontinuous one of the finite elements.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>

namespace Amontons
{
  // Nodal stresses sigma* by a lumped L2 projection in each body (bodies share no nodes): sigma*_i = int phi_i sigma / int phi_i with
  // weights that are positive for the degree at hand; hanging nodes follow their parents.
  template <int dim>
  class StressRecovery
  {
  public:
    StressRecovery(const Discretization<dim> &discretization, const ElasticityOperator<dim> &elasticity);

    void recover(const LA::Vector &displacement);

    const DoFHandler<dim>         &dof_handler() const { return scalar_dofs; } // scalar, same degree as the displacement
    const std::vector<LA::Vector> &stress() const { return components; }       // n_voigt, readable at relevant DoFs

    // sigma* at the quadrature points of `values`, which must be reinited on a cell of dof_handler() (FE is that of dof_handler()).
    std::vector<Voigt<dim>> values_at(const FEValuesBase<dim>                               &values) const;

  private:
    const Discretization<dim>     &discretization;
    const ElasticityOperator<dim> &elasticity;
    DoFHandler<dim>                scalar_dofs;
    Constraints                    hanging;
    std::vector<LA::Vector>        components;
  };
} // namespace Amontons

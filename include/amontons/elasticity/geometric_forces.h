// What stress adds to the tangent at small strain: the stiffness of strings, the softness of columns.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>

namespace Amontons
{
  // int (grad v sigma) : grad phi_i for all degrees of freedom i as if they were free, with the stress sigma
  // of the displacement u, made smaller where it exceeds most_strain times Young's modulus. u, v: readable at
  // relevant DoFs. Collective.
  template <int dim>
  LA::Vector
  geometric_forces(const ElasticityOperator<dim> &bodies,
                   const Discretization<dim>     &discretization,
                   const LA::Vector              &u,
                   const LA::Vector              &v,
                   const double                   most_strain);
} // namespace Amontons

/// What acts on the nodes of the bodies.
#pragma once

#include <amontons/discretization/dof_places.h>
#include <amontons/output/quantities.h>

namespace Amontons
{
  /// Of the owned DoFs, in their order; those of rigid bodies and carriers have no body. Finite strain: where
  /// they are now.
  template <int dim>
  std::vector<DofPlace<dim>>
  locate_dofs(const Answer<dim> &answer);

  /// X x F of a force along component c: one number in 2D, three in 3D.
  template <int dim>
  std::vector<double>
  moment_of(const Point<dim> &X, const unsigned int c, const double force)
  {
    if (dim == 2)
      return {c == 0 ? -X[1] * force : X[0] * force};
    std::vector<double> m(3, 0.);
    m[(c + 1) % 3] += X[(c + 2) % 3] * force;
    m[(c + 2) % 3] -= X[(c + 1) % 3] * force;
    return m;
  }

  /// internal - external - contact forces, on the owned DoFs in their order, what hanging nodes carry on
  /// their parents; 0 where no body is.
  template <int dim>
  std::vector<double>
  support_forces(const Answer<dim> &answer, const std::vector<DofPlace<dim>> &places);

  /// On every DoF of slave and master: -+ weight area Lambda with Lambda = p normal + shear.
  template <int dim>
  std::map<types::global_dof_index, double>
  contact_forces(const Answer<dim> &answer);
} // namespace Amontons

// Small conversions between points.
#pragma once

#include <deal.II/base/point.h>

namespace Amontons
{
  // The scene speaks of three coordinates always.
  template <int dim>
  dealii::Point<3>
  as_3d(const dealii::Point<dim> &p)
  {
    dealii::Point<3> q;
    for (unsigned int d = 0; d < dim; ++d)
      q[d] = p[d];
    return q;
  }

  template <int dim>
  dealii::Tensor<1, 3>
  as_3d(const dealii::Tensor<1, dim> &t)
  {
    return as_3d(dealii::Point<dim>(t));
  }

  // Point xi of face f of the unit cell, the face's coordinates being the cell's remaining ones in their
  // order.
  template <int dim>
  dealii::Point<dim>
  on_unit_cell(const unsigned int f, const dealii::Point<dim - 1> &xi)
  {
    dealii::Point<dim> p;
    unsigned int       k = 0;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = d == f / 2 ? f % 2 : xi[k++];
    return p;
  }
} // namespace Amontons

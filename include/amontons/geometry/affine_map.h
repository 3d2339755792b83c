// Motions of rigid obstacles.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // x = A X + b
  template <int dim>
  struct AffineMap
  {
    dealii::Point<dim>
    operator()(const dealii::Point<dim> &X) const
    {
      return dealii::Point<dim>(A * X + b);
    }

    dealii::Point<dim>
    origin_of(const dealii::Point<dim> &x) const
    {
      return dealii::Point<dim>(invert(A) * (x - b));
    }

    dealii::Tensor<2, dim> A = dealii::unit_symmetric_tensor<dim>();
    dealii::Tensor<1, dim> b;
  };
} // namespace Amontons

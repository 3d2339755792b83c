/// Where the degrees of freedom are.
#pragma once

#include <amontons/discretization/discretization.h>

namespace Amontons
{
  constexpr unsigned int no_body = numbers::invalid_unsigned_int;

  template <int dim>
  struct DofPlace
  {
    unsigned int body = no_body, component;
    Point<dim>   X;
  };

  /// By relevant DoF; where the displacement (null: none) takes them. Those that no cell of this rank has are
  /// left without body.
  template <int dim>
  std::vector<DofPlace<dim>>
  places_of_dofs(const Discretization<dim> &discretization, const LA::Vector *displacement = nullptr);
} // namespace Amontons

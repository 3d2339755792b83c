/// A scene that turns as a whole.
#pragma once

#include <amontons/discretization/discretization.h>

#include <optional>

namespace Amontons
{
  /// x -> rotation (x - from) + to
  template <int dim>
  struct RigidMotion
  {
    Tensor<2, dim> rotation;
    Point<dim>     from, to;
  };

  /// The one rigid motion by which the nodes whose displacement `supports` give in all components leave their
  /// place in `displacement`; nothing if there is none, or it does not turn. Collective.
  template <int dim>
  std::optional<RigidMotion<dim>>
  common_turn(const Discretization<dim> &discretization,
              const Constraints         &supports,
              const LA::Vector          &displacement);

  /// `displacement`, and then `motion` of everything; nothing if that breaks one of `supports`. Collective.
  template <int dim>
  std::optional<LA::Vector>
  moved(const Discretization<dim> &discretization,
        const Constraints         &supports,
        const RigidMotion<dim>    &motion,
        const LA::Vector          &displacement);
} // namespace Amontons

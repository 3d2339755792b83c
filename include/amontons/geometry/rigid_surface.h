// Analytic rigid surfaces: where a ray from the slave surface meets them.
#pragma once

#include <amontons/scene/scene.h>

namespace Amontons
{
  // The point of the obstacle's surface (at rest) that the line x + g n meets with the smallest |g| on a side
  // facing x, i.e. with n . normal(point) < 0. Empty if there is none.
  template <int dim>
  std::optional<dealii::Point<dim>>
  project_to_obstacle(const ObstacleData           &obstacle,
                      const dealii::Point<dim>     &x,
                      const dealii::Tensor<1, dim> &n);
} // namespace Amontons

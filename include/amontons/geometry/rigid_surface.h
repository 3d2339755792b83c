// Analytic rigid surfaces: where a ray from the slave surface meets them.
#pragma once

#include <amontons/geometry/affine_map.h>
#include <amontons/scene/scene.h>

namespace Amontons
{
  // A point of a surface and its outward normal, unit.
  template <int dim>
  struct SurfacePoint
  {
    dealii::Point<dim>     x;
    dealii::Tensor<1, dim> normal;
  };

  // From the axis of a cylinder in space, else from the centre; of the obstacle at rest.
  template <int dim>
  double
  distance_from_axis(const ObstacleData &obstacle, const dealii::Point<dim> &x);

  // The point of the obstacle's surface (at rest) that the line x + g n meets with the smallest |g| on a side
  // facing x, i.e. with n . normal(point) < 0. Empty if there is none.
  template <int dim>
  std::optional<SurfacePoint<dim>>
  project_to_obstacle(const ObstacleData           &obstacle,
                      const dealii::Point<dim>     &x,
                      const dealii::Tensor<1, dim> &n);

  // The same for the obstacle where `motion` has taken it.
  template <int dim>
  std::optional<SurfacePoint<dim>>
  project_to_obstacle(const ObstacleData           &obstacle,
                      const AffineMap<dim>         &motion,
                      const dealii::Point<dim>     &x,
                      const dealii::Tensor<1, dim> &n);
} // namespace Amontons

#include <amontons/base/points.h>
#include <amontons/geometry/rigid_surface.h>

#include <deal.II/base/numbers.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // The real roots of a g^2 + 2 b g + c = 0.
    std::vector<double>
    roots(const double a, const double b, const double c)
    {
      const double discriminant = b * b - a * c;
      if (discriminant < 0)
        return {};
      const double q = -(b + std::copysign(std::sqrt(discriminant), b));
      if (q == 0)
        return a == 0 ? std::vector<double>() : std::vector<double>{0.};
      std::vector<double> result = {c / q};
      if (std::abs(a * c) > 1e-14 * q * q || std::abs(a) > 1e-14 * std::abs(q))
        result.push_back(q / a);
      return result;
    }

    template <int dim>
    struct Hit
    {
      double         g;
      Tensor<1, dim> normal;
    };

    template <int dim>
    using Hits = std::vector<Hit<dim>>;

    // A surface of revolution about the axis `up` through the centre: the line x + g n relative to it,
    // with height h = h0 + g h1 and the vector from the axis t = t0 + g t1.
    template <int dim>
    struct AxialLine
    {
      AxialLine(const Point<dim>     &centre,
                const Tensor<1, dim> &up,
                const Point<dim>     &x,
                const Tensor<1, dim> &n)
          : h0((x - centre) * up), h1(n * up), t0(x - centre - h0 * up), t1(n - h1 * up)
      {
      }

      double         h0, h1;
      Tensor<1, dim> t0, t1;
    };

    // h = 0
    template <int dim>
    Hits<dim>
    meet_plane(const AxialLine<dim> &line, const Tensor<1, dim> &up)
    {
      return line.h1 == 0 ? Hits<dim>() : Hits<dim>{{-line.h0 / line.h1, up}};
    }

    // |t| = radius
    template <int dim>
    Hits<dim>
    meet_cylinder(const AxialLine<dim> &line, const double radius, const bool hollow)
    {
      Hits<dim> hits;
      for (const double g : roots(line.t1 * line.t1, line.t0 * line.t1, line.t0 * line.t0 - radius * radius))
        hits.push_back({g, (hollow ? -1. : 1.) / radius * (line.t0 + g * line.t1)});
      return hits;
    }

    // h + |t|^2 / (2 radius) = 0; the normal is this function's gradient
    template <int dim>
    Hits<dim>
    meet_paraboloid(const AxialLine<dim> &line, const Tensor<1, dim> &up, const double radius)
    {
      Hits<dim> hits;
      for (const double g : roots(line.t1 * line.t1,
                                  line.t0 * line.t1 + radius * line.h1,
                                  line.t0 * line.t0 + 2 * radius * line.h0))
        hits.push_back({g, up + (line.t0 + g * line.t1) / radius});
      return hits;
    }

    // h + slope |t| = 0: the roots of h^2 = slope^2 |t|^2 with h <= 0
    template <int dim>
    Hits<dim>
    meet_cone(const AxialLine<dim> &line, const Tensor<1, dim> &up, const double slope)
    {
      const double s = slope * slope;
      Hits<dim>    hits;
      for (const double g : roots(line.h1 * line.h1 - s * (line.t1 * line.t1),
                                  line.h0 * line.h1 - s * (line.t0 * line.t1),
                                  line.h0 * line.h0 - s * (line.t0 * line.t0)))
        {
          const Tensor<1, dim> t = line.t0 + g * line.t1;
          if (line.h0 + g * line.h1 <= 1e-12 * (std::abs(line.h0) + line.t0.norm()))
            hits.push_back({g, t.norm() > 0 ? up + slope / t.norm() * t : up});
        }
      return hits;
    }

    template <int dim>
    Tensor<1, dim>
    direction(const Tensor<1, 3> &v)
    {
      Tensor<1, dim> w;
      for (unsigned int d = 0; d < dim; ++d)
        w[d] = v[d];
      return w.norm() > 0 ? w / w.norm() : w;
    }

    template <int dim>
    Hits<dim>
    meet(const ObstacleData &obstacle, const AxialLine<dim> &line, const Tensor<1, dim> &up)
    {
      switch (obstacle.type)
        {
          case ObstacleData::Type::plane:
            return meet_plane(line, up);
          case ObstacleData::Type::sphere:
          case ObstacleData::Type::cylinder:
            return meet_cylinder(line, obstacle.radius, obstacle.hollow);
          case ObstacleData::Type::paraboloid:
            return meet_paraboloid(line, up, obstacle.radius);
          case ObstacleData::Type::cone:
            return meet_cone(line, up, std::tan(obstacle.flank * numbers::PI / 180));
        }
      return {};
    }
  } // namespace

  template <int dim>
  double
  distance_from_axis(const ObstacleData &obstacle, const Point<dim> &x)
  {
    Tensor<1, 3> r = as_3d(x) - obstacle.centre;
    if (dim == 3 && obstacle.type == ObstacleData::Type::cylinder)
      r -= (r * obstacle.axis) * obstacle.axis;
    return r.norm();
  }

  template <int dim>
  std::optional<SurfacePoint<dim>>
  project_to_obstacle(const ObstacleData &obstacle, const Point<dim> &x, const Tensor<1, dim> &n)
  {
    Point<dim> centre;
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = obstacle.centre[d];

    // a sphere (and in 2D a cylinder) has no axis: all of x - centre is "from the axis"
    const bool     is_sphere   = obstacle.type == ObstacleData::Type::sphere;
    const bool     is_cylinder = obstacle.type == ObstacleData::Type::cylinder;
    Tensor<1, dim> up;
    if (is_cylinder && dim == 3)
      up = direction<dim>(obstacle.axis);
    else if (!is_sphere && !is_cylinder)
      up = direction<dim>(obstacle.normal);

    const AxialLine<dim>    line(centre, up, x, n);
    const bool              is_limited = obstacle.size > 0 && !is_sphere && !is_cylinder;
    std::optional<Hit<dim>> nearest;
    for (const Hit<dim> &hit : meet(obstacle, line, up))
      if (n * hit.normal < 0 &&
          (!is_limited || (line.t0 + hit.g * line.t1).norm() <= obstacle.size * (1 + 1e-12)) &&
          (!nearest || std::abs(hit.g) < std::abs(nearest->g)))
        nearest = hit;
    if (!nearest)
      return {};
    return SurfacePoint<dim>{x + nearest->g * n, nearest->normal / nearest->normal.norm()};
  }

  // Lines are taken back to the obstacle at rest; A^-T takes its normals forward.
  template <int dim>
  std::optional<SurfacePoint<dim>>
  project_to_obstacle(const ObstacleData   &obstacle,
                      const AffineMap<dim> &motion,
                      const Point<dim>     &x,
                      const Tensor<1, dim> &n)
  {
    const Tensor<2, dim> back       = invert(motion.A);
    auto                 projection = project_to_obstacle(obstacle, motion.origin_of(x), back * n);
    if (!projection)
      return {};
    const Tensor<1, dim> normal = transpose(back) * projection->normal;
    return SurfacePoint<dim>{motion(projection->x), normal / normal.norm()};
  }

#define INSTANTIATE(dim)                                                                                     \
  template double                           distance_from_axis(const ObstacleData &, const Point<dim> &);    \
  template std::optional<SurfacePoint<dim>> project_to_obstacle(                                             \
      const ObstacleData &, const Point<dim> &, const Tensor<1, dim> &);                                     \
  template std::optional<SurfacePoint<dim>> project_to_obstacle(                                             \
      const ObstacleData &, const AffineMap<dim> &, const Point<dim> &, const Tensor<1, dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Amontons

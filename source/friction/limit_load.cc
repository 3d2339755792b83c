#include <amontons/friction/limit_load.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/householder.h>
#include <deal.II/lac/vector.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    using Vector = dealii::Vector<double>;

    // A force of unit length on the boundary of C, with its two parts, and its weight in the nearest point.
    struct Ray
    {
      Vector direction, pressure, shear;
      double weight = 0;
    };

    // Of one contact, the ray that does most work on v.
    Ray
    steepest_ray(const RigidContact &contact, const Vector &v)
    {
      Ray ray;
      ray.pressure = Vector(contact.closing.begin(), contact.closing.end());
      ray.shear.reinit(v.size());
      std::vector<Vector> sliding;
      double              length = 0;
      for (const auto &component : contact.sliding)
        {
          sliding.emplace_back(component.begin(), component.end());
          length = std::hypot(length, sliding.back() * v);
        }
      for (const auto &component : sliding)
        if (length > 0)
          ray.shear.add(contact.friction * (component * v) / length, component);
      ray.direction = ray.pressure;
      ray.direction += ray.shear;
      if (const double norm = ray.direction.l2_norm(); norm > 1e-10)
        for (auto *part : {&ray.direction, &ray.pressure, &ray.shear})
          *part /= norm;
      return ray;
    }

    Vector
    least_squares_weights(const std::vector<Ray> &rays, const Vector &load)
    {
      dealii::FullMatrix<double> matrix(load.size(), rays.size());
      for (unsigned int j = 0; j < rays.size(); ++j)
        for (unsigned int i = 0; i < load.size(); ++i)
          matrix(i, j) = rays[j].direction(i);
      Vector weights(rays.size());
      dealii::Householder<double>(matrix).least_squares(weights, load);
      return weights;
    }

    // The nearest point of the cone of these rays (Lawson and Hanson); rays without weight are dropped.
    void
    find_weights(std::vector<Ray> &rays, const Vector &load)
    {
      while (!rays.empty())
        {
          const Vector wanted = least_squares_weights(rays, load);
          double       step   = 1;
          for (unsigned int j = 0; j < rays.size(); ++j)
            if (wanted(j) <= 0)
              step = std::min(step, rays[j].weight / (rays[j].weight - wanted(j)));
          std::vector<Ray> kept;
          for (unsigned int j = 0; j < rays.size(); ++j)
            {
              const double from = rays[j].weight;
              rays[j].weight += step * (wanted(j) - from);
              if (wanted(j) > 0 || from > step * (from - wanted(j)) * (1 + 1e-12))
                kept.push_back(rays[j]);
            }
          const bool found = kept.size() == rays.size();
          rays             = kept;
          if (found)
            return;
        }
    }

    double
    friction_work(const std::vector<Ray> &rays, const Vector &v)
    {
      double sum = 0;
      for (const auto &ray : rays)
        sum += ray.weight * (ray.shear * v);
      return sum;
    }

    // Of unit length: v less its components in the span of the pressures, unless nothing is left.
    std::vector<double>
    sliding_part(const std::vector<Ray> &rays, const Vector &v)
    {
      std::vector<Vector> span;
      Vector              left = v;
      for (const auto &ray : rays)
        {
          Vector next = ray.pressure;
          for (const auto &direction : span)
            next.add(-(direction * next), direction);
          if (next.l2_norm() <= 1e-6 * ray.pressure.l2_norm())
            continue;
          next /= next.l2_norm();
          left.add(-(next * left), next);
          span.push_back(next);
        }
      if (left.l2_norm() < 1e-3 * v.l2_norm())
        left = v;
      left /= left.l2_norm();
      return std::vector<double>(left.begin(), left.end());
    }
  } // namespace

  std::vector<double>
  motion_beyond_friction(const std::vector<double>       &load,
                         const std::vector<RigidContact> &contacts,
                         const double                     margin)
  {
    if (load.empty())
      return {};
    const Vector     f(load.begin(), load.end());
    Vector           v = f;
    std::vector<Ray> rays;
    for (unsigned int n = 0; n < 200 && v.l2_norm() > margin; ++n)
      {
        Ray    best;
        double most = 0;
        for (const auto &contact : contacts)
          {
            Ray          ray  = steepest_ray(contact, v);
            const double work = ray.direction * v / v.l2_norm();
            if (work > most)
              {
                most = work;
                best = ray;
              }
          }
        if (most <= 1e-7)
          return friction_work(rays, v) > margin * v.l2_norm() ? sliding_part(rays, v)
                                                               : std::vector<double>();
        rays.push_back(best);
        find_weights(rays, f);
        v = f;
        for (const auto &ray : rays)
          v.add(-ray.weight, ray.direction);
      }
    return {};
  }
} // namespace Amontons

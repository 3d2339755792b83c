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

    double
    product(const std::vector<double> &a, const Vector &b)
    {
      double sum = 0;
      for (unsigned int i = 0; i < b.size(); ++i)
        sum += a[i] * b(i);
      return sum;
    }

    // friction_k d of the contact's force that does most work on v.
    std::vector<double>
    steepest_shear(const RigidContact &contact, const Vector &v)
    {
      std::vector<double> shear;
      double              length = 0;
      for (const auto &component : contact.sliding)
        {
          shear.push_back(product(component, v));
          length = std::hypot(length, shear.back());
        }
      for (double &component : shear)
        component *= length > 0 ? contact.friction / length : 0;
      return shear;
    }

    // Of one contact, the ray that does most work on v.
    Ray
    steepest_ray(const RigidContact &contact, const Vector &v)
    {
      Ray ray;
      ray.pressure = Vector(contact.closing.begin(), contact.closing.end());
      ray.shear.reinit(v.size());
      const auto shear = steepest_shear(contact, v);
      for (unsigned int c = 0; c < shear.size(); ++c)
        for (unsigned int i = 0; i < v.size(); ++i)
          ray.shear(i) += shear[c] * contact.sliding[c][i];
      ray.direction = ray.pressure;
      ray.direction += ray.shear;
      if (const double norm = ray.direction.l2_norm(); norm > 1e-10)
        for (auto *part : {&ray.direction, &ray.pressure, &ray.shear})
          *part /= norm;
      return ray;
    }

    // Of that ray, for v of unit length.
    double
    most_work(const RigidContact &contact, const Vector &v)
    {
      const auto shear = steepest_shear(contact, v);
      double     work = 0, square = 0;
      for (unsigned int i = 0; i < v.size(); ++i)
        {
          double force = contact.closing[i];
          for (unsigned int c = 0; c < shear.size(); ++c)
            force += shear[c] * contact.sliding[c][i];
          work += force * v(i);
          square += force * force;
        }
      return square > 1e-20 ? work / std::sqrt(square) : work;
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
    // What the nearest of C leaves of the load, and its rays.
    struct Remainder
    {
      Vector           v; // empty: less than the margin
      std::vector<Ray> rays;
    };

    Remainder
    beyond_cone(const std::vector<double>       &load,
                const std::vector<RigidContact> &contacts,
                const double                     margin)
    {
      if (load.empty())
        return {};
      const Vector f(load.begin(), load.end());
      Remainder    result{f, {}};
      auto        &v = result.v;
      for (unsigned int n = 0; n < 200 && v.l2_norm() > margin; ++n)
        {
          Vector direction = v;
          direction /= v.l2_norm();
          const RigidContact *best = nullptr;
          double              most = 1e-7;
          for (const auto &contact : contacts)
            if (const double work = most_work(contact, direction); work > most)
              {
                most = work;
                best = &contact;
              }
          if (best == nullptr)
            return result;
          result.rays.push_back(steepest_ray(*best, v));
          find_weights(result.rays, f);
          v = f;
          for (const auto &ray : result.rays)
            v.add(-ray.weight, ray.direction);
        }
      v.reinit(0);
      return result;
    }
  } // namespace

  std::vector<double>
  motion_beyond_contact(const std::vector<double>       &load,
                        const std::vector<RigidContact> &contacts,
                        const double                     margin)
  {
    auto v = beyond_cone(load, contacts, margin).v;
    if (v.size() > 0)
      v /= v.l2_norm();
    return std::vector<double>(v.begin(), v.end());
  }

  std::vector<double>
  motion_beyond_friction(const std::vector<double>       &load,
                         const std::vector<RigidContact> &contacts,
                         const double                     margin)
  {
    const auto [v, rays] = beyond_cone(load, contacts, margin);
    return v.size() > 0 && friction_work(rays, v) > margin * v.l2_norm() ? sliding_part(rays, v)
                                                                         : std::vector<double>();
  }

  std::vector<double>
  combination(const std::vector<std::vector<double>> &motions, const std::vector<double> &v)
  {
    std::vector<double> q;
    for (unsigned int j = 0; j < v.size(); ++j)
      {
        q.resize(motions[j].size());
        for (unsigned int i = 0; i < q.size(); ++i)
          q[i] += v[j] * motions[j][i];
      }
    return q;
  }
} // namespace Amontons

// One piece of an overlap: all points of its quadrature formula, or none.
#pragma once

#include <amontons/contact/face_overlap.h>
#include <amontons/contact/face_ad.h>

namespace Amontons
{
  // Appends slave_point(q), q < n, completed by `opposite` (which returns whether there is anything on the
  // other side) and by the gap. Nothing stays if a point has nothing opposite, or if all gaps are above
  // `reach`.
  template <int dim, typename ToSlavePoint, typename Opposite>
  void
  append_piece(const unsigned int              n,
               const unsigned int              slave_face,
               const ToSlavePoint             &slave_point,
               const Opposite                 &opposite,
               const double                    search_distance,
               std::vector<OverlapPoint<dim>> &points)
  {
    const std::size_t before  = points.size();
    double            closest = std::numeric_limits<double>::max();
    for (unsigned int q = 0; q < n && closest >= 0; ++q)
      {
        const SlavePoint<dim, double> at = slave_point(q);
        OverlapPoint<dim>             p;
        p.slave_face     = slave_face;
        p.master_face    = numbers::invalid_unsigned_int;
        p.xi_slave       = value_of(at.xi);
        p.x_slave        = value_of(at.x);
        p.normal         = value_of(at.normal);
        p.weight         = at.weight;
        const bool found = opposite(p);
        p.gap            = p.normal * (p.x_master - p.x_slave);
        closest          = found ? std::min(closest, std::abs(p.gap)) : -1;
        points.push_back(p);
      }
    if (closest < 0 || closest > search_distance)
      points.resize(before);
  }

  template <int dim>
  auto
  project_to(const ObstacleData &obstacle, const AffineMap<dim> &motion)
  {
    return [&](OverlapPoint<dim> &p) {
      const auto projection = project_to_obstacle(obstacle, motion, p.x_slave, p.normal);
      p.x_master            = projection ? projection->x : p.x_slave;
      return projection.has_value();
    };
  }

  inline Point<1>
  as_point(const double xi)
  {
    return Point<1>(xi);
  }

  inline Point<2>
  as_point(const Point<2> &xi)
  {
    return xi;
  }

  template <int dim, typename Number>
  class Clipper;

  // overlap_faces in both dimensions.
  template <int dim>
  void
  append_overlaps(const ContactSurface<dim>       &slave,
                  const unsigned int               slave_face,
                  const ContactSurface<dim>       &master,
                  const std::vector<unsigned int> &master_faces,
                  const double                     search_distance,
                  const double                     least_opposed,
                  std::vector<OverlapPoint<dim>>  &points)
  {
    if (master_faces.empty())
      return;
    const Clipper<dim, double> clipper({slave, slave_face});
    Point<dim - 1>             middle;
    for (unsigned int d = 0; d < dim - 1; ++d)
      middle[d] = 0.5;
    for (const unsigned int m : master_faces)
      {
        if constexpr (dim == 3)
          if (clipper.misses(master.faces[m]))
            continue;
        if (clipper.normal * master.face_normal(m, middle) > -least_opposed)
          continue;
        const auto opposite = [&](OverlapPoint<dim> &p) { // may miss by rounding at the ends of a sliver
          const auto eta = project_to_master(master, m, p.x_slave, p.normal);
          if (!eta)
            return false;
          p.master_face = m;
          p.xi_master   = as_point(*eta);
          p.x_master    = master.position(m, p.xi_master);
          return true;
        };
        clipper.for_each_piece({master, m}, [&](const unsigned int n, const auto &slave_point) {
          append_piece<dim>(n, slave_face, slave_point, opposite, search_distance, points);
        });
      }
  }
} // namespace Amontons

#include <amontons/contact/face_lattice.h>
#include <amontons/contact/face_overlap.h>
#include <amontons/contact/smallest_gap.h>
#include <amontons/contact/surface_samples.h>

#include <deal.II/base/geometry_info.h>

#include <optional>

namespace Amontons
{
  template <int dim>
  std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<dim> &slave, const std::vector<OverlapPoint<dim>> &points)
  {
    std::vector<FaceGaps> result(slave.faces.size());
    for (const auto &point : points)
      {
        auto &gaps    = result[point.slave_face];
        gaps.smallest = std::min(gaps.smallest, point.gap);
        gaps.largest  = std::max(gaps.largest, point.gap);
        if (point.master_face != numbers::invalid_unsigned_int)
          gaps.opposite.insert(point.master_face);
      }
    return result;
  }

  namespace
  {
    std::optional<Point<1>>
    as_point(const std::optional<double> &xi)
    {
      return xi ? std::make_optional(Point<1>(*xi)) : std::nullopt;
    }

    std::optional<Point<2>>
    as_point(const std::optional<Point<2>> &xi)
    {
      return xi;
    }

    template <int fdim>
    bool
    is_inside(const Point<fdim> &xi)
    {
      return GeometryInfo<fdim>::is_inside_unit_cell(xi, 1e-8);
    }

    // The gap, if x + g n(xi) = y.
    template <int dim>
    std::optional<double>
    gap_to(const ContactSurface<dim> &slave,
           const unsigned int         face,
           const Point<dim - 1>      &xi,
           const Point<dim>          &y)
    {
      if (!is_inside(xi))
        return {};
      const auto           n   = slave.nodal_normal(face, xi);
      const Tensor<1, dim> d   = y - slave.position(face, xi);
      const double         gap = d * n;
      return (d - gap * n).norm() < 1e-6 * slave.faces[face].size ? std::make_optional(gap) : std::nullopt;
    }
  } // namespace

  template <int dim>
  double
  smallest_gap(const ContactInterface<dim> &interface, const unsigned int face, const FaceGaps &points)
  {
    const auto &slave  = *interface.slave;
    const auto &master = interface.master;
    double      result = points.smallest;
    const auto  look   = [&](const Point<dim - 1> &xi, const std::optional<Point<dim>> &y) {
      if (y)
        result = std::min(result, gap_to(slave, face, xi, *y).value_or(result));
    };
    auto places = Quadrature<dim - 1>(samples_along<dim>(slave.faces.size())).get_points();
    for (const auto &node : lattice<dim - 1>(slave.degree))
      places.push_back(node);
    for (const auto &xi : places)
      {
        const auto x = slave.position(face, xi);
        const auto n = slave.nodal_normal(face, xi);
        if (master.obstacle != nullptr)
          if (const auto y = project_to_obstacle(*master.obstacle, master.motion, x, n))
            look(xi, y->x);
        for (const unsigned int other : points.opposite)
          if (const auto eta = as_point(project_to_master(*master.surface, other, x, n));
              eta && is_inside(*eta))
            look(xi, master.surface->position(other, *eta));
      }
    for (const unsigned int other : points.opposite)
      for (const unsigned int node : master.surface->faces[other].nodes)
        {
          const auto &y = master.surface->nodes[node].x;
          if (const auto xi = as_point(project_to_slave(slave, face, y)))
            look(*xi, y);
        }
    return result;
  }

  template std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<2> &, const std::vector<OverlapPoint<2>> &);
  template std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<3> &, const std::vector<OverlapPoint<3>> &);
  template double
  smallest_gap(const ContactInterface<2> &, const unsigned int, const FaceGaps &);
  template double
  smallest_gap(const ContactInterface<3> &, const unsigned int, const FaceGaps &);
} // namespace Amontons

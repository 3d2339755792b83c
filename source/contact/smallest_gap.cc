#include <amontons/contact/declared_gap.h>
#include <amontons/contact/face_lattice.h>
#include <amontons/contact/face_overlap.h>
#include <amontons/contact/smallest_gap.h>
#include <amontons/contact/surface_samples.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Amontons
{
  template <int dim>
  std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<dim>            &slave,
               const std::vector<OverlapPoint<dim>> &points,
               const SurfaceApproach<dim>           &approach)
  {
    std::vector<FaceGaps> result(slave.faces.size());
    for (const auto &p : points)
      {
        const bool   at_obstacle = p.master_face == numbers::invalid_unsigned_int;
        const double nearer =
            at_obstacle ? approach.to_obstacle(p.slave_face, p.xi_slave, p.normal, p.x_master)
                        : approach.to_face(p.slave_face, p.xi_slave, p.normal, p.master_face, p.xi_master);
        auto &gaps    = result[p.slave_face];
        gaps.smallest = std::min(gaps.smallest, p.gap - nearer);
        gaps.largest  = std::max(gaps.largest, p.gap - nearer);
        if (!at_obstacle)
          gaps.opposite.insert(p.master_face);
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

    // Of places on a slave face, and what is opposite.
    template <int dim>
    class FaceGap
    {
    public:
      FaceGap(const ContactInterface<dim> &interface,
              const unsigned int           face,
              const FaceGaps              &points,
              const SurfaceApproach<dim>  &approach,
              const bool                   adds_declared)
          : slave(*interface.slave), master(interface.master), face(face), opposite(points.opposite),
            approach(approach), adds_declared(adds_declared)
      {
        if (interface.pair->initial_gap)
          declared.emplace(*interface.pair, slave, interface.t);
      }

      // To the nearest of what the normal at xi meets; infinite: nothing.
      double
      operator()(const Point<dim - 1> &xi) const
      {
        const auto x      = slave.position(face, xi);
        const auto n      = slave.nodal_normal(face, xi);
        double     result = std::numeric_limits<double>::infinity();
        if (master.obstacle != nullptr)
          if (const auto y = project_to_obstacle(*master.obstacle, master.motion, x, n))
            result = with_declared(xi, (y->x - x) * n) - approach.to_obstacle(face, xi, n, y->x);
        for (const unsigned int other : opposite)
          if (const auto eta = as_point(project_to_master(*master.surface, other, x, n));
              eta && is_inside(*eta))
            result = std::min(result,
                              with_declared(xi, (master.surface->position(other, *eta) - x) * n) -
                                  approach.to_face(face, xi, n, other, *eta));
        return result;
      }

      // To a node of the master; infinite if no normal of the face meets it.
      double
      to_node(const unsigned int node) const
      {
        const auto &y  = master.surface->nodes[node].x;
        const auto  xi = as_point(project_to_slave(slave, face, y));
        if (!xi || !is_inside(*xi))
          return std::numeric_limits<double>::infinity();
        const auto           n   = slave.nodal_normal(face, *xi);
        const Tensor<1, dim> d   = y - slave.position(face, *xi);
        const double         gap = d * n;
        return (d - gap * n).norm() < 1e-6 * slave.faces[face].size
                   ? with_declared(*xi, gap) - approach.to_node(face, *xi, n, node)
                   : std::numeric_limits<double>::infinity();
      }

    private:
      // (Not at nodes and in the middle: where a formula jumps it may have no value.)
      double
      with_declared(Point<dim - 1> xi, const double gap) const
      {
        if (!declared)
          return gap;
        for (unsigned int d = 0; d < dim - 1; ++d)
          xi[d] = 1.3e-6 + (1 - 2.3e-6) * xi[d];
        const double further = declared->jumps(face) ? declared->ramp(face, xi)
                                                     : declared->at(slave.reference_position(face, xi));
        return (adds_declared ? gap : 0) + further;
      }

      const ContactSurface<dim>      &slave;
      const MasterSide<dim>          &master;
      const unsigned int              face;
      const std::set<unsigned int>   &opposite;
      const SurfaceApproach<dim>     &approach;
      const bool                      adds_declared;
      std::optional<DeclaredGap<dim>> declared;
    };

    // From a place of the unit face on to lower values beside, by ever smaller steps.
    template <int fdim, typename Function>
    double
    descend(const Function &f, Point<fdim> xi, double step)
    {
      double lowest = f(xi);
      for (constexpr double fine = 1e-8; step > fine; step /= 2)
        for (bool goes_on = true; goes_on;)
          {
            goes_on = false;
            for (unsigned int d = 0; d < fdim; ++d)
              for (const double side : {-step, step})
                {
                  auto there = xi;
                  there[d]   = std::clamp(xi[d] + side, 0., 1.);
                  if (const double value = f(there); value < lowest)
                    {
                      lowest  = value;
                      xi      = there;
                      goes_on = true;
                    }
                }
          }
      return lowest;
    }
  } // namespace

  template <int dim>
  double
  smallest_gap(const ContactInterface<dim> &interface,
               const unsigned int           face,
               const FaceGaps              &points,
               const SurfaceApproach<dim>  &approach,
               const bool                   adds_declared)
  {
    const FaceGap<dim> gap(interface, face, points, approach, adds_declared);
    const auto         line   = samples_along<dim>(interface.slave->faces.size());
    auto               places = Quadrature<dim - 1>(line).get_points();
    for (const auto &node : lattice<dim - 1>(interface.slave->degree))
      places.push_back(node);
    std::vector<double> gaps;
    gaps.reserve(places.size());
    for (const auto &xi : places)
      gaps.push_back(gap(xi));
    const auto lowest = std::min_element(gaps.begin(), gaps.end());
    double result = std::min(points.smallest, descend(gap, places[lowest - gaps.begin()], 1. / line.size()));
    // (Hanging nodes are on chords of the true surface.)
    for (const unsigned int other : points.opposite)
      for (const unsigned int node : interface.master_surface->faces[other].nodes)
        if (const auto &parents = interface.master_surface->nodes[node].parents; parents.empty())
          result = std::min(result, gap.to_node(node));
    return result;
  }

  template std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<2> &, const std::vector<OverlapPoint<2>> &, const SurfaceApproach<2> &);
  template std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<3> &, const std::vector<OverlapPoint<3>> &, const SurfaceApproach<3> &);
  template double
  smallest_gap(const ContactInterface<2> &,
               const unsigned int,
               const FaceGaps &,
               const SurfaceApproach<2> &,
               const bool);
  template double
  smallest_gap(const ContactInterface<3> &,
               const unsigned int,
               const FaceGaps &,
               const SurfaceApproach<3> &,
               const bool);
} // namespace Amontons

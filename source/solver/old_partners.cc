#include <amontons/contact/surface_search.h>
#include <amontons/contact/face_overlap.h>
#include <amontons/solver/old_partners.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    Point<1>
    unit_point(const double xi)
    {
      return Point<1>(xi);
    }
    Point<2>
    unit_point(const Point<2> &xi)
    {
      return xi;
    }
  } // namespace

  // Of each node, the point of the overlap nearest to it.
  template <int dim>
  OldPartners<dim>::OldPartners(const std::vector<ContactInterface<dim>> &interfaces)
  {
    for (const auto &interface : interfaces)
      {
        const auto &slave    = *interface.slave;
        auto       &of_nodes = partners.emplace_back(slave.nodes.size());
        const auto  nearest  = nearest_points(interface);
        for (unsigned int n = 0; n < nearest.size() && !interface.pair->tied; ++n)
          if (const auto *const p = nearest[n])
            {
              of_nodes[n] = {p->slave_face, p->master_face, p->xi_slave, p->xi_master, {}, 0., 0.};
              if (interface.master.obstacle != nullptr)
                of_nodes[n]->on_obstacle = interface.master.motion.origin_of(p->x_master);
            }
        for (auto &of_node : of_nodes)
          if (of_node)
            of_node->gap = distance(interface, *of_node).gap;
        // Of a node that touches on faces that are chords of a curved surface the gap is -4/3 of their
        // sagitta for each direction in which it is curved, at a weighted gap of 0.
        for (const auto &row : interface.coupling.rows)
          if (auto &of_node = of_nodes[row.node])
            of_node->of_facets = std::clamp(row.gap - of_node->gap, 0., 0.3 * slave.mean_size);
        auto &of_sides = places.emplace_back();
        if (interface.master_surface && !interface.pair->tied)
          of_sides = {{places_of_sides(slave, *interface.master_surface),
                       places_of_sides(*interface.master_surface, slave)}};
      }
  }

  template <int dim>
  Point<dim>
  OldPartners<dim>::other_side(const ContactInterface<dim> &interface, const Partners &of)
  {
    return interface.master.obstacle != nullptr
               ? interface.master.motion(of.on_obstacle)
               : interface.master_surface->position(of.master_face, of.xi_master);
  }

  template <int dim>
  typename OldPartners<dim>::Distance
  OldPartners<dim>::distance(const ContactInterface<dim> &interface, const Partners &of)
  {
    const auto           x   = interface.slave->position(of.slave_face, of.xi_slave);
    const Tensor<1, dim> way = other_side(interface, of) - x,
                         n   = interface.slave->face_normal(of.slave_face, of.xi_slave);
    return {way * n, (way - (way * n) * n).norm()};
  }

  // And does not penetrate on average: beyond the edge of the contact a gap that grows fast may be negative
  // at the node itself (MovingContact::open_gap).
  template <int dim>
  bool
  OldPartners<dim>::is_still_opposite(const ContactInterface<dim> &interface,
                                      const unsigned int           node,
                                      const Partners              &old)
  {
    const auto *const p    = nearest_points(interface)[node];
    const auto       &rows = interface.coupling.rows;
    const auto        row =
        std::find_if(rows.begin(), rows.end(), [&](const auto &row) { return row.node == node; });
    return p != nullptr && row != rows.end() && std::max(row->gap, row->mean_gap) >= 0 &&
           p->x_master.distance(other_side(interface, old)) < interface.slave->mean_size;
  }

  template <int dim>
  std::vector<Point<dim>>
  OldPartners<dim>::passed_through(const std::vector<ContactInterface<dim>> &interfaces,
                                   const SolutionState<dim>                 &state) const
  {
    std::vector<Point<dim>> result;
    for (unsigned int i = 0; i < partners.size(); ++i)
      for (unsigned int n = 0; n < partners[i].size(); ++n)
        {
          const auto *known = state.contact_of(i, n);
          if (!partners[i][n] || known == nullptr || known->state != ContactStatus::open)
            continue;
          const auto   now    = distance(interfaces[i], *partners[i][n]);
          const double before = partners[i][n]->gap, h = interfaces[i].slave->mean_size;
          if (before > -0.02 * h && now.gap < -0.05 * h - partners[i][n]->of_facets &&
              before - now.gap > now.sideways && !is_still_opposite(interfaces[i], n, *partners[i][n]))
            result.push_back(interfaces[i].slave->nodes[n].X);
        }
    return result;
  }

  template <int dim>
  typename OldPartners<dim>::Places
  OldPartners<dim>::places_of_sides(const ContactSurface<dim> &side, const ContactSurface<dim> &other)
  {
    Places result;
    for (const auto &node : side.nodes)
      result.nodes.push_back(node.x);
    for (const auto &face : other.faces)
      result.faces.push_back(face.centre);
    return result;
  }

  // Whether the way of the node, as a face of the other side sees it, crosses that face from outside to
  // inside.
  template <int dim>
  bool
  OldPartners<dim>::enters(const ContactSurface<dim> &side,
                           const unsigned int         node,
                           const ContactSurface<dim> &other,
                           const Places              &old)
  {
    const Point<dim> x = side.nodes[node].x;
    Point<dim - 1>   middle;
    for (unsigned int d = 0; d < dim - 1; ++d)
      middle[d] = 0.5;
    for (unsigned int f = 0; f < other.faces.size(); ++f)
      {
        const auto    &face  = other.faces[f];
        Tensor<1, dim> way   = (x - old.nodes[node]) - (face.centre - old.faces[f]);
        const double   moved = way.norm(), nothing = 1e-3 * face.size;
        if (moved == 0 || x.distance(face.centre) > face.size + moved)
          continue;
        way /= moved;
        if (way * other.face_normal(f, middle) > -1e-3)
          continue;
        if (const auto xi = project_to_master(other, f, x, way))
          if (const auto at = unit_point(*xi); GeometryInfo<dim - 1>::is_inside_unit_cell(at, 1e-8))
            if (const double depth = (x - other.position(f, at)) * way;
                depth > nothing && depth < moved + nothing)
              return true;
      }
    return false;
  }

  template <int dim>
  std::vector<Point<dim>>
  OldPartners<dim>::entered(const std::vector<ContactInterface<dim>> &interfaces) const
  {
    std::vector<Point<dim>> result;
    for (unsigned int i = 0; i < places.size(); ++i)
      if (!places[i][0].nodes.empty())
        {
          const auto &slave = *interfaces[i].slave, &master = *interfaces[i].master_surface;
          std::array<std::vector<bool>, 2> seen = {
              {std::vector<bool>(slave.nodes.size(), false), std::vector<bool>(master.nodes.size(), false)}};
          for (const auto &point : interfaces[i].coupling.points)
            {
              for (const unsigned int node : slave.faces[point.slave_face].nodes)
                seen[0][node] = true;
              for (const unsigned int node : master.faces[point.master_face].nodes)
                seen[1][node] = true;
            }
          const std::array<const ContactSurface<dim> *, 2> sides = {{&slave, &master}};
          for (unsigned int s = 0; s < 2; ++s)
            for (unsigned int node = 0; node < sides[s]->nodes.size(); ++node)
              if (!seen[s][node] && enters(*sides[s], node, *sides[1 - s], places[i][s]))
                result.push_back(sides[s]->nodes[node].X);
        }
    return result;
  }

  template class OldPartners<2>;
  template class OldPartners<3>;
} // namespace Amontons

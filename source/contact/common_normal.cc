#include <amontons/contact/common_normal.h>
#include <amontons/contact/surface_rim.h>
#include <amontons/geometry/rigid_surface.h>

namespace Amontons
{
  namespace
  {
    double
    compliance(const BodyData &body)
    {
      return body.rigid ? 0. : (1 - std::pow(body.material.poisson, 2)) / body.material.young;
    }

    // Continuous from face to face, unless an edge of the body is near (15 degrees): that has no normal, and
    // faces keep theirs.
    template <int dim>
    Tensor<1, dim>
    smooth_normal(const ContactSurface<dim> &surface, const unsigned int face, const Point<dim - 1> &xi)
    {
      const Tensor<1, dim> own       = surface.face_normal(face, xi);
      const auto          &nodes     = surface.faces[face].nodes;
      const bool           is_smooth = std::all_of(nodes.begin(), nodes.end(), [&](const unsigned int node) {
        return surface.nodes[node].normal * own > 0.966;
      });
      return is_smooth ? surface.nodal_normal(face, xi) : own;
    }

    // Across a plane of symmetry surfaces go on.
    template <int dim>
    std::vector<bool>
    free_ends(const ContactSurface<dim> &surface)
    {
      auto result = rim_nodes(surface);
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = result[i] && surface.nodes[i].symmetry_planes.empty();
      return result;
    }

    // Cosine between the normals of both sides, of which a common one is made.
    constexpr double none = 0.7, whole = 0.9, none_at_end = 0.5, whole_at_end = 0.6;
  } // namespace

  template <int dim>
  Tensor<1, dim>
  normal_of_other_side(const MasterSide<dim> &master, const OverlapPoint<dim> &point)
  {
    if (master.surface != nullptr)
      return smooth_normal(*master.surface, point.master_face, point.xi_master);
    const auto projection = project_to_obstacle(*master.obstacle, master.motion, point.x_slave, point.ray);
    return projection ? projection->normal : -point.ray;
  }

  template <int dim>
  bool
  slave_end_presses(const ContactInterface<dim> &interface, const std::vector<OverlapPoint<dim>> &points)
  {
    constexpr double leaning = 0.01, alike = 1e-6; // slope of the gap; part of a face
    if (points.empty() || interface.pair->tied || interface.pair->initial_gap)
      return false;
    const auto &slave  = *interface.slave;
    const auto  is_end = free_ends(slave);
    double      least  = std::numeric_limits<double>::infinity();
    for (const auto &p : points)
      least = std::min(least, p.gap);
    const auto is_nearest = [&](const OverlapPoint<dim> &closest, const Point<dim> &x) { // of its face
      const double distance = closest.x_slave.distance(x);
      return std::none_of(points.begin(), points.end(), [&](const auto &p) {
        return p.slave_face == closest.slave_face && p.x_slave.distance(x) < (1 - 1e-6) * distance;
      });
    };
    return std::any_of(points.begin(), points.end(), [&](const auto &p) {
      const auto &face = slave.faces[p.slave_face];
      if (p.gap > least + alike * face.size)
        return false;
      const Tensor<1, dim> M = normal_of_other_side(interface.master, p);
      return std::any_of(face.nodes.begin(), face.nodes.end(), [&](const unsigned int i) {
        const auto          &node = slave.nodes[i];
        const Tensor<1, dim> way  = node.x - p.x_slave;
        // Less on the whole way, and still falling at its end.
        return is_end[i] && M * way < -leaning * way.norm() &&
               M * (way - (way * node.normal) * node.normal) < -leaning * way.norm() && is_nearest(p, node.x);
      });
    });
  }

  template <int dim>
  void
  hold_end_normals(ContactInterface<dim> &interface)
  {
    if (interface.master.obstacle == nullptr || !end_presses(interface))
      return;
    auto      &nodes  = interface.slave->nodes;
    const auto is_end = free_ends(*interface.slave);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      if (is_end[i])
        {
          const auto opposite = project_to_obstacle(
              *interface.master.obstacle, interface.master.motion, nodes[i].x, nodes[i].normal);
          nodes[i].holds_normal = opposite && nodes[i].normal * opposite->normal < -none_at_end;
          if (nodes[i].holds_normal)
            nodes[i].normal = -opposite->normal;
        }
  }

  template <int dim>
  Tensor<1, dim>
  common_normal(const Scene &scene, const ContactInterface<dim> &interface, const OverlapPoint<dim> &point)
  {
    const bool is_end = end_presses(interface);
    double     part   = 1; // of the other side's
    if (!is_end)
      {
        const double C = compliance(scene.bodies[interface.slave->body]),
                     D = compliance(scene.bodies[interface.master.surface->body]);
        part           = D > 0 ? D / (C + D) : 0;
      }
    if (part == 0)
      return point.ray;
    const Tensor<1, dim> other = -normal_of_other_side(interface.master, point);
    const double         least = is_end ? none_at_end : none, most = is_end ? whole_at_end : whole,
                 near      = std::clamp((point.ray * other - least) / (most - least), 0., 1.);
    const Tensor<1, dim> n = point.ray + near * part * (other - point.ray);
    return n / n.norm();
  }

  template Tensor<1, 2>
  common_normal(const Scene &, const ContactInterface<2> &, const OverlapPoint<2> &);
  template Tensor<1, 3>
  common_normal(const Scene &, const ContactInterface<3> &, const OverlapPoint<3> &);
  template void
  hold_end_normals(ContactInterface<2> &);
  template void
  hold_end_normals(ContactInterface<3> &);
  template bool
  slave_end_presses(const ContactInterface<2> &, const std::vector<OverlapPoint<2>> &);
  template bool
  slave_end_presses(const ContactInterface<3> &, const std::vector<OverlapPoint<3>> &);
  template Tensor<1, 2>
  normal_of_other_side(const MasterSide<2> &, const OverlapPoint<2> &);
  template Tensor<1, 3>
  normal_of_other_side(const MasterSide<3> &, const OverlapPoint<3> &);
} // namespace Amontons

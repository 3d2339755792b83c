#include <amontons/base/directions.h>
#include <amontons/solver/node_planes.h>

namespace Amontons
{
  namespace
  {
    // The normal, then what is square to it and in the planes.
    template <int dim>
    std::array<Tensor<1, dim>, dim>
    directions_at_ridge(const std::vector<Tensor<1, dim>> &planes, const Tensor<1, dim> &normal)
    {
      std::vector<Tensor<1, dim>> used = {normal / normal.norm()};
      for (const auto &plane : planes)
        if (const auto v = without(plane, used); v.norm() > 1e-6)
          used.push_back(v / v.norm());
      std::array<Tensor<1, dim>, dim> result;
      result[0]       = used[0];
      const auto left = directions_left(used);
      std::copy(left.begin(), left.end(), result.begin() + 1);
      return result;
    }

    // The axes where there are no planes. Else the normal and as many axes as are independent of it and of
    // the planes' normals, made orthogonal.
    template <int dim>
    std::array<Tensor<1, dim>, dim>
    directions_in(const std::vector<Tensor<1, dim>> &planes, const Tensor<1, dim> &normal)
    {
      std::vector<Tensor<1, dim>> used = planes, all;
      if (const auto in_planes = without(normal / normal.norm(), planes);
          !planes.empty() && in_planes.norm() >= 0.1)
        {
          all.push_back(in_planes / in_planes.norm());
          used.push_back(all[0]);
        }
      for (const auto &direction : directions_left(used))
        all.push_back(direction);
      std::array<Tensor<1, dim>, dim> result;
      std::copy_n(all.begin(), std::min<std::size_t>(dim, all.size()), result.begin());
      return result;
    }

    template <int dim>
    std::vector<Tensor<1, dim>>
    planes_and_walls(const SurfaceNode<dim> &node)
    {
      auto result = node.symmetry_planes;
      result.insert(result.end(), node.walls.begin(), node.walls.end());
      return result;
    }

    // Of the slave's node: nodes of the same plane are opposite.
    template <int dim>
    bool
    is_shared(const Tensor<1, dim> &plane, const ContactInterface<dim> &interface, const MortarRow<dim> &row)
    {
      for (const auto &other : interface.master_surface->nodes)
        for (const auto &others : planes_and_walls(other))
          if (std::abs(others * plane) > 1 - 1e-10 &&
              std::any_of(row.master.begin(), row.master.end(), [&](const auto &entry) {
                return entry.first == other.dofs;
              }))
            return true;
      return false;
    }

    // At a plane that the slave's surface does not cross smoothly.
    template <int dim>
    bool
    is_at_ridge(const ContactInterface<dim> &interface, const MortarRow<dim> &row)
    {
      const auto &node   = interface.slave->nodes[row.node];
      const auto  planes = planes_and_walls(node);
      return planes.size() > node.crossed_planes.size() && interface.master_surface &&
             std::any_of(planes.begin(), planes.end(), [&](const auto &plane) {
               return is_shared(plane, interface, row);
             });
    }

    // Those that what is opposite stays in, too: else the node slides along it, or holds it.
    template <int dim>
    std::vector<Tensor<1, dim>>
    shared_planes(std::vector<Tensor<1, dim>>  planes,
                  const ContactInterface<dim> &interface,
                  const MortarRow<dim>        &row)
    {
      if (interface.master_surface)
        planes.erase(std::remove_if(planes.begin(),
                                    planes.end(),
                                    [&](const auto &plane) { return !is_shared(plane, interface, row); }),
                     planes.end());
      return planes;
    }
  } // namespace

  template <int dim>
  NodePlanes<dim>
  planes_at(const ContactInterface<dim> &interface, const MortarRow<dim> &row)
  {
    const auto     &node = interface.slave->nodes[row.node];
    const bool      tied = interface.pair->tied;
    NodePlanes<dim> result;
    result.ridge  = (tied || interface.pair->has_friction()) && is_at_ridge(interface, row);
    result.planes = shared_planes(result.ridge ? planes_and_walls(node)
                                  : tied       ? node.symmetry_planes
                                               : node.crossed_planes,
                                  interface,
                                  row);
    result.directions = result.ridge ? directions_at_ridge(result.planes, row.normal)
                                     : directions_in(result.planes, row.normal);
    return result;
  }

  template NodePlanes<2>
  planes_at(const ContactInterface<2> &, const MortarRow<2> &);
  template NodePlanes<3>
  planes_at(const ContactInterface<3> &, const MortarRow<3> &);
} // namespace Amontons

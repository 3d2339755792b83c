#include <amontons/contact/supported_nodes.h>
#include <amontons/geometry/rigid_surface.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    bool
    is_prescribed(const SurfaceNode<dim> &node, const Constraints &supports)
    {
      return std::all_of(node.dofs.begin(), node.dofs.end(), [&](const auto dof) {
        return supports.is_constrained(dof) && supports.get_constraint_entries(dof)->empty();
      });
    }

    // Of the points opposite of something, the one nearest to each node.
    template <int dim>
    std::vector<const OverlapPoint<dim> *>
    nearest_points(const ContactInterface<dim> &interface)
    {
      const auto                            &slave = *interface.slave;
      std::vector<const OverlapPoint<dim> *> result(slave.nodes.size(), nullptr);
      for (const auto &p : interface.coupling.points)
        for (const unsigned int n : slave.faces[p.slave_face].unknowns)
          if (result[n] == nullptr || p.x_slave.distance_square(slave.nodes[n].x) <
                                          result[n]->x_slave.distance_square(slave.nodes[n].x))
            result[n] = &p;
      return result;
    }

    template <int dim>
    Tensor<1, dim>
    displacement_of_obstacle(const Discretization<dim> &discretization,
                             const unsigned int         carrier,
                             const Point<dim>          &X,
                             const LA::Vector          &u)
    {
      const auto     weights = discretization.carrier_weights(carrier, X);
      Tensor<1, dim> result;
      for (unsigned int k = 0; k <= dim; ++k)
        for (unsigned int c = 0; c < dim; ++c)
          result[c] += weights[k] * u(discretization.carrier_dofs[carrier][k][c]);
      return result;
    }

    // At the reference configuration, and now.
    template <int dim>
    std::array<double, 2>
    overlaps(const Discretization<dim> &discretization,
             const MasterSide<dim>     &master,
             const SurfaceNode<dim>    &node,
             const Tensor<1, dim>      &normal,
             const LA::Vector          &u)
    {
      const auto   at_rest = project_to_obstacle(*master.obstacle, node.X, normal);
      const double before  = at_rest ? std::max(0., -(at_rest->x - node.X) * normal) : 0.;
      if (!discretization.finite_strain)
        {
          if (!at_rest)
            return {};
          Tensor<1, dim> moved = -displacement_of_obstacle(discretization, master.carrier, at_rest->x, u);
          for (unsigned int c = 0; c < dim; ++c)
            moved[c] += u(node.dofs[c]);
          return {before, moved * normal - (at_rest->x - node.X) * normal};
        }
      const auto now = project_to_obstacle(*master.obstacle, master.motion, node.x, normal);
      return {before, now ? -(now->x - node.x) * normal : 0.};
    }
  } // namespace

  template <int dim>
  std::vector<Point<dim>>
  driven_through(const Discretization<dim>                &discretization,
                 const Constraints                        &supports,
                 const LA::Vector                         &u,
                 const std::vector<ContactInterface<dim>> &interfaces)
  {
    constexpr double        too_much = 0.1;
    std::vector<Point<dim>> result;
    for (const auto &interface : interfaces)
      {
        if (interface.master.obstacle == nullptr || interface.pair->tied || interface.pair->initial_gap)
          continue;
        const auto &nodes   = interface.slave->nodes;
        const auto  nearest = nearest_points(interface);
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (nearest[n] != nullptr && is_prescribed(nodes[n], supports))
            {
              const auto [before, now] =
                  overlaps(discretization, interface.master, nodes[n], nearest[n]->normal, u);
              if (now > before + too_much * interface.slave->mean_size)
                result.push_back(nodes[n].X);
            }
      }
    return result;
  }

  template std::vector<Point<2>>
  driven_through(const Discretization<2> &,
                 const Constraints &,
                 const LA::Vector &,
                 const std::vector<ContactInterface<2>> &);
  template std::vector<Point<3>>
  driven_through(const Discretization<3> &,
                 const Constraints &,
                 const LA::Vector &,
                 const std::vector<ContactInterface<3>> &);
} // namespace Amontons

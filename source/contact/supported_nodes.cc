#include <amontons/contact/supported_nodes.h>
#include <amontons/contact/surface_search.h>
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
          Point<dim> x = node.X;
          for (unsigned int c = 0; c < dim; ++c)
            x[c] += u(node.dofs[c]);
          return {before, (x - carrier_motion(discretization, master.carrier, u)(at_rest->x)) * normal};
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
        const auto               &nodes = interface.slave->nodes;
        std::vector<unsigned int> prescribed;
        for (unsigned int n = 0; n < nodes.size(); ++n)
          if (is_prescribed(nodes[n], supports))
            prescribed.push_back(n);
        if (prescribed.empty())
          continue;
        const auto nearest = nearest_points(interface);
        for (const unsigned int n : prescribed)
          if (nearest[n] != nullptr)
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

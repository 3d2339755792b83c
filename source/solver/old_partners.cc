#include <amontons/solver/old_partners.h>

namespace Amontons
{
  // Of each node, the point of the overlap nearest to it.
  template <int dim>
  OldPartners<dim>::OldPartners(const std::vector<ContactInterface<dim>> &interfaces)
  {
    for (const auto &interface : interfaces)
      {
        const auto         &slave = *interface.slave;
        std::vector<double> nearest(slave.nodes.size(), std::numeric_limits<double>::max());
        auto               &of_nodes = partners.emplace_back(slave.nodes.size());
        for (const auto &p : interface.coupling.points)
          for (const unsigned int n : slave.faces[p.slave_face].unknowns)
            {
              const double away = p.x_slave.distance_square(slave.nodes[n].x);
              if (interface.pair->tied || away >= nearest[n])
                continue;
              nearest[n]  = away;
              of_nodes[n] = {p.slave_face, p.master_face, p.xi_slave, p.xi_master, {}, 0.};
              if (interface.master.obstacle != nullptr)
                of_nodes[n]->on_obstacle = interface.master.motion.origin_of(p.x_master);
            }
        for (auto &of_node : of_nodes)
          if (of_node)
            of_node->gap = distance(interface, *of_node).gap;
      }
  }

  template <int dim>
  typename OldPartners<dim>::Distance
  OldPartners<dim>::distance(const ContactInterface<dim> &interface, const Partners &of)
  {
    const auto           x   = interface.slave->position(of.slave_face, of.xi_slave);
    const auto           y   = interface.master.obstacle != nullptr
                                   ? interface.master.motion(of.on_obstacle)
                                   : interface.master_surface->position(of.master_face, of.xi_master);
    const Tensor<1, dim> way = y - x, n = interface.slave->face_normal(of.slave_face, of.xi_slave);
    return {way * n, (way - (way * n) * n).norm()};
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
          if (before > -0.02 * h && now.gap < -0.05 * h && before - now.gap > now.sideways)
            result.push_back(interfaces[i].slave->nodes[n].X);
        }
    return result;
  }

  template class OldPartners<2>;
  template class OldPartners<3>;
} // namespace Amontons

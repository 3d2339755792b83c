#include <amontons/contact/common_normal.h>
#include <amontons/contact/declared_gap.h>
#include <amontons/contact/node_to_segment.h>
#include <amontons/contact/shared_nodes.h>
#include <amontons/contact/smallest_gap.h>
#include <amontons/contact/surface_search.h>
#include <amontons/discretization/elimination.h>

namespace Amontons
{
  template <int dim>
  std::vector<ContactInterface<dim>>
  make_interfaces(const Discretization<dim> &discretization, const std::vector<bool> &first_is_slave)
  {
    const Scene &scene = discretization.scene;
    // Slave and master, if meshed, of one pair after the other.
    std::vector<BoundaryName> names;
    for (unsigned int i = 0; i < scene.pairs.size(); ++i)
      {
        const PairData &pair = scene.pairs[i];
        names.push_back(pair.second && !first_is_slave[i] ? *pair.second : pair.first);
        if (pair.second)
          names.push_back(first_is_slave[i] ? *pair.second : pair.first);
      }
    std::vector<OwnedFaces<dim>> own;
    own.reserve(names.size());
    for (const auto &name : names)
      own.emplace_back(discretization, name);

    std::vector<ContactInterface<dim>> interfaces;
    unsigned int                       n    = 0;
    const auto                         next = [&]() {
      auto surface = std::make_unique<ContactSurface<dim>>(discretization, names[n], std::move(own[n]));
      ++n;
      return surface;
    };
    for (const auto &pair : scene.pairs)
      {
        ContactInterface<dim> interface;
        interface.pair  = &pair;
        interface.slave = next();
        if (pair.second)
          {
            interface.master_surface = next();
            interface.master.surface = interface.master_surface.get();
          }
        else
          for (const auto &obstacle : scene.obstacles)
            if (obstacle.name == pair.obstacle)
              {
                interface.master.obstacle = &obstacle;
                interface.master.carrier  = discretization.geometry.carrier(obstacle.motion.name);
              }
        interfaces.push_back(std::move(interface));
      }
    return interfaces;
  }

  namespace
  {
    template <int dim>
    std::vector<bool>
    find_carrying_nodes(const ContactSurface<dim> &slave, const Constraints &supports, const bool tied)
    {
      std::vector<bool> carries;
      for (const auto &node : slave.nodes)
        {
          if (!node.parents.empty()) // hanging nodes are no unknowns of their own
            {
              carries.push_back(false);
              continue;
            }
          LinearEquation equation;
          bool           any_free = false;
          for (unsigned int c = 0; c < dim; ++c)
            {
              equation.coefficients[node.dofs[c]] = node.normal[c];
              any_free                            = any_free || !supports.is_constrained(node.dofs[c]);
            }
          substitute(equation, supports);
          const std::vector<types::global_dof_index> own(node.dofs.begin(), node.dofs.end());
          carries.push_back(tied ? any_free : choose_pivot(equation, supports, own).has_value());
        }
      return carries;
    }
  } // namespace

  namespace
  {
    template <int dim>
    std::vector<bool>
    nodes_with_rows(const ContactInterface<dim> &interface)
    {
      std::vector<bool> result(interface.slave->nodes.size(), false);
      for (const auto &row : interface.coupling.rows)
        result[row.node] = true;
      return result;
    }

    // alone: no other pair has taken nodes.
    template <int dim>
    void
    integrate(const Discretization<dim>     &discretization,
              std::vector<OverlapPoint<dim>> points,
              const std::vector<bool>       &carries,
              const bool                     stays,
              const bool                     alone,
              ContactInterface<dim>         &interface)
    {
      const bool faces_something = !points.empty();
      bool       any_carries     = false; // of the nodes of which something is covered
      for (const auto &p : points)
        for (const unsigned int node : interface.slave->faces[p.slave_face].unknowns)
          any_carries = any_carries || carries[node];
      interface.n_without_multiplier = 0;
      for (unsigned int i = 0; i < carries.size(); ++i)
        if (!carries[i] && interface.slave->nodes[i].parents.empty())
          ++interface.n_without_multiplier;
      interface.coupling = integrate_coupling(discretization,
                                              *interface.slave,
                                              interface.master,
                                              std::move(points),
                                              carries,
                                              interface.carried,
                                              stays);
      if (interface.collocated && !interface.pair->tied)
        collocate(discretization, interface);
      interface.carried = nodes_with_rows(interface);
      if (!faces_something || interface.slave->moved || !interface.coupling.rows.empty())
        return;
      if (any_carries && must_face(discretization, *interface.pair))
        throw not_facing(interface, "along the normals next to nothing of one is opposite of the other");
      if (!any_carries && alone)
        throw InputError(
            interface.pair->where,
            "supports hold every node of the slave side, so that it cannot carry a contact pressure",
            "the other side as slave ('Slave = first' or 'second')");
    }
  } // namespace

  template <int dim>
  bool
  move_interface(const Discretization<dim> &discretization,
                 const LA::Vector          &u,
                 ContactInterface<dim>     &interface)
  {
    bool moves = interface.slave->move(u);
    if (interface.master_surface)
      return interface.master_surface->move(u) || moves;
    const auto motion = carrier_motion(discretization, interface.master.carrier, u);
    moves = moves || motion.A != interface.master.motion.A || motion.b != interface.master.motion.b;
    interface.master.motion = motion;
    if (moves)
      hold_end_normals(interface);
    return moves;
  }

  namespace
  {
    template <int dim>
    void
    note_first_gap(std::vector<OverlapPoint<dim>> points,
                   const bool                     finite_strain,
                   ContactInterface<dim>         &interface)
    {
      const PairData &pair = *interface.pair;
      if (finite_strain) // meshes lie as they do: nothing is closed, and declared gaps are added
        for (auto &p : points)
          p.gap = (p.x_master - p.x_slave) * p.normal + (pair.initial_gap ? p.gap : 0);
      const bool is_at_end = interface.first_gap && interface.first_gap->is_at_end;
      auto      &first     = interface.first_gap.emplace();
      first.is_at_end      = is_at_end;
      first.t              = interface.t;
      for (const auto &p : points)
        if (p.gap < first.size)
          {
            first.size  = p.gap;
            first.place = interface.slave->reference_position(p.slave_face, p.xi_slave);
          }
      for (const auto &p : points)
        if (p.gap <= first.size + 0.1 * std::abs(first.size) &&
            std::none_of(first.normals.begin(), first.normals.end(), [&](const auto &normal) {
              return normal * p.normal > 0.99;
            }))
          first.normals.push_back(p.normal);
      // Nearer by less than what it varies by over a face
      const SurfaceApproach<dim> none(interface);
      const auto                 gaps = gaps_by_face(*interface.slave, points, none);
      for (unsigned int f = 0; f < gaps.size(); ++f)
        if (const double size = interface.slave->faces[f].size;
            gaps[f].range() > 1e-4 * size && gaps[f].smallest - gaps[f].range() < first.size)
          {
            const double gap    = smallest_gap(interface, f, gaps[f], none, finite_strain);
            const bool   closed = !finite_strain && !pair.initial_gap && is_adjusted(pair, gap, size);
            first.size          = std::min(first.size, closed ? 0 : gap);
          }
    }
  } // namespace

  template <int dim>
  void
  integrate_couplings(const Discretization<dim>          &discretization,
                      const Constraints                  &supports,
                      std::vector<ContactInterface<dim>> &interfaces,
                      const bool                          moved)
  {
    const bool                     stays = !moved && !discretization.finite_strain;
    std::vector<std::vector<bool>> carries;
    for (auto &interface : interfaces)
      {
        carries.push_back(find_carrying_nodes(*interface.slave, supports, interface.pair->tied));
        auto points = find_partners(discretization, interface, moved);
        if (!moved)
          note_first_gap(points, discretization.finite_strain, interface);
        for (auto &point : points)
          point.ray = point.normal;
        if (!moved)
          interface.first_gap->is_at_end = slave_end_presses(interface, points);
        if (has_common_normals(discretization, interface))
          for (auto &point : points)
            point.normal = common_normal(discretization.scene, interface, point);
        integrate(discretization, std::move(points), carries.back(), stays, true, interface);
      }
    const auto again = resolve_crosspoints(discretization, interfaces, moved, carries);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (again[i])
          integrate(discretization, interfaces[i].coupling.points, carries[i], stays, false, interfaces[i]);
        interfaces[i].carries = std::move(carries[i]);
      }
  }

  template <int dim>
  void
  redeclare_gaps(const Discretization<dim>          &discretization,
                 const double                        t,
                 std::vector<ContactInterface<dim>> &interfaces)
  {
    const bool stays = !discretization.finite_strain;
    for (auto &interface : interfaces)
      {
        const bool changes = gap_grows(interface) && t != interface.t;
        interface.t        = t;
        if (!changes)
          continue;
        auto points = std::move(interface.coupling.points);
        declare_gaps(*interface.pair, *interface.slave, t, false, points);
        if (stays)
          note_first_gap(points, false, interface);
        integrate(discretization, std::move(points), interface.carries, stays, false, interface);
      }
  }

  template <int dim>
  void
  couple_moved(const Discretization<dim>          &discretization,
               const Constraints                  &supports,
               const LA::Vector                   &u,
               const double                        t,
               std::vector<ContactInterface<dim>> &interfaces)
  {
    bool is_new = false;
    for (auto &interface : interfaces)
      {
        is_new      = is_new || (gap_grows(interface) && t != interface.t);
        interface.t = t;
        if (!interface.pair->tied)
          is_new = move_interface(discretization, u, interface) || is_new;
        is_new = is_new || interface.carried != nodes_with_rows(interface);
      }
    if (is_new)
      integrate_couplings(discretization, supports, interfaces, true);
  }

  template void
  couple_moved(const Discretization<2> &,
               const Constraints &,
               const LA::Vector &,
               const double,
               std::vector<ContactInterface<2>> &);
  template void
  redeclare_gaps(const Discretization<2> &, const double, std::vector<ContactInterface<2>> &);
  template void
  redeclare_gaps(const Discretization<3> &, const double, std::vector<ContactInterface<3>> &);
  template void
  couple_moved(const Discretization<3> &,
               const Constraints &,
               const LA::Vector &,
               const double,
               std::vector<ContactInterface<3>> &);
  template std::vector<ContactInterface<2>>
  make_interfaces(const Discretization<2> &, const std::vector<bool> &);
  template void
  integrate_couplings(const Discretization<2> &,
                      const Constraints &,
                      std::vector<ContactInterface<2>> &,
                      const bool);
  template bool
  move_interface(const Discretization<2> &, const LA::Vector &, ContactInterface<2> &);
  template std::vector<ContactInterface<3>>
  make_interfaces(const Discretization<3> &, const std::vector<bool> &);
  template void
  integrate_couplings(const Discretization<3> &,
                      const Constraints &,
                      std::vector<ContactInterface<3>> &,
                      const bool);
  template bool
  move_interface(const Discretization<3> &, const LA::Vector &, ContactInterface<3> &);
} // namespace Amontons

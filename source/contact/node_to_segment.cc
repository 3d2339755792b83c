#include <amontons/contact/declared_gap.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/face_lattice.h>
#include <amontons/contact/face_overlap.h>
#include <amontons/contact/node_to_segment.h>

#include <deal.II/base/geometry_info.h>

namespace Amontons
{
  namespace
  {
    // Of the point where the node's normal meets a face of the other side, the nearest one.
    template <int dim>
    std::optional<OverlapPoint<dim>>
    opposite(const ContactInterface<dim>  &interface,
             const unsigned int            node,
             const std::set<unsigned int> &faces)
    {
      const auto                      &slave = interface.slave->nodes[node];
      std::optional<OverlapPoint<dim>> best;
      const auto                       consider = [&](OverlapPoint<dim> p) {
        p.x_slave = slave.x;
        p.normal  = slave.normal;
        p.gap     = slave.normal * (p.x_master - slave.x);
        if (!best || std::abs(p.gap) < std::abs(best->gap))
          best = p;
      };
      if (interface.master.obstacle != nullptr)
        {
          OverlapPoint<dim> p{};
          const auto        point =
              project_to_obstacle(*interface.master.obstacle, interface.master.motion, slave.x, slave.normal);
          if (point)
            {
              p.master_face = numbers::invalid_unsigned_int;
              p.x_master    = point->x;
              consider(p);
            }
          return best;
        }
      for (const unsigned int face : faces)
        if (const auto xi = project_to_master(*interface.master.surface, face, slave.x, slave.normal))
          {
            OverlapPoint<dim> p{};
            p.master_face = face;
            if constexpr (dim == 2)
              p.xi_master[0] = *xi;
            else
              p.xi_master = *xi;
            if (!GeometryInfo<dim - 1>::is_inside_unit_cell(p.xi_master, 1e-8))
              continue;
            p.x_master = interface.master.surface->position(face, p.xi_master);
            consider(p);
          }
      return best;
    }

    // int N_i over the overlap by slave node; hanging ones leave theirs to their parents.
    template <int dim>
    std::vector<double>
    nodal_areas(const ContactInterface<dim> &interface)
    {
      const auto         &slave = *interface.slave;
      std::vector<double> areas(slave.nodes.size(), 0.);
      for (const auto &p : interface.coupling.points)
        {
          const auto N = lagrange_values<dim - 1>(slave.degree, p.xi_slave);
          for (unsigned int k = 0; k < N.size(); ++k)
            {
              const unsigned int node = slave.faces[p.slave_face].nodes[k];
              if (slave.nodes[node].parents.empty())
                areas[node] += p.weight * N[k];
              for (const auto &[parent, weight] : slave.nodes[node].parents)
                areas[parent] += p.weight * N[k] * weight;
            }
        }
      return areas;
    }

    // B_j at the node, by slave node j: the pressure p_h has  int p_h B_j = sum_i B_j(x_i) force_i.
    template <int dim>
    std::vector<std::pair<unsigned int, double>>
    traces_at(const ContactSurface<dim> &slave, const unsigned int face_number, const unsigned int node)
    {
      const auto                                  &face  = slave.faces[face_number];
      const auto                                   place = lattice<dim - 1>(slave.degree);
      std::vector<std::pair<unsigned int, double>> result;
      for (unsigned int k = 0; k < face.nodes.size(); ++k)
        if (face.nodes[k] == node)
          {
            const auto B =
                traces_of_unknowns(bernstein_values<dim - 1>(slave.degree, place[k]), face.subdivision);
            for (unsigned int j = 0; j < B.size(); ++j)
              if (B[j] != 0)
                result.emplace_back(face.unknowns[j], B[j]);
          }
      return result;
    }
  } // namespace

  template <int dim>
  void
  collocate(const Discretization<dim> &discretization, ContactInterface<dim> &interface)
  {
    const auto &slave = *interface.slave;
    // By slave node: what lies opposite of its faces, and one of these.
    std::vector<std::set<unsigned int>> faces(slave.nodes.size());
    std::vector<unsigned int>           own(slave.nodes.size());
    for (const auto &p : interface.coupling.points)
      for (const unsigned int node : slave.faces[p.slave_face].nodes)
        {
          faces[node].insert(p.master_face);
          own[node] = p.slave_face;
        }
    const auto                  areas = nodal_areas(interface);
    std::vector<MortarRow<dim>> rows;
    for (auto &row : interface.coupling.rows)
      {
        const auto &node  = slave.nodes[row.node];
        auto        point = opposite(interface, row.node, faces[row.node]);
        if (!point || !(areas[row.node] > 0))
          continue;
        point->slave_face                       = own[row.node];
        const auto                     dofs     = master_dofs(discretization, interface.master, *point);
        const auto                     N        = master_values(discretization, interface.master, *point);
        std::vector<OverlapPoint<dim>> declared = {*point};
        declare_gaps(*interface.pair, slave, interface.t, false, declared);
        row.area       = areas[row.node];
        row.normal     = node.normal;
        row.gap        = declared[0].gap;
        row.mean_gap   = row.gap;
        row.gap_vector = row.gap * row.normal;
        row.slave      = {{node.dofs, 1.}};
        row.traces     = traces_at(slave, own[row.node], row.node);
        for (auto &trace : row.traces)
          trace.second *= row.area;
        row.master.clear();
        for (unsigned int k = 0; k < dofs.size(); ++k)
          if (std::abs(N[k]) > 1e-14)
            row.master.emplace_back(dofs[k], N[k]);
        rows.push_back(std::move(row));
      }
    interface.coupling.rows = std::move(rows);
  }

  template void
  collocate(const Discretization<2> &, ContactInterface<2> &);
  template void
  collocate(const Discretization<3> &, ContactInterface<3> &);
} // namespace Amontons

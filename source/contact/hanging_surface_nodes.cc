// What hanging nodes mean for a contact surface: their parents, and control values without them.
#include <amontons/base/gather.h>
#include <amontons/contact/contact_surface.h>
#include <amontons/contact/face_basis.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>

#include <set>

namespace Amontons
{
  using DofLine = std::vector<std::pair<types::global_dof_index, double>>;

  // Hanging nodes with their parents; a parent that is on no face (the edge of a coarser cell that only
  // touches the surface) joins the nodes.
  template <int dim>
  void
  ContactSurface<dim>::find_parents(const Discretization<dim> &discretization)
  {
    const auto                                     &fe   = discretization.fe;
    const auto                                     &base = fe.base_element(0);
    const auto                                      comm = discretization.geometry.communicator;
    std::vector<types::global_dof_index>            dofs(fe.n_dofs_per_cell());
    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      node_of_dof[nodes[i].dofs[0]] = i;

    std::map<types::global_dof_index, DofLine> lines;
    for (const auto &[cell, f] : owned)
      {
        cell->get_dof_indices(dofs);
        for (const unsigned int i : nodes_on_face(base, f))
          if (const auto dof = dofs[fe.component_to_system_index(0, i)];
              discretization.hanging_nodes.is_constrained(dof))
            lines[dof] = *discretization.hanging_nodes.get_constraint_entries(dof);
      }
    std::set<types::global_dof_index> missing;
    for (const auto &part : gather_on_all(comm, lines))
      for (const auto &[dof, line] : part)
        {
          lines[dof] = line;
          for (const auto &entry : line)
            if (node_of_dof.count(entry.first) == 0)
              missing.insert(entry.first);
        }

    if (!missing.empty())
      join_nodes(discretization, std::move(missing), node_of_dof);
    faces_at.resize(nodes.size());
    for (const auto &[dof, line] : lines)
      for (const auto &[parent, weight] : line)
        nodes[node_of_dof.at(dof)].parents.emplace_back(node_of_dof.at(parent), weight);
  }

  // Nodes of these DoFs (of component 0) that are on no face; collective.
  template <int dim>
  void
  ContactSurface<dim>::join_nodes(const Discretization<dim>                       &discretization,
                                  std::set<types::global_dof_index>                missing,
                                  std::map<types::global_dof_index, unsigned int> &node_of_dof)
  {
    const auto                          &fe   = discretization.fe;
    const auto                          &base = fe.base_element(0);
    const auto                           comm = discretization.geometry.communicator;
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<std::pair<std::array<types::global_dof_index, dim>, Point<dim>>> found;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < base.n_dofs_per_cell(); ++i)
            if (missing.erase(dofs[fe.component_to_system_index(0, i)]) > 0)
              {
                found.emplace_back();
                for (unsigned int c = 0; c < dim; ++c)
                  found.back().first[c] = dofs[fe.component_to_system_index(c, i)];
                found.back().second =
                    discretization.mapping().transform_unit_to_real_cell(cell, base.unit_support_point(i));
              }
        }
    for (const auto &part : gather_on_all(comm, found))
      for (const auto &[node_dofs, X] : part)
        if (node_of_dof.emplace(node_dofs[0], nodes.size()).second)
          {
            nodes.emplace_back();
            nodes.back().X = nodes.back().x = X;
            nodes.back().dofs               = node_dofs;
          }
  }

  // With x = nodal values of a face, X those of its unknowns, x = H X (hanging nodes) and control values
  // c = T x, C = S X:  c = T H S^-1 C, where S holds the rows `control` of the unknowns.
  template <int dim>
  void
  ContactSurface<dim>::make_controls()
  {
    const auto expand = [&](const unsigned int node) {
      return nodes[node].parents.empty() ? std::vector<std::pair<unsigned int, double>>{{node, 1.}}
                                         : nodes[node].parents;
    };
    const auto         T = control_matrix(degree, dim - 1);
    const unsigned int n = T.size();
    for (const auto &face : faces)
      for (unsigned int k = 0; k < n; ++k)
        if (auto &node = nodes[face.nodes[k]]; node.parents.empty() && node.control.empty())
          {
            std::map<unsigned int, double> row;
            for (unsigned int l = 0; l < n; ++l)
              if (T[k][l] != 0)
                for (const auto &[parent, weight] : expand(face.nodes[l]))
                  row[parent] += T[k][l] * weight;
            for (const auto &[parent, weight] : row)
              if (std::abs(weight) > 1e-14)
                node.control.emplace_back(parent, weight);
          }
    for (auto &node : nodes) // on no face
      if (node.parents.empty() && node.control.empty())
        node.control.emplace_back(&node - nodes.data(), 1.);

    for (auto &face : faces)
      {
        face.unknowns = face.nodes;
        if (std::none_of(face.nodes.begin(), face.nodes.end(), [&](const unsigned int i) {
              return !nodes[i].parents.empty();
            }))
          continue;
        std::map<unsigned int, unsigned int> place; // nodes that do not hang first
        for (const unsigned int i : face.nodes)
          if (nodes[i].parents.empty())
            place.emplace(i, place.size());
        for (const unsigned int i : face.nodes)
          for (const auto &parent : nodes[i].parents)
            place.emplace(parent.first, place.size());
        AssertThrow(place.size() == n, ExcMessage("hanging nodes of a contact face have too many parents"));
        FullMatrix<double> TH(n, n), S(n, n);
        for (const auto &[i, column] : place)
          face.unknowns[column] = i;
        for (unsigned int k = 0; k < n; ++k)
          {
            for (unsigned int l = 0; l < n; ++l)
              for (const auto &[parent, weight] : expand(face.nodes[l]))
                TH(k, place.at(parent)) += T[k][l] * weight;
            for (const auto &[i, weight] : nodes[face.unknowns[k]].control)
              S(k, place.at(i)) += weight;
          }
        S.gauss_jordan();
        face.subdivision.reinit(n, n);
        TH.mmult(face.subdivision, S);
      }
  }

#define INSTANTIATE(dim)                                                                                     \
  template void ContactSurface<dim>::find_parents(const Discretization<dim> &);                              \
  template void ContactSurface<dim>::make_controls();
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Amontons

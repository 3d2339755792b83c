/// Where the degrees of freedom are.
#pragma once

#include <amontons/discretization/discretization.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  /// Calls action(cell, DoFs of the node by component, X) for every node of all cells that this rank knows;
  /// nodes that cells share come several times.
  template <int dim, typename Action>
  void
  for_each_node(const Discretization<dim> &discretization, const Action &action)
  {
    const auto                              &fe   = discretization.fe;
    const auto                              &base = fe.base_element(0);
    std::vector<types::global_dof_index>     dofs(fe.n_dofs_per_cell());
    std::array<types::global_dof_index, dim> node;
    FEValues<dim>                            values(discretization.mapping(),
                         fe,
                         Quadrature<dim>(base.get_unit_support_points()),
                         update_quadrature_points);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < base.n_dofs_per_cell(); ++i)
            {
              for (unsigned int c = 0; c < dim; ++c)
                node[c] = dofs[fe.component_to_system_index(c, i)];
              action(cell, node, values.quadrature_point(i));
            }
        }
  }

  constexpr unsigned int no_body = numbers::invalid_unsigned_int;

  template <int dim>
  struct DofPlace
  {
    unsigned int body = no_body, component;
    Point<dim>   X;
  };

  /// By relevant DoF; where the displacement (null: none) takes them. Those that no cell of this rank has are
  /// left without body.
  template <int dim>
  std::vector<DofPlace<dim>>
  places_of_dofs(const Discretization<dim> &discretization, const LA::Vector *displacement = nullptr);
} // namespace Amontons

#include <amontons/discretization/dof_places.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  template <int dim>
  std::vector<DofPlace<dim>>
  places_of_dofs(const Discretization<dim> &discretization, const LA::Vector *displacement)
  {
    const auto                          &relevant = discretization.relevant;
    const auto                          &fe       = discretization.fe;
    const auto                          &base     = fe.base_element(0);
    std::vector<DofPlace<dim>>           places(relevant.n_elements());
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    FEValues<dim>                        values(discretization.mapping,
                         fe,
                         Quadrature<dim>(base.get_unit_support_points()),
                         update_quadrature_points);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const auto [component, node] = fe.system_to_component_index(i);
              Point<dim> X                 = values.quadrature_point(node);
              for (unsigned int d = 0; displacement != nullptr && d < dim; ++d)
                X[d] += (*displacement)(dofs[fe.component_to_system_index(d, node)]);
              places[relevant.index_within_set(dofs[i])] = {cell->material_id(), component, X};
            }
        }
    return places;
  }

  template std::vector<DofPlace<2>>
  places_of_dofs(const Discretization<2> &, const LA::Vector *);
  template std::vector<DofPlace<3>>
  places_of_dofs(const Discretization<3> &, const LA::Vector *);
} // namespace Amontons

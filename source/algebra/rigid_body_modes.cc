#include <amontons/algebra/rigid_body_modes.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  template <int dim>
  std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<dim> &discretization)
  {
    const bool                       axisymmetric = discretization.scene.kind == ProblemType::axisymmetric;
    const unsigned int               n_modes      = axisymmetric ? 2 : dim * (dim + 1) / 2;
    const auto                      &owned        = discretization.locally_owned;
    std::vector<std::vector<double>> modes(n_modes, std::vector<double>(owned.n_elements(), 0.));

    const auto                          &fe   = discretization.fe;
    const auto                          &base = fe.base_element(0);
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
            if (owned.is_element(dofs[i]))
              {
                const auto [c, node]    = fe.system_to_component_index(i);
                const auto        index = owned.index_within_set(dofs[i]);
                const Point<dim> &X     = values.quadrature_point(node);
                modes[c][index]         = 1;
                unsigned int mode       = dim;
                for (unsigned int a = 0; a < dim && !axisymmetric; ++a)
                  for (unsigned int b = a + 1; b < dim; ++b, ++mode)
                    modes[mode][index] = c == a ? -X[b] : c == b ? X[a] : 0.;
              }
        }
    return modes;
  }

  template std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<2> &);
  template std::vector<std::vector<double>>
  rigid_body_modes(const Discretization<3> &);
} // namespace Amontons

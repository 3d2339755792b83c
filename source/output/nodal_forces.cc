#include <amontons/algebra/eliminated_system.h>
#include <amontons/output/nodal_forces.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim>
  std::vector<Place<dim>>
  locate_dofs(const Answer<dim> &answer)
  {
    const auto                          &discretization = answer.discretization;
    const bool                           moved          = answer.elasticity.finite_strain();
    const auto                          &fe             = discretization.fe;
    const auto                          &base           = fe.base_element(0);
    const IndexSet                      &owned          = discretization.locally_owned;
    std::vector<Place<dim>>              places(owned.n_elements());
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    FEValues<dim>                        values(discretization.mapping,
                         fe,
                         Quadrature<dim>(base.get_unit_support_points()),
                         update_quadrature_points);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && discretization.is_deformable(cell->material_id()))
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (owned.is_element(dofs[i]))
              {
                const auto [c, node] = fe.system_to_component_index(i);
                Point<dim> X         = values.quadrature_point(node);
                for (unsigned int d = 0; moved && d < dim; ++d)
                  X[d] += answer.state.displacement(dofs[fe.component_to_system_index(d, node)]);
                places[owned.index_within_set(dofs[i])] = {cell->material_id(), c, X};
              }
        }
    return places;
  }

  template <int dim>
  std::vector<double>
  support_forces(const Answer<dim> &answer, const std::vector<Place<dim>> &places)
  {
    const IndexSet &owned = answer.discretization.locally_owned;
    LA::Vector      raw   = answer.elasticity.internal_forces(answer.state.displacement);
    raw -= answer.loads;
    for (const auto &[dof, force] : contact_forces(answer))
      if (owned.is_element(dof))
        raw(dof) -= force;
    raw.compress(VectorOperation::add);
    const LA::Vector condensed =
        condense(raw, answer.discretization.hanging_nodes, answer.discretization.make_owned_vector());
    std::vector<double> forces(owned.n_elements());
    unsigned int        i = 0;
    for (const auto dof : owned)
      {
        if (places[i].body != no_body)
          forces[i] = condensed(dof);
        ++i;
      }
    return forces;
  }

  template <int dim>
  std::map<types::global_dof_index, double>
  contact_forces(const Answer<dim> &answer)
  {
    std::map<types::global_dof_index, double> forces;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      for (const auto &row : answer.interfaces[i].coupling.rows)
        {
          const auto &node = answer.state.contact[i][row.node];
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double lambda = node.pressure * row.normal[c] + node.shear[c];
              for (const auto &[dofs, weight] : row.slave)
                forces[dofs[c]] -= row.area * lambda * weight;
              for (const auto &[dofs, weight] : row.master)
                forces[dofs[c]] += row.area * lambda * weight;
            }
        }
    return forces;
  }

  template std::vector<Place<2>>
  locate_dofs(const Answer<2> &);
  template std::vector<double>
  support_forces(const Answer<2> &, const std::vector<Place<2>> &);
  template std::map<types::global_dof_index, double>
  contact_forces(const Answer<2> &);
  template std::vector<Place<3>>
  locate_dofs(const Answer<3> &);
  template std::vector<double>
  support_forces(const Answer<3> &, const std::vector<Place<3>> &);
  template std::map<types::global_dof_index, double>
  contact_forces(const Answer<3> &);
} // namespace Amontons

#include <amontons/algebra/eliminated_system.h>
#include <amontons/output/nodal_forces.h>

namespace Amontons
{
  template <int dim>
  std::vector<DofPlace<dim>>
  locate_dofs(const Answer<dim> &answer)
  {
    const auto                &discretization = answer.discretization;
    const auto                 all            = places_of_dofs(discretization,
                                    answer.elasticity.finite_strain() ? &answer.state.displacement : nullptr);
    std::vector<DofPlace<dim>> places;
    for (const auto dof : discretization.locally_owned)
      {
        const auto &place = all[discretization.relevant.index_within_set(dof)];
        places.push_back(discretization.is_deformable(place.body) ? place : DofPlace<dim>());
      }
    return places;
  }

  template <int dim>
  std::vector<double>
  support_forces(const Answer<dim> &answer, const std::vector<DofPlace<dim>> &places)
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

  template std::vector<DofPlace<2>>
  locate_dofs(const Answer<2> &);
  template std::vector<double>
  support_forces(const Answer<2> &, const std::vector<DofPlace<2>> &);
  template std::map<types::global_dof_index, double>
  contact_forces(const Answer<2> &);
  template std::vector<DofPlace<3>>
  locate_dofs(const Answer<3> &);
  template std::vector<double>
  support_forces(const Answer<3> &, const std::vector<DofPlace<3>> &);
  template std::map<types::global_dof_index, double>
  contact_forces(const Answer<3> &);
} // namespace Amontons

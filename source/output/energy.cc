#include <amontons/algebra/eliminated_system.h>
#include <amontons/base/points.h>
#include <amontons/output/energy.h>
#include <amontons/output/nodal_forces.h>

#include <utility>

namespace Amontons
{
  namespace
  {
    template <int dim>
    LA::Vector
    contact_force_vector(const Answer<dim> &answer)
    {
      LA::Vector result = answer.discretization.make_owned_vector();
      for (const auto &[dof, force] : contact_forces(answer))
        if (answer.discretization.locally_owned.is_element(dof))
          result(dof) += force;
      result.compress(VectorOperation::add);
      return result;
    }

    // What acts on the bodies from outside: loads and forces of the supports. The internal forces without
    // those of contact hold both, and on unconstrained DoFs what the iteration left unbalanced, which is no
    // work.
    template <int dim>
    LA::Vector
    external_forces(const Answer<dim> &answer, const LA::Vector &contact)
    {
      const IndexSet &owned  = answer.discretization.locally_owned;
      LA::Vector      forces = answer.elasticity.internal_forces(answer.state.displacement);
      forces -= contact;
      LA::Vector unbalanced = forces;
      unbalanced -= answer.loads;
      unbalanced = condense(unbalanced, answer.supports, answer.discretization.make_owned_vector());
      for (const auto dof : owned)
        if (!answer.supports.is_constrained(dof))
          forces(dof) -= unbalanced(dof);
      forces.compress(VectorOperation::add);
      return forces;
    }
  } // namespace

  template <int dim>
  void
  WorkDone<dim>::restart()
  {
    *this = WorkDone<dim>();
  }

  template <int dim>
  void
  WorkDone<dim>::rebase(const Answer<dim> &answer)
  {
    const double stored = stored_energy(answer);
    transferred_energy += stored - energy;
    energy   = stored;
    contact  = contact_force_vector(answer);
    external = external_forces(answer, contact);
    pressing = forces_on_growing_gaps(answer);
  }

  template <int dim>
  typename WorkDone<dim>::NodeForces
  WorkDone<dim>::forces_on_growing_gaps(const Answer<dim> &answer)
  {
    NodeForces forces;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      if (gap_grows(answer.interfaces[i]))
        for (const auto &row : answer.interfaces[i].coupling.rows)
          {
            if (const double p = answer.state.contact[i][row.node].pressure; p != 0)
              forces[{i, row.node}] = row.area * p * row.normal.norm_square();
          }
    return forces;
  }

  template <int dim>
  void
  WorkDone<dim>::add(const Answer<dim> &answer)
  {
    const SolutionState<dim> &state       = answer.state;
    const bool                started     = state.committed.size() == state.displacement.size();
    const LA::Vector          contact_now = contact_force_vector(answer),
                     external_now         = external_forces(answer, contact_now);
    const bool known                      = external.size() == external_now.size();
    double     work = 0, by_contact = 0;
    for (const auto dof : answer.discretization.locally_owned)
      {
        const double change = state.displacement(dof) - (started ? state.committed(dof) : 0.);
        work += 0.5 * (external_now(dof) + (known ? external(dof) : 0.)) * change;
        by_contact -= 0.5 * (contact_now(dof) + (known ? contact(dof) : 0.)) * change;
      }
    work       = Utilities::MPI::sum(work, answer.discretization.geometry.communicator);
    by_contact = Utilities::MPI::sum(by_contact, answer.discretization.geometry.communicator);
    external   = external_now;
    contact    = contact_now;

    // The gap of a node is a control value, c = sum weight g(X) (see SurfaceNode).
    const auto grown_by = [&](const unsigned int i, const unsigned int node) {
      const auto &slave  = *answer.interfaces[i].slave;
      const auto &gap    = *answer.interfaces[i].pair->initial_gap;
      double      change = 0;
      for (const auto &[k, weight] : slave.nodes[node].control)
        change += weight * (gap.value(as_3d(slave.nodes[k].X), state.t) -
                            gap.value(as_3d(slave.nodes[k].X), state.committed_t));
      return change;
    };
    double     growth       = 0;
    const auto pressing_now = forces_on_growing_gaps(answer);
    for (const auto *forces : {&std::as_const(pressing), &pressing_now})
      for (const auto &[place, force] : *forces)
        growth -= 0.5 * force * grown_by(place.first, place.second);
    pressing = pressing_now;

    double friction = 0;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      for (const auto &row : answer.interfaces[i].coupling.rows)
        {
          const auto &node = state.contact[i][row.node];
          friction += row.area * (node.shear * node.slip);
        }
    const double stored = stored_energy(answer);
    external_work += work + growth;
    contact_work += by_contact + growth;
    dissipation += friction;
    smallest_dissipation = std::min(smallest_dissipation, friction);
    largest_work         = std::max({largest_work, std::abs(external_work), stored});
    // Of bodies that move without load all of this is rounding.
    const double rounding = 1e-14 * answer.elasticity.rounding_scale(state.displacement) *
                            state.displacement.linfty_norm() *
                            std::sqrt(answer.discretization.dof_handler.n_dofs());
    if (largest_work > rounding)
      energy_error = std::max(energy_error, std::abs(work - (stored - energy) - by_contact) / largest_work);
    energy = stored;
  }

  template class WorkDone<2>;
  template class WorkDone<3>;
} // namespace Amontons

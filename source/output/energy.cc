#include <amontons/algebra/condensed_system.h>
#include <amontons/output/energy.h>

namespace Amontons
{
  namespace
  {
    // What acts on the bodies from outside: loads and forces of the supports. The residual K u - contact
    // forces holds both, and on unconstrained DoFs what the iteration left unbalanced, which is no work.
    template <int dim>
    LA::Vector
    external_forces(const Answer<dim> &answer)
    {
      const IndexSet &owned  = answer.discretization.locally_owned;
      LA::Vector      forces = answer.elasticity.internal_forces(answer.state.displacement);
      for (const auto &[dof, force] : contact_forces(answer))
        if (owned.is_element(dof))
          forces(dof) -= force;
      forces.compress(VectorOperation::add);
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
    external = external_forces(answer);
    remember_tractions(answer);
  }

  template <int dim>
  void
  WorkDone<dim>::remember_tractions(const Answer<dim> &answer)
  {
    tractions.assign(answer.interfaces.size(), {});
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      {
        const auto &rows = answer.interfaces[i].coupling.rows;
        tractions[i].resize(answer.interfaces[i].slave->nodes.size());
        for (unsigned int r = 0; r < rows.size(); ++r)
          tractions[i][rows[r].node] = {answer.state.pressures[i][r], answer.state.shears[i][r]};
      }
  }

  template <int dim>
  void
  WorkDone<dim>::add(const Answer<dim> &answer)
  {
    const SolutionState &state   = answer.state;
    const bool           started = state.committed.size() == state.displacement.size();
    const LA::Vector     now     = external_forces(answer);
    const bool           known   = external.size() == now.size();
    double               work    = 0;
    for (const auto dof : answer.discretization.locally_owned)
      work += 0.5 * (now(dof) + (known ? external(dof) : 0.)) *
              (state.displacement(dof) - (started ? state.committed(dof) : 0.));
    work     = Utilities::MPI::sum(work, answer.discretization.geometry.communicator);
    external = now;

    double contact = 0, friction = 0;
    if (tractions.empty())
      tractions.resize(answer.interfaces.size());
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      {
        const auto &rows = answer.interfaces[i].coupling.rows;
        tractions[i].resize(answer.interfaces[i].slave->nodes.size());
        for (unsigned int r = 0; r < rows.size(); ++r)
          {
            const auto &[old_pressure, old_shear] = tractions[i][rows[r].node];
            const double p                        = state.pressures[i][r];
            const auto  &q                        = state.shears[i][r];
            const auto   change = started ? jump(rows[r], state.displacement) - jump(rows[r], state.committed)
                                          : jump(rows[r], state.displacement);
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double mean = 0.5 * ((p + old_pressure) * rows[r].normal[d] + q[d] + old_shear[d]);
                contact += rows[r].area * mean * change[d];
              }
            friction += rows[r].area * (q * state.slips[i][r]);
          }
      }
    remember_tractions(answer);
    const double stored = stored_energy(answer);
    external_work += work;
    contact_work += contact;
    dissipation += friction;
    smallest_dissipation = std::min(smallest_dissipation, friction);
    largest_work         = std::max({largest_work, std::abs(external_work), stored});
    if (largest_work > 0)
      energy_error = std::max(energy_error, std::abs(work - (stored - energy) - contact) / largest_work);
    energy = stored;
  }

  template class WorkDone<2>;
  template class WorkDone<3>;
} // namespace Amontons

#include <amontons/algebra/eliminated_system.h>
#include <amontons/base/points.h>
#include <amontons/friction/shear_law.h>
#include <amontons/output/energy.h>
#include <amontons/output/nodal_forces.h>

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

    template <int dim>
    double
    bound_at(const ContactInterface<dim> &interface,
             const unsigned int           node,
             const double                 t,
             const double                 pressure)
    {
      return shear_bound(*interface.pair, as_3d(interface.slave->nodes[node].X), t, pressure).value;
    }

    // Something acts from t = 0 on, so that the first increment does not begin without pressures.
    bool
    is_loaded_at_rest(const Scene &scene)
    {
      return scene.is_loaded_at_start ||
             std::any_of(scene.conditions.begin(),
                         scene.conditions.end(),
                         [](const auto &condition) { return condition.field.has_value(); }) ||
             std::any_of(scene.pairs.begin(), scene.pairs.end(), [](const auto &pair) {
               return pair.initial_gap && pair.initial_gap->value(Point<3>(), 0) != 0;
             });
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
    friction = friction_of(answer);
    start    = Half();
  }

  template <int dim>
  typename WorkDone<dim>::NodeValues
  WorkDone<dim>::forces_on_growing_gaps(const Answer<dim> &answer)
  {
    NodeValues forces;
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
  typename WorkDone<dim>::Half
  WorkDone<dim>::half_of(const Answer<dim> &answer,
                         const LA::Vector  &external,
                         const LA::Vector  &contact,
                         const NodeValues  &pressing)
  {
    const SolutionState<dim> &state   = answer.state;
    const bool                started = state.committed.size() == state.displacement.size();
    Half                      half;
    for (const auto dof : answer.discretization.locally_owned)
      {
        const double change = state.displacement(dof) - (started ? state.committed(dof) : 0.);
        half.external += 0.5 * external(dof) * change;
        half.contact -= 0.5 * contact(dof) * change;
      }
    const MPI_Comm communicator = answer.discretization.geometry.communicator;
    half.external               = Utilities::MPI::sum(half.external, communicator);
    half.contact                = Utilities::MPI::sum(half.contact, communicator);

    // The gap of a node is a control value, c = sum weight g(X) (see SurfaceNode).
    for (const auto &[place, force] : pressing)
      {
        const auto &slave = *answer.interfaces[place.first].slave;
        const auto &gap   = *answer.interfaces[place.first].pair->initial_gap;
        for (const auto &[k, weight] : slave.nodes[place.second].control)
          {
            const auto X = as_3d(slave.nodes[k].X);
            half.growth -= 0.5 * force * weight * (gap.value(X, state.t) - gap.value(X, state.committed_t));
          }
      }
    return half;
  }

  template <int dim>
  void
  WorkDone<dim>::leave_mesh(const Answer<dim> &answer)
  {
    if (external.size() != answer.discretization.dof_handler.n_dofs())
      return; // at rest, or it was left in this increment before
    start = half_of(answer, external, contact, pressing);
    external.clear();
    contact.clear();
    pressing.clear();
  }

  template <int dim>
  typename WorkDone<dim>::template ByNode<typename WorkDone<dim>::Friction>
  WorkDone<dim>::friction_of(const Answer<dim> &answer)
  {
    ByNode<Friction> result;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      if (const auto &interface = answer.interfaces[i]; interface.pair->has_friction())
        for (const auto &row : interface.coupling.rows)
          {
            const auto &node      = answer.state.contact[i][row.node];
            result[{i, row.node}] = {bound_at(interface, row.node, answer.state.t, node.pressure),
                                     row.area * node.shear};
          }
    return result;
  }

  namespace
  {
    // The bound at the start of the increment may jump there: its limit from the right; `before`, if the
    // pressure there is not known. A node that stuck below it slips once it has fallen to the shear.
    template <int dim>
    double
    bound_where_slip_starts(const Answer<dim> &answer,
                            const unsigned int pair,
                            const unsigned int node,
                            const double       before,
                            const double       at_end)
    {
      const SolutionState<dim> &state = answer.state;
      if (state.committed_contact.empty())
        return before;
      const auto  &known = state.committed_contact[pair][node];
      const double t     = state.committed_t + 1e-9 * (state.t - state.committed_t),
                   start = bound_at(answer.interfaces[pair], node, t, known.pressure);
      return start > at_end ? std::clamp(known.shear.norm(), at_end, start) : start;
    }
  } // namespace

  // doc/introduction.md, (26): a node slips against its bound phi, which changes on the way. (The
  // traction itself has another direction at the start, where the node stuck.) Of one that has opened the
  // bound falls to 0.
  template <int dim>
  double
  WorkDone<dim>::work_of_friction(const Answer<dim> &answer, const ByNode<Friction> &now) const
  {
    const bool bears =
        friction.empty() && answer.state.t > 0 && is_loaded_at_rest(answer.discretization.scene);
    double work = 0;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      if (const auto &interface = answer.interfaces[i]; interface.pair->has_friction())
        for (const auto &row : interface.coupling.rows)
          {
            const auto  &node  = answer.state.contact[i][row.node];
            const double bound = now.at({i, row.node}).bound;
            const auto   known = friction.find({i, row.node});
            if (bound <= 0)
              {
                if (known != friction.end())
                  work += std::max(0., known->second.force * node.slip / 2);
                continue;
              }
            const double start =
                known != friction.end()
                    ? bound_where_slip_starts(answer, i, row.node, known->second.bound, bound)
                : bears ? bound
                        : bound_at(interface, row.node, answer.state.t, 0);
            work += row.area * (start + bound) / (2 * bound) * (node.shear * node.slip);
          }
    return work;
  }

  template <int dim>
  void
  WorkDone<dim>::add(const Answer<dim> &answer)
  {
    const SolutionState<dim> &state       = answer.state;
    const LA::Vector          contact_now = contact_force_vector(answer),
                     external_now         = external_forces(answer, contact_now);
    const auto pressing_now               = forces_on_growing_gaps(answer);
    const Half begin  = external.size() == external_now.size() ? half_of(answer, external, contact, pressing)
                                                               : start,
               end    = half_of(answer, external_now, contact_now, pressing_now);
    const double work = begin.external + end.external, by_contact = begin.contact + end.contact,
                 growth = begin.growth + end.growth;
    external            = external_now;
    contact             = contact_now;
    pressing            = pressing_now;
    start               = Half();

    const auto   friction_now = friction_of(answer);
    const double dissipated   = work_of_friction(answer, friction_now);
    friction                  = friction_now;
    const double stored       = stored_energy(answer);
    external_work += work + growth;
    contact_work += by_contact + growth;
    dissipation += dissipated;
    smallest_dissipation = std::min(smallest_dissipation, dissipated);
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

#include <amontons/elasticity/finite_mechanics.h>
#include <amontons/finite_strain_model.h>

namespace Amontons
{
  template <int dim>
  FiniteStrainModel<dim>::FiniteStrainModel(const std::shared_ptr<BodyMesh<dim>> &mesh,
                                            const double                          t,
                                            TimerOutput                          &timer)
      : Model<dim>(mesh, true, t, timer)
  {
    this->couple_at_rest();
  }

  template <int dim>
  FiniteStrainModel<dim>::FiniteStrainModel(const Model<dim>         &other,
                                            const SolutionState<dim> &state,
                                            TimerOutput              &timer)
      : Model<dim>(other.mesh, true, state.t, timer)
  {
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      interfaces[i].search_distance = other.interfaces[i].search_distance;
    move_to(state);
  }

  template <int dim>
  std::unique_ptr<Model<dim>>
  FiniteStrainModel<dim>::at_rest(const double t) const
  {
    return std::make_unique<FiniteStrainModel<dim>>(this->mesh, t, timer);
  }

  template <int dim>
  void
  FiniteStrainModel<dim>::move_to(const SolutionState<dim> &state)
  {
    TimerOutput::Scope scope(timer, "contact surfaces");
    for (unsigned int i = 0; i < state.contact.size(); ++i)
      if (state.contact[i].size() == interfaces[i].slave->nodes.size())
        {
          interfaces[i].carried.clear();
          for (const auto &node : state.contact[i])
            interfaces[i].carried.push_back(node.has_multiplier);
        }
    couple_moved(discretization(), this->supports, state.displacement, state.t, interfaces);
  }

  template <int dim>
  void
  FiniteStrainModel<dim>::update_loads(const SolutionState<dim> &state)
  {
    this->loads = assemble_loads(discretization(), state.t, this->covered_points(), &state.displacement);
  }

  template <int dim>
  std::unique_ptr<Mechanics<dim>>
  FiniteStrainModel<dim>::mechanics(const SolutionState<dim> &)
  {
    return std::make_unique<FiniteMechanics<dim>>(
        discretization(), this->elasticity, this->time(), [this]() { return this->covered_points(); });
  }

  template <int dim>
  double
  FiniteStrainModel<dim>::gap_to_cover(const ContactInterface<dim> &, const OverlapPoint<dim> &point) const
  {
    return point.gap;
  }

  template class FiniteStrainModel<2>;
  template class FiniteStrainModel<3>;
} // namespace Amontons

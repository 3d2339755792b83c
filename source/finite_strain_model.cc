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
    couple_at_rest();
  }

  template <int dim>
  FiniteStrainModel<dim>::FiniteStrainModel(const Model<dim>         &other,
                                            const SolutionState<dim> &state,
                                            TimerOutput              &timer)
      : Model<dim>(other.mesh, true, state.t, timer)
  {
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (const PairData &pair = *interfaces[i].pair;
          other.finite_strain() || (!pair.initial_gap && pair.adjust == 0))
        interfaces[i].first_gap = other.interfaces[i].first_gap;
    couple_refined();
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
  void
  FiniteStrainModel<dim>::couple_at_rest()
  {
    Model<dim>::couple_at_rest();
    lying.assign(interfaces.size(), {});
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        std::array<std::set<unsigned int>, 2> apart;
        for (const auto &p : interfaces[i].coupling.points)
          {
            const bool lies = std::abs(p.gap) <= 1e-6 * interfaces[i].slave->faces[p.slave_face].size;
            auto      &of   = lies ? lying[i] : apart;
            of[0].insert(p.slave_face);
            of[1].insert(p.master_face);
          }
        for (const unsigned int side : {0, 1})
          for (const unsigned int face : apart[side])
            lying[i][side].erase(face);
      }
  }

  // move_to() follows. What pressures do not act on shows at rest.
  template <int dim>
  void
  FiniteStrainModel<dim>::couple_refined()
  {
    const auto &conditions = discretization().scene.conditions;
    if (std::any_of(conditions.begin(), conditions.end(), [](const ConditionData &condition) {
          return condition.type == ConditionData::Type::pressure;
        }))
      {
        couple_at_rest();
        return;
      }
    if (std::any_of(interfaces.begin(), interfaces.end(), [](const auto &i) { return !i.first_gap; }))
      {
        Model<dim>::couple_at_rest();
        for (auto &interface : interfaces)
          interface.search_distance = 0; // chosen where the surfaces are
      }
    lying.assign(interfaces.size(), {});
  }

  // Bodies that lay on each other slide along each other: one of the two faces still is one that did. Its gap
  // is not zero between the nodes where surfaces have bent.
  template <int dim>
  bool
  FiniteStrainModel<dim>::is_covered(const unsigned int interface, const OverlapPoint<dim> &point) const
  {
    return std::abs(point.gap) <= 0.05 * interfaces[interface].slave->faces[point.slave_face].size &&
           (lying[interface][0].count(point.slave_face) > 0 ||
            lying[interface][1].count(point.master_face) > 0);
  }

  template class FiniteStrainModel<2>;
  template class FiniteStrainModel<3>;
} // namespace Amontons

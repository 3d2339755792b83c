#include <amontons/base/points.h>
#include <amontons/elasticity/linear_mechanics.h>
#include <amontons/small_strain_model.h>

namespace Amontons
{
  template <int dim>
  SmallStrainModel<dim>::SmallStrainModel(const std::shared_ptr<BodyMesh<dim>> &mesh,
                                          const double                          t,
                                          TimerOutput                          &timer,
                                          const std::vector<double>            &known)
      : Model<dim>(mesh, false, t, timer), search_distances(known)
  {
    search_distances.resize(interfaces.size(), 0.);
    couple_at_rest();
  }

  template <int dim>
  std::unique_ptr<Model<dim>>
  SmallStrainModel<dim>::at_rest(const double t) const
  {
    auto result         = std::make_unique<SmallStrainModel<dim>>(this->mesh, t, timer, search_distances);
    result->kept_system = this->kept_system;
    return result;
  }

  template <int dim>
  void
  SmallStrainModel<dim>::couple_at_rest()
  {
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      interfaces[i].search_distance = search_distances[i];
    Model<dim>::couple_at_rest();
  }

  template <int dim>
  void
  SmallStrainModel<dim>::set_time(const double t)
  {
    if (t == this->time())
      return;
    Model<dim>::set_time(t);
    redeclare_gaps(discretization(), t, interfaces);
  }

  template <int dim>
  void
  SmallStrainModel<dim>::update_loads(const SolutionState<dim> &state)
  {
    this->loads = assemble_loads(discretization(), state.t, this->covered_points());
  }

  template <int dim>
  std::unique_ptr<Mechanics<dim>>
  SmallStrainModel<dim>::mechanics(const SolutionState<dim> &state)
  {
    TimerOutput::Scope scope(timer, "assemble stiffness");
    if (this->elasticity.is_cleared())
      this->elasticity.assemble(state.displacement);
    update_loads(state);
    return std::make_unique<LinearMechanics<dim>>(this->elasticity, this->loads);
  }

  template <int dim>
  bool
  SmallStrainModel<dim>::is_covered(const unsigned int interface, const OverlapPoint<dim> &point) const
  {
    const auto  &here = interfaces[interface];
    const double gap  = gap_grows(here) ? here.pair->initial_gap->value(as_3d(point.x_slave), 0) : point.gap;
    return std::abs(gap) <= 1e-6 * here.slave->faces[point.slave_face].size; // before any load
  }

  template <int dim>
  bool
  SmallStrainModel<dim>::widen_search(const SolutionState<dim> &state)
  {
    const bool may_shrink = !discretization().scene.has_friction(); // else the path may need them again
    bool       too_short  = false;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (interfaces[i].pair->tied || interfaces[i].pair->initial_gap)
          continue; // a declared gap says nothing about the distance of the meshes
        double needed     = interfaces[i].pair->adjust; // gaps of this size count as zero
        bool   any_closed = false;
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto &node   = state.contact[i][row.node];
            const bool  closed = node.state != ContactStatus::open;
            any_closed         = any_closed || closed;
            needed             = std::max(needed, closed ? std::abs(row.gap) : row.gap - node.gap);
          }
        if (!any_closed)
          continue;
        const bool short_here = needed > 0.75 * interfaces[i].search_distance; // what is in use
        if (short_here || search_distances[i] == 0 || (may_shrink && 4 * needed < search_distances[i]))
          search_distances[i] = 2 * needed + 1e-3 * interfaces[i].slave->mean_size;
        too_short = too_short || short_here;
      }
    if (!too_short)
      return false;
    for (unsigned int i = 0; i < interfaces.size(); ++i) // nothing shrinks on a mesh that has an answer
      search_distances[i] = std::max(search_distances[i], interfaces[i].search_distance);
    TimerOutput::Scope scope(timer, "contact surfaces");
    couple_at_rest();
    return true;
  }

  template class SmallStrainModel<2>;
  template class SmallStrainModel<3>;
} // namespace Amontons

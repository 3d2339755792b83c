/// Bodies that deform, with surfaces that meet and slide where this takes them, and pressures that follow.
#pragma once

#include <amontons/model.h>

namespace Amontons
{
  template <int dim>
  class FiniteStrainModel : public Model<dim>
  {
  public:
    using Model<dim>::discretization;
    using Model<dim>::interfaces;

    FiniteStrainModel(const std::shared_ptr<BodyMesh<dim>> &mesh, const double t, TimerOutput &timer);

    /// On the mesh of another model, which is of use again after its resume(): coupled where the state is.
    FiniteStrainModel(const Model<dim> &other, const SolutionState<dim> &state, TimerOutput &timer);

    std::unique_ptr<Model<dim>>
    at_rest(const double t) const override;

    void
    move_to(const SolutionState<dim> &state) override;
    void
    update_loads(const SolutionState<dim> &state) override;
    std::unique_ptr<Mechanics<dim>>
    mechanics(const SolutionState<dim> &state) override;
    /// Surfaces are searched wherever they are.
    bool
    widen_search(const SolutionState<dim> &) override
    {
      return false;
    }

  private:
    using Model<dim>::timer;

    void
    couple_at_rest() override;
    void
    couple_refined() override;
    bool
    is_covered(const unsigned int interface, const OverlapPoint<dim> &point) const override;

    // The slave's and the master's faces that lie on the other body at rest, with all that faces it. By
    // interface; after a refinement only where there are pressures.
    std::vector<std::array<std::set<unsigned int>, 2>> lying;
  };
} // namespace Amontons

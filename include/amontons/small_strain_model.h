/// Bodies that hardly deform, and surfaces that stay where they are.
#pragma once

#include <amontons/model.h>

namespace Amontons
{
  template <int dim>
  class SmallStrainModel : public Model<dim>
  {
  public:
    using Model<dim>::discretization;
    using Model<dim>::interfaces;

    /// reaches: see widen_search(); empty: not known yet.
    SmallStrainModel(const std::shared_ptr<BodyMesh<dim>> &mesh,
                     const double                          t,
                     TimerOutput                          &timer,
                     const std::vector<double>            &search_distances = {});

    std::unique_ptr<Model<dim>>
    at_rest(const double t) const override;

    void
    set_time(const double t) override;
    void
    move_to(const SolutionState<dim> &) override
    {
    }
    void
    update_loads(const SolutionState<dim> &state) override;
    /// All of it assembled, with the loads.
    std::unique_ptr<Mechanics<dim>>
    mechanics(const SolutionState<dim> &state) override;

    /// Gaps that are far larger than what displacements close never matter. Of those of the nodes that are
    /// closed and of what displacements closed elsewhere, the next couplings take twice the largest into
    /// account; if that was not enough here, the surfaces are coupled again with more (returns true).
    bool
    widen_search(const SolutionState<dim> &state) override;

  private:
    using Model<dim>::timer;

    void
    couple_at_rest() override;
    void
    couple_refined() override
    {
      couple_at_rest();
    }
    bool
    is_covered(const unsigned int interface, const OverlapPoint<dim> &point) const override;

    std::vector<double> search_distances; // by pair, of the next coupling; 0: not known yet
  };
} // namespace Amontons

/// The bodies at finite strain, with the loads that follow them.
#pragma once

#include <amontons/elasticity/loads.h>
#include <amontons/elasticity/mechanics.h>

namespace Amontons
{
  template <int dim>
  class FiniteMechanics : public Mechanics<dim>
  {
  public:
    using typename Mechanics<dim>::Dilatations;

    /// covered: points where other bodies lie, on which pressure does not act; asked whenever loads are.
    FiniteMechanics(const Discretization<dim>                             &discretization,
                    ElasticityOperator<dim>                               &elasticity,
                    const double                                           t,
                    const std::function<std::vector<CoveredPoint<dim>>()> &covered);

    bool
    is_linear() const override
    {
      return false;
    }

    std::optional<InvertedCell<dim>>
    evaluate(const LA::Vector          &u,
             const std::vector<double> &dilatations    = {},
             const bool                 with_stiffness = true) override;

    void
    complete(const LA::Vector &u) override;

    /// The first time on a mesh with a displacement from another one: with dilatations that make no large
    /// pressures (ElasticityOperator::dilatations_after_refinement).
    std::optional<InvertedCell<dim>>
    start(const LA::Vector &u) override;

    LA::Vector
    loads_at(const LA::Vector &u) const;
    const LA::Vector *
    forces_of_excess() const override
    {
      return &elasticity.forces_of_excess();
    }
    std::vector<LocalMatrix>
    stiffness_of_loads(const LA::Vector &u) const override;
    Dilatations
    change_of_dilatations(const LA::Vector &step) const override;

  private:
    using Mechanics<dim>::elasticity;
    using Mechanics<dim>::external;
    using Mechanics<dim>::difference;

    const Discretization<dim>                            &discretization;
    const double                                          t;
    const std::function<std::vector<CoveredPoint<dim>>()> covered;
    bool                                                  has_stiffness = false;
  };
} // namespace Amontons

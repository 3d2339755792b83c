/// The bodies at small strain.
#pragma once

#include <amontons/elasticity/mechanics.h>

namespace Amontons
{
  template <int dim>
  class LinearMechanics : public Mechanics<dim>
  {
  public:
    /// elasticity: assembled.
    LinearMechanics(ElasticityOperator<dim> &elasticity, const LA::Vector &loads) : Mechanics<dim>(elasticity)
    {
      this->external = loads;
    }

    bool
    is_linear() const override
    {
      return true;
    }

    std::optional<InvertedCell<dim>>
    start(const LA::Vector &u) override
    {
      return evaluate(u);
    }

    /// K u - loads
    std::optional<InvertedCell<dim>>
    evaluate(const LA::Vector &u, const std::vector<double> & = {}, const bool = true) override
    {
      this->difference = this->elasticity.internal_forces(u);
      this->difference -= this->external;
      return {};
    }
  };
} // namespace Amontons

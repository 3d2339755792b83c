/// The bodies and their loads, as an iteration sees them.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>

namespace Amontons
{
  /// Internal forces, loads and their derivatives where the last evaluate() was. Forces are owned vectors
  /// over all DoFs, as if constrained ones were free.
  template <int dim>
  class Mechanics
  {
  public:
    explicit Mechanics(ElasticityOperator<dim> &elasticity) : elasticity(elasticity) {}
    virtual ~Mechanics() = default;

    /// Small strain: tangent and loads are the same everywhere.
    virtual bool
    is_linear() const = 0;

    /// The first time on a mesh; else as evaluate().
    virtual std::optional<InvertedCell<dim>>
    start(const LA::Vector &u) = 0;

    /// At u (readable at relevant DoFs), with the dilatations of the cells (empty: those of u). An inverted
    /// cell: none of it is there. Collective.
    virtual std::optional<InvertedCell<dim>>
    evaluate(const LA::Vector          &u,
             const std::vector<double> &dilatations    = {},
             const bool                 with_stiffness = true) = 0;

    /// The stiffness, too, if the last evaluate() left it out.
    virtual void
    complete(const LA::Vector &)
    {
    }

    const ElasticityOperator<dim> &
    bodies() const
    {
      return elasticity;
    }
    const LA::Vector &
    loads() const
    {
      return external;
    }
    /// Internal forces - loads.
    const LA::Vector &
    unbalanced() const
    {
      return difference;
    }
    /// What the excess of the dilatations adds to the internal forces in the next step; null: nothing.
    virtual const LA::Vector *
    forces_of_excess() const
    {
      return nullptr;
    }
    /// - d loads/du
    virtual std::vector<LocalMatrix>
    stiffness_of_loads(const LA::Vector &) const
    {
      return {};
    }

    /// What residuals are measured by: the larger one of internal forces and loads, at least what rounding
    /// leaves of |K||u| over the tolerance (scenes without stress, stiff bodies on soft ones).
    double
    force_scale(const LA::Vector &u, const double tolerance) const
    {
      LA::Vector internal(difference);
      internal += external;
      return std::max(
          {internal.l2_norm(), external.l2_norm(), 1e-14 * elasticity.rounding_scale(u) / tolerance});
    }

    /// Those of the cells now, and how Newton's step (readable at relevant DoFs) changes them: linearly.
    struct Dilatations
    {
      std::vector<double> now, change;

      std::vector<double>
      after(const double part) const
      {
        auto result = now;
        for (unsigned int k = 0; k < result.size(); ++k)
          result[k] += part * change[k];
        return result;
      }
    };
    virtual Dilatations
    change_of_dilatations(const LA::Vector &) const
    {
      return {};
    }

  protected:
    ElasticityOperator<dim> &elasticity;
    LA::Vector               external, difference;
  };
} // namespace Amontons

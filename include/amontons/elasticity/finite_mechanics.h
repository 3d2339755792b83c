/// The bodies at finite strain, with the loads that follow them.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/elasticity/loads.h>

namespace Amontons
{
  /// Internal forces, loads and their derivatives where the last evaluate() was.
  template <int dim>
  class FiniteMechanics
  {
  public:
    /// covered: points where other bodies lie, on which pressure does not act; asked whenever loads are.
    FiniteMechanics(const Discretization<dim>                             &discretization,
                    ElasticityOperator<dim>                               &elasticity,
                    const double                                           t,
                    const std::function<std::vector<CoveredPoint<dim>>()> &covered);

    /// At u (readable at relevant DoFs), with the dilatations of the cells (empty: those of u). An inverted
    /// cell: none of it is there. Collective.
    std::optional<InvertedCell<dim>>
    evaluate(const LA::Vector          &u,
             const std::vector<double> &dilatations    = {},
             const bool                 with_stiffness = true);

    /// The stiffness, too, if the last evaluate() left it out.
    void
    complete(const LA::Vector &u);

    /// The first time on a mesh with a displacement from another one: with dilatations that make no large
    /// pressures (ElasticityOperator::dilatations_after_refinement).
    std::optional<InvertedCell<dim>>
    start(const LA::Vector &u);

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
    LA::Vector
    loads_at(const LA::Vector &u) const;
    /// Internal forces - loads.
    const LA::Vector &
    unbalanced() const
    {
      return difference;
    }
    /// - d loads/du
    std::vector<LocalMatrix>
    stiffness_of_loads(const LA::Vector &u) const;

    /// What residuals are measured by: the larger one of internal forces and loads, at least what rounding
    /// leaves of |K||u| over the tolerance.
    double
    force_scale(const LA::Vector &u, const double tolerance) const;

    /// Those of the cells now, and how Newton's step (readable at relevant DoFs) changes them: linearly.
    struct Dilatations
    {
      std::vector<double> now, change;

      std::vector<double>
      after(const double part) const;
    };
    Dilatations
    change_of_dilatations(const LA::Vector &step) const;

  private:
    const Discretization<dim>                            &discretization;
    ElasticityOperator<dim>                              &elasticity;
    const double                                          t;
    const std::function<std::vector<CoveredPoint<dim>>()> covered;
    LA::Vector                                            external, difference;
    bool                                                  has_stiffness = false;
  };
} // namespace Amontons

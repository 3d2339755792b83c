#include <amontons/elasticity/finite_mechanics.h>

namespace Amontons
{
  template <int dim>
  FiniteMechanics<dim>::FiniteMechanics(const Discretization<dim>                             &discretization,
                                        ElasticityOperator<dim>                               &elasticity,
                                        const double                                           t,
                                        const std::function<std::vector<CoveredPoint<dim>>()> &covered)
      : Mechanics<dim>(elasticity), discretization(discretization), t(t), covered(covered)
  {
  }

  template <int dim>
  std::optional<InvertedCell<dim>>
  FiniteMechanics<dim>::evaluate(const LA::Vector          &u,
                                 const std::vector<double> &dilatations,
                                 const bool                 with_stiffness)
  {
    has_stiffness = with_stiffness;
    if (const auto inverted =
            with_stiffness ? elasticity.assemble(u, dilatations) : elasticity.update_forces(u, dilatations))
      return inverted;
    external   = loads_at(u);
    difference = elasticity.forces();
    difference -= external;
    return {};
  }

  template <int dim>
  void
  FiniteMechanics<dim>::complete(const LA::Vector &u)
  {
    if (!has_stiffness)
      evaluate(u, std::vector<double>(elasticity.dilatations()));
  }

  template <int dim>
  std::optional<InvertedCell<dim>>
  FiniteMechanics<dim>::start(const LA::Vector &u)
  {
    const bool is_new_mesh = elasticity.is_cleared();
    if (const auto inverted = evaluate(u))
      return inverted;
    const auto dilatations = elasticity.dilatations_after_refinement();
    return is_new_mesh && dilatations ? evaluate(u, *dilatations) : std::nullopt;
  }

  template <int dim>
  LA::Vector
  FiniteMechanics<dim>::loads_at(const LA::Vector &u) const
  {
    return assemble_loads(discretization, t, covered(), &u);
  }

  template <int dim>
  std::vector<LocalMatrix>
  FiniteMechanics<dim>::stiffness_of_loads(const LA::Vector &u) const
  {
    auto matrices = pressure_stiffness(discretization, t, u);
    for (auto &part : matrices)
      part.matrix *= -1;
    return matrices;
  }

  template <int dim>
  typename FiniteMechanics<dim>::Dilatations
  FiniteMechanics<dim>::change_of_dilatations(const LA::Vector &step) const
  {
    return {elasticity.dilatations(), elasticity.change_of_dilatations(step)};
  }

  template class FiniteMechanics<2>;
  template class FiniteMechanics<3>;
} // namespace Amontons

#include <amontons/solver/rigid_mode_stabilisation.h>

namespace Amontons
{
  template <int dim>
  RigidModeStabilisation
  stabilise_rigid_modes(const Discretization<dim>     &discretization,
                        const ElasticityOperator<dim> &elasticity,
                        const FloatingBodies<dim>     &floating)
  {
    RigidModeStabilisation terms;
    if (!floating.any())
      return terms;
    const double weak    = 1e-8;
    double       largest = 0;
    terms.springs        = discretization.make_owned_vector();
    terms.pins           = discretization.make_owned_vector();
    for (unsigned int c = 0; c < elasticity.n_cells(); ++c)
      for (unsigned int i = 0; i < elasticity.dofs(c).size(); ++i)
        {
          largest = std::max(largest, elasticity.diagonal(c, i));
          if (floating.floats()[elasticity.body(c)])
            terms.springs(elasticity.dofs(c)[i]) += weak * elasticity.diagonal(c, i);
        }
    terms.springs.compress(VectorOperation::add);
    largest = Utilities::MPI::max(largest, discretization.geometry.communicator);
    for (const auto &carrier : discretization.carrier_dofs)
      for (const auto &corner : carrier)
        for (const auto dof : corner)
          if (discretization.locally_owned.is_element(dof))
            terms.springs(dof) = weak * largest;
    for (const auto dof : floating.pins())
      if (discretization.locally_owned.is_element(dof))
        terms.pins(dof) = largest;
    terms.springs.compress(VectorOperation::insert);
    terms.pins.compress(VectorOperation::insert);
    terms.springs += terms.pins;
    return terms;
  }

  template <int dim>
  LA::Vector
  RigidModeStabilisation::springs_on(const std::vector<bool>   &moving,
                                     const FloatingBodies<dim> &floating) const
  {
    LA::Vector result(springs);
    for (const auto dof : result.locally_owned_elements())
      if (springs(dof) != pins(dof) && !moving[floating.owner_of(dof)])
        result(dof) = pins(dof);
    result.compress(VectorOperation::insert);
    return result;
  }

  template LA::Vector
  RigidModeStabilisation::springs_on(const std::vector<bool> &, const FloatingBodies<2> &) const;
  template LA::Vector
  RigidModeStabilisation::springs_on(const std::vector<bool> &, const FloatingBodies<3> &) const;
  template RigidModeStabilisation
  stabilise_rigid_modes(const Discretization<2> &, const ElasticityOperator<2> &, const FloatingBodies<2> &);
  template RigidModeStabilisation
  stabilise_rigid_modes(const Discretization<3> &, const ElasticityOperator<3> &, const FloatingBodies<3> &);
} // namespace Amontons

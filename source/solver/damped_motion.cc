#include <amontons/solver/damped_motion.h>

namespace Amontons
{
  // Carriers get what a body's share of their size would be: they move with what holds them.
  template <int dim>
  Damping
  lumped_damping(const Discretization<dim> &discretization)
  {
    const auto                          &sizes  = discretization.geometry.body_sizes;
    LA::Vector                           result = discretization.make_owned_vector();
    std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
    const double                         n_nodes = double(dofs.size()) / dim;
    double                               largest = 0;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          const auto b      = cell->material_id();
          double     volume = cell->measure();
          if (discretization.scene.kind == ProblemType::axisymmetric)
            volume *= 2 * numbers::PI * std::abs(cell->center()[0]);
          const double value =
              discretization.scene.bodies[b].material.young * volume / (sizes[b] * sizes[b]) / n_nodes;
          largest = std::max(largest, value);
          cell->get_dof_indices(dofs);
          for (const auto dof : dofs)
            result(dof) += value;
        }
    result.compress(VectorOperation::add);
    largest = Utilities::MPI::max(largest, discretization.geometry.communicator);
    for (const auto &carrier : discretization.carrier_dofs)
      for (const auto &corner : carrier)
        for (const auto dof : corner)
          if (discretization.locally_owned.is_element(dof))
            result(dof) = largest;
    result.compress(VectorOperation::insert);
    return {result, *std::max_element(sizes.begin(), sizes.end())};
  }

  template Damping
  lumped_damping(const Discretization<2> &);
  template Damping
  lumped_damping(const Discretization<3> &);
} // namespace Amontons

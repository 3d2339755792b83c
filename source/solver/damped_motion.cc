#include <amontons/solver/damped_motion.h>

namespace Amontons
{
  namespace
  {
    // Diagonals of the boxes around the bodies.
    template <int dim>
    std::vector<double>
    body_sizes(const Discretization<dim> &discretization)
    {
      const unsigned int  n = discretization.scene.bodies.size();
      std::vector<double> lower(n * dim, std::numeric_limits<double>::max()), upper(n * dim, -lower[0]);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          for (const auto v : cell->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                const unsigned int i = cell->material_id() * dim + d;
                lower[i]             = std::min(lower[i], cell->vertex(v)[d]);
                upper[i]             = std::max(upper[i], cell->vertex(v)[d]);
              }
      Utilities::MPI::min(lower, discretization.geometry.communicator, lower);
      Utilities::MPI::max(upper, discretization.geometry.communicator, upper);
      std::vector<double> sizes(n, 0.);
      for (unsigned int i = 0; i < n * dim; ++i)
        if (upper[i] > lower[i])
          sizes[i / dim] = std::hypot(sizes[i / dim], upper[i] - lower[i]);
      return sizes;
    }
  } // namespace

  // Carriers get what a body's share of their size would be: they move with what holds them.
  template <int dim>
  Damping
  lumped_damping(const Discretization<dim> &discretization)
  {
    const auto                           sizes  = body_sizes(discretization);
    LA::Vector                           result = discretization.make_owned_vector();
    std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
    const double                         n_nodes = double(dofs.size()) / dim;
    double                               largest = 0;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          const auto b      = cell->material_id();
          double     volume = cell->measure();
          if (discretization.scene.kind == Kind::axisymmetric)
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

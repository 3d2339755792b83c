/// How wrong the stress is inside the bodies, and by what facets leave out of round ones.
#pragma once

#include <amontons/elasticity/stress_recovery.h>

namespace Amontons
{
  /// Sums over this rank's cells of deformable bodies; energies with the compliance C^-1 of small strain.
  struct BulkError
  {
    std::vector<double> squares; ///< by active cell: eta_K^2 (error_estimator.h)
    /// By active cell. Linear elements have facets where a body is round: it is thinner by the slices behind
    /// them, a free surface that moves inwards by d changes the energy by int w d dA, w being its density
    /// there (Hadamard's formula): the mean of the cell. Stress and stiffness of a twisted or pressed column
    /// are off by that part, whatever its contact says. Nothing on the arcs of quadratic elements, which
    /// leave the square of it.
    std::vector<double> missing;
    double              error = 0, energy = 0; ///< sum of `squares` and `missing`; of the recovered stress
    double              no_energy = 0;         ///< what rounding of the displacements makes of it
  };

  /// rounding: of differences of displacements.
  template <int dim>
  BulkError
  bulk_error(const Discretization<dim> &discretization,
             const StressRecovery<dim> &recovery,
             const double               rounding);

  /// Of a cell, by that.
  template <int dim>
  double
  stress_of_rounding(const Discretization<dim>                            &discretization,
                     const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const double                                          rounding)
  {
    return rounding / cell->minimum_vertex_distance() *
           discretization.scene.bodies[cell->material_id()].material.young;
  }
} // namespace Amontons

/// What a refinement changed of the contact tractions, and what that says of their error.
#pragma once

#include <amontons/adaptivity/error_estimator.h>

namespace Amontons
{
  /// Pressure and tangential traction of the mesh before, as a field that goes along to the refined one.
  template <int dim>
  struct CoarserTractions
  {
    double          t = 0;
    LA::Vector      traction; // p n + shear on the slave nodes' DoFs, of all pairs; empty: none known
    RecoveredErrors recovered;
    /// Of the last comparison: how much larger the errors are than what recovery says.
    double pressure_factor = 1, shear_factor = 1;
  };

  template <int dim>
  LA::Vector
  surface_tractions(const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<SurfaceFields<dim>>    &fields);

  /// With errors e of the mesh before and e' of this one, and d the relative difference of their answers in
  /// the mean square: the difference is nearly orthogonal to what this mesh does not see, e^2 = d^2 + e'^2,
  /// and recovery, which may be off by a factor, sees at least how errors fall, q = e'/e = eta'/eta. So
  ///   e' = d q / sqrt(1 - q^2)                                                            (q < 1)
  /// needs no knowledge of the factor. `error` (of this mesh, fields too) is raised to that where it is
  /// larger; where there is nothing to compare with, by the last factor.
  template <int dim>
  void
  combine_with_difference(const Discretization<dim>                &discretization,
                          const std::vector<ContactInterface<dim>> &interfaces,
                          const std::vector<SurfaceFields<dim>>    &fields,
                          const double                              t,
                          CoarserTractions<dim>                    &before,
                          ErrorEstimate<dim>                       &error);

  /// e' from d, eta and eta'; 0 where recovery does not fall (q >= 0.95).
  double
  error_by_difference(const double difference, const double eta_before, const double eta);
} // namespace Amontons

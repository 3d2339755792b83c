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

  /// Raises `error` (of this mesh, fields too) to error_by_difference(); where there is nothing to compare
  /// with, by the last factor.
  template <int dim>
  void
  combine_with_difference(const Discretization<dim>                &discretization,
                          const std::vector<ContactInterface<dim>> &interfaces,
                          const std::vector<SurfaceFields<dim>>    &fields,
                          const double                              t,
                          CoarserTractions<dim>                    &before,
                          ErrorEstimate<dim>                       &error);

  /// What the relative difference d of the answers on two meshes (in the mean square) says of the error e' of
  /// the finer one, where recovery says eta and eta' of theirs. What a refinement adds is nearly orthogonal
  /// to what it does not see: e^2 = d^2 + e'^2. Recovery may be off by a factor, in two ways:
  /// - on both meshes, while it sees how errors fall, q = e'/e = eta'/eta (at most 0.8 is believed):
  ///     e' = d q / sqrt(1 - q^2);
  /// - on the finer mesh alone (the edge of the contact is as badly placed in its cell as before): the change
  /// left
  ///     e' = sqrt(eta^2 - d^2)
  ///   of the error, if that was eta. Which of the two, eta' or this, is right, is not known: their geometric
  ///   mean.
  /// The largest of eta' and of both.
  double
  error_by_difference(const double difference, const double eta_before, const double eta);
} // namespace Amontons

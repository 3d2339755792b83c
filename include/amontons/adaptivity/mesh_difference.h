/// What a refinement changed of the contact tractions, and what that says of their error.
#pragma once

#include <amontons/adaptivity/error_estimator.h>

namespace Amontons
{
  /// How much larger errors are than what recovery says of them: what is told of this mesh, and what the
  /// last comparison says of the mesh before.
  struct RecoveryFactors
  {
    double of_this = 1, of_coarser = std::numeric_limits<double>::infinity();
  };

  /// Answers are compared at the same time and after increments of the same length: else what increments
  /// change would count as errors of the mesh.
  struct PlaceInHistory
  {
    double t = 0, increment_length = 0;
  };

  /// Pressure and tangential traction of the mesh before, as a field that goes along to the refined one.
  template <int dim>
  struct CoarserTractions
  {
    PlaceInHistory place;
    LA::Vector     traction;          // p n + shear on the slave nodes' DoFs, of all pairs; empty: none known
    std::vector<std::size_t> n_nodes; // of the slave, by pair
    RecoveredErrors          recovered;
    RecoveryFactors          pressure, shear; // of the last comparison
  };

  template <int dim>
  std::vector<std::size_t>
  numbers_of_nodes(const std::vector<ContactInterface<dim>> &interfaces);

  /// Of the pairs that count (pair_weights).
  template <int dim>
  LA::Vector
  surface_tractions(const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<SurfaceFields<dim>>    &fields);

  /// The errors of tractions in `error` (of this mesh, as fields) by error_by_comparisons(); where there is
  /// nothing to compare with, by the last factor. So, too, at least, where a surface that bears pressure was
  /// not refined: that its tractions stay says nothing of their error.
  template <int dim>
  void
  combine_with_difference(const Discretization<dim>                &discretization,
                          const std::vector<ContactInterface<dim>> &interfaces,
                          const std::vector<SurfaceFields<dim>>    &fields,
                          const PlaceInHistory                     &place,
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

  /// e / eta of the coarser mesh, with the first of these two.
  double
  factor_by_difference(const double difference, const double eta_before, const double eta);

  /// error_by_difference(), unless two comparisons, one after the other, say that recovery is too large (with
  /// shears it is, by 2 to 4): the edge of a contact does not stay badly placed. Then the larger factor
  /// counts; factors that grow (as those of pressures on coarse meshes do) are taken to grow on as much, if
  /// they may_grow: those of shears in space swing between 0.3 and 0.4, and a mesh that is not needed takes
  /// as long as all before; 1/4 at least, made safer by 1.4. factors: of the comparison before, and then of
  /// this one.
  double
  error_by_comparisons(const double     difference,
                       const double     eta_before,
                       const double     eta,
                       RecoveryFactors &factors,
                       const bool       may_grow = true);
} // namespace Amontons

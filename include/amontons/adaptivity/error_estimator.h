// How wrong the answer is, and where.
#pragma once

#include <amontons/adaptivity/facet_error.h>
#include <amontons/elasticity/loads.h>
#include <amontons/elasticity/stress_recovery.h>

#include <deal.II/lac/vector.h>

#include <optional>

namespace Amontons
{
  // Errors of the tangential traction are relative to it or to this part of the pressure, if that is larger.
  constexpr double noteworthy_shear = 0.05;

  // With less than this part of its largest pressure, a load program with friction has unloaded: errors are
  // told relative to what it had.
  constexpr double unloaded_part = 0.05;

  // By recovery alone, relative L2 errors of the pressure and, with friction, of the tangential traction.
  struct RecoveredErrors
  {
    double pressure = 0, shear = 0;
  };

  template <int dim>
  struct ErrorEstimate
  {
    Vector<float> cell_indicators; // by active cell of this rank's triangulation (0 on cells of others and of
                                   // rigid bodies): energy norm
    Vector<float> contact_indicators;   // the same for the L2 error of the contact pressure alone
    Vector<float> shear_indicators;     // and of the tangential traction, with friction
    Vector<float> pollution_indicators; // of coarse cells around the contact, for the pressure
    Vector<float> quantity_indicators;  // where the peak is a cusp; of sizes: ends that meshes do not tell
    double        energy_norm = 0, pressure_norm = 0, shear_norm = 0; // what these count against
    double        bulk = 0; // sqrt(sum eta_K^2) / energy norm of the recovered stress: relative
    double        contact =
        0; // relative L2 error of the contact pressure, estimated: see estimate_error; 0 without contact
    double shear          = 0;                                  // of the tangential traction, with friction
    double worst_pressure = 0, worst_shear = 0, worst_bulk = 0; // not relative, of a load history so far
    double facets        = 0;                                   // the part of `contact` that facets cause
    double pollution     = 0; // part of `contact`: what coarse cells around the contact cause, and
    double sections      = 0; // what facets of round bodies leave out of the energy; also part of `shear`
    double data          = 0; // part of `contact`: lost between the nodes, where recovery sees nothing
    double peak          = 0; // difference of the peak pressure from that of the recovered stress, relative
    double cusp          = 0; // how far the peak may be above all nodes, relative; 0: it is none
    bool   cusp_grows    = false; // too slowly for any mesh
    double friction_data = 0;     // of the sum of |shear|: bounds of friction that are lost between the nodes
    RecoveredErrors         doubted;   // what pairs that are not refined yet may hide beside `recovered`
    RecoveredErrors         recovered; // without what differences between meshes add (mesh_difference.h)
    std::vector<FacetError> facets_of; // by interface
    std::optional<double>   quantity;  // of `Target quantity`, if that is a number

    // What refinement goes by: of the contact tractions; of the stress where nothing touches. Forces that
    // displacements cause are off by the square of the stress's error (as any work is).
    double
    decisive() const
    {
      return contact > 0 ? std::max({contact, shear, bulk * bulk}) : bulk;
    }
    double
    of_target() const
    {
      return quantity.value_or(decisive());
    }

    // By cell, relative, for tractions to be that good: squared, the sum of the squares of the tractions'
    // errors, and of 2 `target` times that of the stress, so that its square may be half of the target.
    Vector<float>
    indicators_for(const double target) const;
  };

  // By pair: what the squares of its tractions and of their errors are multiplied by, so that pairs count
  // alike, whatever their load: with it, int p^2 is that of the pair where it is largest; largest_pair_weight
  // at most. Where others press, tied pairs do not count: their tractions, infinite at the ends of a joint,
  // are stress.
  constexpr double largest_pair_weight = 1e6;
  template <int dim>
  std::vector<double>
  pair_weights(const std::vector<ContactInterface<dim>> &interfaces,
               const std::vector<SurfaceFields<dim>>    &fields);

  // E* of both sides of a pair.
  template <int dim>
  double
  combined_modulus(const Scene &scene, const ContactInterface<dim> &interface);

  // Bulk: eta_K^2 = int_K (sigma* - sigma_h) : C^-1 : (sigma* - sigma_h) (doc/introduction.md, (30);
  // Zienkiewicz and Zhu 1987), with sigma* the recovered stress, and what facets leave out (bulk_error.h).
  // Contact: eta_F^2 = h_F / E int_F (p + n . sigma_h n)^2 + |tangential part of sigma_h n, less that of the
  // contact|^2 (doc/introduction.md, (31)) on the slave faces of the coupling, without the second term where
  // surfaces are tied; added to the slave's cell and, in proportion to the overlaps, to the masters' cells:
  // cell_indicators = sqrt(eta_K^2 + sum eta_F^2). `contact` = sqrt(sum w int (p* - p)^2 / sum w int p^2)
  // over pairs of these weights, where p* = -n . sigma* . n is the recovered normal stress of the slave body;
  // where surfaces are tied the whole traction counts; `shear` likewise, of the pairs with friction. n is the
  // normal of the true surface. Stresses and tractions that are no more than the rounding of the
  // displacements makes them are none, and have no error. What loads put on slave faces is no part of what
  // the contact carries there. recovery: of the displacement. fields: by interface; doubts: likewise, see
  // RefinedPairs (empty: none). Collective.
  template <int dim>
  ErrorEstimate<dim>
  estimate_error(const Discretization<dim>                &discretization,
                 const StressRecovery<dim>                &recovery,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<SurfaceFields<dim>>    &fields,
                 const LA::Vector                         &displacement,
                 const bool                                finite_strain,
                 const FaceLoads<dim>                     *face_loads = nullptr,
                 const std::vector<double>                &doubts     = {});

  // By slave face, to the cells of this rank on both sides, of which each gets the largest.
  template <int dim>
  void
  indicate_at_faces(const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const std::vector<double>   &of_faces,
                    Vector<float>               &indicators);

  // The centre of the cell with the largest indicator. Collective.
  template <int dim>
  Point<dim>
  place_of_largest(const Discretization<dim> &discretization, const Vector<float> &indicators);
} // namespace Amontons

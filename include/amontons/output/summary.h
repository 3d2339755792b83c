// The answer of a run as plain values: one table feeds screen, CSV, JSON, report and tests.
#pragma once

#include <amontons/adaptivity/increment_error.h>
#include <amontons/contact/surface_approach.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Amontons
{
  // Vectors have `dimension` components. Unknown numbers are NaN (null in JSON).
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  // Contact forces on the slave body (axisymmetric: for the full turn; plane: per unit thickness).
  struct PairSummary
  {
    std::string           name;
    std::vector<double>   normal_force, tangential_force;
    double                peak_pressure = 0;
    double                contact_size  = 0; // half-width or radius
    std::optional<double> approach;          // of the bodies since they touched, where that has a meaning
    std::optional<double> stick_size;   // friction: of what the shear leaves of its bound (partial slip: c)
    std::vector<double>   centre;       // about which the size is taken
    std::vector<double>   stick_centre; // about which stick_size is taken; empty without friction
    unsigned int          n_open = 0, n_stick = 0, n_slip = 0; // of the nodes that carry a multiplier
    unsigned int          n_without_multiplier = 0;            // supports own these nodes whole
    double                smallest_gap         = unknown; // of these nodes; unknown where nothing is opposite
    bool                  touched = true; // a node is closed; in the answer: in any increment, on any mesh
  };

  struct ProbePoint
  {
    std::vector<double> point; // reference configuration
    // Empty and NaN where the point lies outside its body.
    std::vector<double> displacement, stress;
    double              von_mises = unknown;
  };

  struct ProbeSummary
  {
    std::string             name;
    std::vector<ProbePoint> points;
  };

  // Of small strain, relative: of the answer, of the tangential traction (with friction), of the
  // `Target quantity`; whether finite strain may take its place.
  struct KinematicsErrors
  {
    double answer = unknown, shear = unknown, target = unknown;
    bool   has_alternative = true;
  };

  struct EstimateSummary // relative
  {
    double           bulk = unknown, contact = unknown; // of the mesh: stress, pressure
    double           shear      = unknown;              // friction: of the tangential traction
    double           facets     = 0;                    // of `contact`: what refinement does not mend
    double           quantity   = unknown;              // of `Target quantity`, if that is a number
    double           increments = unknown; // friction: of IncrementErrors, what counts for the target
    KinematicsErrors kinematics = {};
  };

  // Facets that make a smaller relative error of the pressure are not worth a word.
  constexpr double noteworthy_facets = 1e-3;

  struct ReferenceSummary
  {
    std::string closed_form;
    // Relative: normal_force, contact_size, peak_pressure, approach, pressure_l2, displacement_l2,
    // displacement_h1, energy; friction: tangential_force, stick_size, shear_l2, dissipation.
    std::map<std::string, double>                errors;
    std::map<std::string, std::array<double, 2>> values; // computed, exact
  };

  // The state reached on one mesh of one increment: a row of history.csv.
  struct MeshSummary
  {
    unsigned int             increment = 0, mesh = 0;
    double                   t     = 0;
    unsigned long long       cells = 0, dofs = 0;
    unsigned int             iterations = 0, krylov_iterations = 0;
    double                   residual = unknown;
    double                   seconds  = unknown;
    std::vector<PairSummary> pairs;
    EstimateSummary          error_estimate;
    double                   energy = unknown;
    // Friction, since t = 0: work of loads and moving supports, what of it the contact took (both by the
    // trapezoidal rule), and the frictional work with the tractions at the ends of the increments.
    std::optional<double>           external_work, contact_work, dissipation;
    std::vector<ProbeSummary>       probes;
    std::optional<ReferenceSummary> reference;
  };

  // The semismooth Newton iteration on one mesh of one increment.
  struct NewtonSummary
  {
    unsigned int              increment = 0, mesh = 0;
    unsigned long long        dofs = 0, cells = 0;
    unsigned int              iterations = 0, outer_iterations = 0; // outer: of methods that have them
    std::vector<unsigned int> active_set_changes;                   // per iteration
    unsigned int              krylov_iterations = 0;
    double                    residual          = unknown; // the last one
    std::vector<double>       residuals;                   // per iteration
  };

  struct ReactionSummary
  {
    std::string         condition, boundary; // boundary: "body/boundary"
    std::vector<double> force, moment;       // by the support on the body; moment: 1 component in 2D, 3 in 3D
  };

  struct CostSummary
  {
    double                        wall_seconds = unknown;
    std::map<std::string, double> timing;                       // seconds by phase
    unsigned int                  linear_solves            = 0; // all, of repeated and failed increments, too
    double                        one_linear_solve_seconds = unknown;
    double                        finest_mesh_seconds      = unknown;
  };

  struct RunSummary
  {
    bool        converged = false;
    std::string failure;      // its kind, of Diagnosis::kind; empty if converged
    std::string message;      // why not
    std::string scene, title; // scene: the file
    ProblemType kind = ProblemType::plane_strain;
    Units       units;

    unsigned long long dofs = 0, cells = 0; // of the finest mesh
    unsigned int       ranks       = 1;
    unsigned int       n_cut_backs = 0; // of increments
    CostSummary        cost;

    std::vector<NewtonSummary>      newton;
    std::vector<MeshSummary>        meshes;
    std::vector<PairSummary>        pairs;
    double                          energy = unknown;
    EstimateSummary                 error_estimate;
    std::optional<IncrementErrors>  increments;
    std::vector<ReactionSummary>    reactions;
    std::vector<ProbeSummary>       probes;
    std::optional<ReferenceSummary> reference;
    std::map<std::string, double>   checks; // force_balance, complementarity, ...
    std::vector<std::string>        notes;  // what was modelled and why, what regularises, what was left out

    std::string
    status() const
    {
      return converged ? "converged" : "not converged";
    }
  };

  template <int dim>
  PairSummary
  summarize_pair(const ContactInterface<dim> &interface,
                 const SurfaceFields<dim>    &fields,
                 const SurfaceApproach<dim>  &approach);

  // Of a pair that touched nothing: where its surfaces are in the end.
  std::string
  without_contact(const PairSummary &pair);

  std::string
  kind_name(const ProblemType kind); // "plane strain", ...
  std::vector<std::string>
  stress_names(
      const ProblemType kind); // in the order of Voigt<dim>: "xx", "yy", ... ("rr", "zz", "tt", "rz")
  std::vector<std::string>
  axis_names(const ProblemType kind); // "x", "y"(, "z"); axisymmetric "r", "z"

  // summary.json. To be called on rank 0.
  void
  write_summary(const RunSummary &summary, const std::string &file);
} // namespace Amontons

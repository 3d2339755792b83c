/// Where the load program is on the present mesh, and what it has done so far.
#pragma once

#include <amontons/adaptivity/increment_error.h>
#include <amontons/adaptivity/mesh_difference.h>
#include <amontons/adaptivity/mesh_sequence.h>
#include <amontons/adaptivity/quantity_sequence.h>
#include <amontons/output/energy.h>
#include <amontons/solver/diagnosis.h>
#include <amontons/solver/newton_report.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  /// A value: the repeat of a load program with other increments works on a new one, and the run goes on from
  /// the old one. Both states belong to the present mesh; a refinement moves all of it or drops it.
  template <int dim>
  struct LoadHistory
  {
    SolutionState<dim> state, last_converged;
    // Has converged, on this mesh before its last refinement, or with surfaces that were coupled in a smaller
    // part; until the next state converges.
    SolutionState<dim> fallback;
    unsigned int       fallback_mesh = 0;
    /// Replay: the increments on the mesh before, as first guesses.
    struct PathPoint
    {
      double              t;
      LA::Vector          displacement, traction;
      std::vector<double> peaks;
    };
    std::vector<PathPoint> path;
    CoarserTractions<dim>  coarser;
    CoarserTractions<dim>  pressed_most;   // replay: of this mesh, where its pressure was largest
    std::vector<double>    coarser_forces; // total ones by pair, likewise
    MeshSequence           meshes;         // with the error of the last solve on each
    QuantitySequence       quantity;       // `Target quantity`, by pair
    WorkDone<dim>          work;
    LoadRecord             record;      // friction: what the error of the increments is measured by
    NewtonReport           last_report; // of the last solve

    bool starts_before = false; // loads that are there at t = 0 grow before
    bool at_once       = false; // finite strain: one increment, from `path`
    bool follow_motion = false; // in the next increment, see PseudoTransient
    /// Of the last load program, see LoadRecord; nothing: there was none.
    std::optional<std::vector<double>> growing;
    std::vector<Diagnosis::Snap>       snaps;
    double                             last_speed = 0; // largest displacement over t in the last increment
    double       transfer_residual                = 0; // largest, of the transferred state on its new mesh
    unsigned int n_cut_backs                      = 0;
    // Beyond these an increment is given up, where another answer is known.
    unsigned int                  most_cut_backs = std::numeric_limits<unsigned int>::max();
    static constexpr unsigned int many_cut_backs = 8;

    /// All that moves to a refined mesh; what is not known stays empty.
    std::vector<LA::Vector *>
    fields();

    /// After an increment that converged, before it is committed: whether its bodies moved on from where they
    /// had no equilibrium, which the snaps say from now on. owned: to work in. Collective.
    bool
    snapped(const double duration, LA::Vector owned);

    /// The load program starts at t; the state is where it starts from.
    void
    restart(const double t);
  };
} // namespace Amontons

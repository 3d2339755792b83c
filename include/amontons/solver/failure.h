/// Why an iteration ended without an answer: a value, on whose kind callers decide; diagnosis.h makes the
/// sentence for the user.
#pragma once

#include <limits>
#include <string>

namespace Amontons
{
  struct Failure
  {
    enum class Kind
    {
      not_a_number,
      linear_solver,
      no_memory,             // for the factors of the matrix
      given_up,              // the run is to end
      inverted_cell,         // by every step that was tried, however short
      passed_through,        // one surface through another, within the increment
      entered,               // a corner went into a body where no normal finds it
      beyond_symmetry,       // a body moved through its own plane of symmetry
      driven_through,        // a rigid obstacle, by supports
      wall_touched,          // of Discretization::walls, taken for none
      moves_apart,           // loads drive a rigid motion that no closed node holds
      flown,                 // to `residual` times their size: rounding of such a motion hides all forces
      beyond_edge,           // what holds the bodies would have to lie beyond the edge of the contact
      friction_beyond_limit, // limit analysis: no contact forces within the bounds balance the loads
      friction_exceeded,     // where nodes are held against their bound nothing else changes
      friction_at_limit, // no states in equilibrium; with coefficients 2 % lower there are no forces, either
      friction_slides,   // all nodes that could hold a motion slipped time and again
      no_states,         // none of the above, after many iterations
      still_moving,      // damped motion that does not come to rest
      motion_lost,       // damped motion whose steps become too short
      multipliers_unsettled, // of AugmentedLagrangian
      bounds_unsettled,      // of FixedPointFriction
      seed_unsettled         // states or friction forces of SeedIteration
    };

    Kind         kind;
    unsigned int n        = 0; // iterations, or steps
    double       residual = std::numeric_limits<double>::quiet_NaN();

    // For the user: the rigid motion, places of nodes, the cell.
    std::string motion = "", where = "", cell = "";
    // Kind::no_states
    unsigned int n_changes    = 0;                           // nodes that still change
    bool         single_nodes = false, given_bounds = false; // tried, see NodeStates
    bool         friction = false;                           // somewhere in the scene
  };
} // namespace Amontons

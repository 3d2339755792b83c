/// Why an iteration did not converge, and what the user can change.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/solver/failure.h>
#include <amontons/solver/newton_report.h>
#include <amontons/solver/node_states.h>

namespace Amontons
{
  namespace Diagnosis
  {
    /// For the user: what happened, and what may help.
    std::string
    sentence(const Failure &failure);

    /// For programs: "no states", "friction beyond limit", ..., the names of Failure::Kind.
    std::string
    kind(const Failure &failure);

    /// Of the state after the last iteration.
    template <int dim>
    Failure
    no_states_found(const NewtonReport &report, const NodeStates<dim> &states, const bool any_friction);

    /// None if contact forces within the bounds of friction might balance the loads.
    template <int dim>
    std::optional<Failure>
    friction_beyond_limit(const NodeStates<dim> &states);

    /// None if contact forces might balance the loads with coefficients that are 2 % lower: at finite strain
    /// rough surfaces bear a little more than plane ones.
    template <int dim>
    std::optional<Failure>
    friction_at_limit(const NodeStates<dim> &states);

    template <int dim>
    Failure
    friction_exceeded(const NodeStates<dim> &states);

    /// motions: rigid ones that the states leave.
    template <int dim>
    Failure
    moves_apart(const NodeStates<dim> &states, const std::vector<std::vector<double>> &motions);

    /// kind: passed_through, entered, beyond_symmetry or driven_through, at these nodes.
    template <int dim>
    Failure
    surfaces_cross(const Failure::Kind kind, const std::vector<Point<dim>> &nodes);

    template <int dim>
    Failure
    inverted(const Discretization<dim> &discretization, const InvertedCell<dim> &cell);

    // Increments that ended where damped motion led to: a note on those that went far.
    struct Snap
    {
      double t, distance; // largest displacement
      bool   far;         // compared with what the load moves
      bool   unstable;    // the equilibrium nearby is
    };
    std::string
    snapped(const std::vector<Snap> &all, const bool far);
  } // namespace Diagnosis
} // namespace Amontons

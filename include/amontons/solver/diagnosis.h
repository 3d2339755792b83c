// Why an iteration did not converge, and what the user can change.
#pragma once

#include <amontons/solver/node_states.h>
#include <amontons/solver/semismooth_newton.h>

namespace Amontons
{
  namespace Diagnosis
  {
    std::string
    not_a_number();

    // motion: the rigid motions that only weak springs hold
    std::string
    moves_apart(const std::string &motion);

    // Increments that ended where damped motion led to: a note on those that went far.
    struct Snap
    {
      double t, distance; // largest displacement
      bool   far;         // compared with what the load moves
      bool   unstable;    // the equilibrium nearby is
    };
    std::string
    snapped(const std::vector<Snap> &all, const bool far);

    // The damped motion after n steps.
    std::string
    still_moving(const unsigned int n, const double residual);

    // "" if friction might hold the bodies
    template <int dim>
    std::string
    friction_too_weak(const NodeStates<dim> &states);

    template <int dim>
    std::string
    friction_exceeded(const NodeStates<dim> &states);

    // After the last iteration.
    template <int dim>
    std::string
    no_states_found(const NewtonReport &report, const NodeStates<dim> &states, const bool any_friction);
  } // namespace Diagnosis
} // namespace Amontons

/// The iteration of the paper that this program began with, to compare with.
#pragma once

#include <amontons/solver/newton.h>

namespace Amontons
{
  /// D. Siminiati, FEM numerical algorithm on contact problem for non-conform elastic bodies, section 4.2: in
  /// each increment, from the states of the one before,
  ///   M^T K M du = M^T (R - F),   M: the closed nodes touch, those that stick do not slide;
  ///   F: in the slipping zone the force of friction mu |sigma_c| of the previous iteration,
  /// (doc/introduction.md, (35)), then, of all nodes at once,
  ///   (a) an open node has A du - delta > 0, else it closes (and sticks);
  ///   (b) a closed one has sigma_c < 0, else it opens;
  ///   (c.1) one that sticks has tau < mu |sigma_c|, else it slips, against the direction of tau;
  ///   (c.2) one that slips has tau = mu |sigma_c|: its force follows in the next iteration,
  /// until no state and no force changes. This fails as the paper's would: states may come back (there is no
  /// safeguard but a number of iterations), forces swing where friction is large, all nodes may slip although
  /// friction holds the body, and as no rule lets a slipping node stick again, nodes that slipped too early
  /// or whose load turns round go on to slip, against their friction: a note counts them. Smaller increments
  /// change fewer nodes in each, but nothing where the first one fails and all loads grow alike.
  ///
  /// The paper does not say as what a node closes, nor which way friction points where the slip turns: it
  /// keeps its direction here. What is not the paper's: small strain (its Updated Lagrangian formulation is
  /// not followed, pairs are those of the start), nodes that touch faces (collocate()) for its pairs of
  /// nodes, rounding that decides about nothing, and bodies that nothing holds. No limit analysis and no rule
  /// for rigid motions comes to help (see NodeStates).
  template <int dim>
  class SeedIteration
  {
  public:
    SeedIteration(const ContactEquilibrium<dim> &problem, Newton<dim> &newton)
        : problem(problem), newton(newton)
    {
    }

    /// `Maximum iterations` linear solves at most.
    NewtonReport
    run();

  private:
    void
    start();
    unsigned int
    update(NodeStates<dim> &states, const NodalContacts<dim> &answers, const double rounding);
    ContactStatus
    next_state(const unsigned int k, const ContactStatus state, const NodalContact<dim> &answer) const;
    double
    bound(const unsigned int k, const double pressure) const;
    void
    stop_or_go_on();

    const ContactEquilibrium<dim> &problem;
    Newton<dim>                   &newton;
    double                         tolerance = 0; // a pressure that is none
    double                         change    = 0; // of the forces of friction, in the last update
  };
} // namespace Amontons

// Limit load of rigid bodies with dry friction: can any contact forces balance the loads?
#pragma once

#include <vector>

namespace Amontons
{
  // What one contact node sees of rigid motions q: its jump closes by closing . q and slides by the vector
  // (sliding[c] . q)_c.
  struct RigidContact
  {
    std::vector<double>              closing;
    std::vector<std::vector<double>> sliding; // frictionless: empty
    double                           friction = 0;
  };

  // The loads f that contact forces can balance are the convex cone C of all
  //   sum_k p_k (closing_k + friction_k sum_c d_c sliding_k,c),   p_k >= 0, |d| <= 1   (doc/introduction.md,
  //   (19)).
  // Where f is not in C, there is no equilibrium, however elastic bodies share the forces between the nodes,
  // and v = f - (the nearest of C) proves it: f . v > 0, but contact forces do no positive work against it:
  //   closing_k . v + friction_k |sliding_k . v| <= 0 for all k
  // (the theorem of limit analysis that needs no flow rule: the nodes need not really move like that).
  //
  // v slides and lifts at the slope of friction. What is returned is the motion to tell the user: v without
  // what opens the nodes that carry the nearest of C, of unit length; v itself if nothing else is left. Empty
  // if f is nearer to C than `margin`, or if no friction works on v: a larger coefficient would not help.
  std::vector<double>
  motion_beyond_friction(const std::vector<double>       &load,
                         const std::vector<RigidContact> &contacts,
                         const double                     margin);

  // v itself, of unit length; empty if f is nearer to C than `margin`.
  std::vector<double>
  motion_beyond_contact(const std::vector<double>       &load,
                        const std::vector<RigidContact> &contacts,
                        const double                     margin);

  // sum_j v_j motions_j; empty if v is.
  std::vector<double>
  combination(const std::vector<std::vector<double>> &motions, const std::vector<double> &v);
} // namespace Amontons

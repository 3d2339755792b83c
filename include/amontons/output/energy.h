// Where the work goes: external work, stored energy, friction.
#pragma once

#include <amontons/output/quantities.h>

namespace Amontons
{
  // Sums over the increments of a load history on one mesh, by the trapezoidal rule, with the contact forces
  // c on the bodies and e = internal forces - c, which holds loads and forces of moving supports:
  //   external work  W = sum (e_old + e)/2 . (u - u_old) + G
  //   contact work   C = - sum (c_old + c)/2 . (u - u_old) + G
  //   dissipation    D = sum area q . slip                      slip of the increment
  //   growth         G = - sum (area_old p_old + area p)/2 |normal|^2 (g - g_old)
  // with g the declared gaps at the nodes (those of their rows: normal . int psi g n / area): an interference
  // that grows works on both sides. So W = (change of the stored energy) + C in equilibrium: exactly with
  // small strain, else up to the third power of the increments. C - D vanishes with the increments.
  template <int dim>
  class WorkDone
  {
  public:
    // A history starts, at rest.
    void
    restart();

    // From answer.state.committed to answer.state. Collective.
    void
    add(const Answer<dim> &answer);

    // After a transfer to another mesh, which changed the state: goes on from answer.state. Collective.
    void
    rebase(const Answer<dim> &answer);

    double transferred_energy = 0; // stored energy that transfers added (or took)
    double external_work = 0, contact_work = 0, dissipation = 0;
    double smallest_dissipation = 0; // of an increment
    // |W - change of stored energy - C| over the largest of the work so far
    double energy_error = 0, largest_work = 0;

  private:
    double     energy = 0;
    LA::Vector external, contact; // e and c of the last state
    // Forces area x p |normal|^2 where declared gaps grow, by interface and slave node.
    using NodeForces = std::map<std::pair<unsigned int, unsigned int>, double>;
    NodeForces pressing; // of the last state
    static NodeForces
    forces_on_growing_gaps(const Answer<dim> &answer);
  };
} // namespace Amontons

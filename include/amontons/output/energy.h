// Where the work goes: external work, stored energy, friction.
#pragma once

#include <amontons/output/quantities.h>

namespace Amontons
{
  // Sums over the increments of a load history on one mesh, by the trapezoidal rule, with the contact forces c on
  // the bodies and e = internal forces - c, which holds loads and forces of moving supports:
  //   external work  W = sum (e_old + e)/2 . (u - u_old)
  //   contact work   C = - sum (c_old + c)/2 . (u - u_old)
  //   dissipation    D = sum area q . slip                      slip of the increment
  // so that W = (change of the stored energy) + C in equilibrium: exactly with small strain, else up to the third
  // power of the increments. C - D vanishes with the increments.
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
  };
} // namespace Amontons

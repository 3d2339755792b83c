// Where the work goes: external work, stored energy, friction.
#pragma once

#include <amontons/output/quantities.h>

namespace Amontons
{
  // Sums over the increments of a load history on one mesh (small sliding: jumps are linear in u), with the
  // contact traction -Lambda, Lambda = p n + q, on the slave:
  //   external work  W = sum (e_old + e)/2 . (u - u_old)              loads and forces of moving supports
  //   contact work   C = sum area (Lambda_old + Lambda)/2 . (Delta - Delta_old)
  //   dissipation    D = sum area q . slip                            slip of the increment
  // so that W = (change of the stored energy) + C in equilibrium. C - D vanishes with the increments.
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
    void
    remember_tractions(const Answer<dim> &answer);

    double                                                    energy = 0;
    LA::Vector                                                external;  // e of the last state
    std::vector<std::vector<std::pair<double, Tensor<1, 3>>>> tractions; // (pressure, shear) by pair and node
  };
} // namespace Amontons

// Where the work goes: external work, stored energy, friction.
#pragma once

#include <amontons/output/quantities.h>

namespace Amontons
{
  // Sums over the increments of a load history on one mesh, by the trapezoidal rule, with the contact forces
  // c on the bodies and e = internal forces - c, which holds loads and forces of moving supports:
  //   external work  W = sum (e_old + e)/2 . (u - u_old) + G
  //   contact work   C = - sum (c_old + c)/2 . (u - u_old) + G
  //   dissipation    D = sum area (b_old + b)/(2 b) q . slip    slip of the increment, bounds b of |q|;
  //                     + area_old q_old . slip/2, if positive, of nodes that have opened
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

    // Before the mesh is refined: what the forces of the last state, which are those of its nodes, do on the
    // way to answer.state. Collective.
    void
    leave_mesh(const Answer<dim> &answer);

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
    // By interface and slave node, of the last state: forces area x p |normal|^2 where declared gaps grow;
    // friction.
    template <typename Value>
    using ByNode     = std::map<std::pair<unsigned int, unsigned int>, Value>;
    using NodeValues = ByNode<double>;
    NodeValues pressing;
    struct Friction
    {
      double         bound; // of the shear
      Tensor<1, dim> force; // area q
    };
    ByNode<Friction> friction;
    static NodeValues
    forces_on_growing_gaps(const Answer<dim> &answer);
    static ByNode<Friction>
    friction_of(const Answer<dim> &answer);
    double
    work_of_friction(const Answer<dim> &answer, const ByNode<Friction> &now) const;

    // Of one end of an increment: half of its forces on the whole way (trapezoidal rule).
    struct Half
    {
      double external = 0, contact = 0, growth = 0;
    };
    static Half
         half_of(const Answer<dim> &answer,
                 const LA::Vector  &external,
                 const LA::Vector  &contact,
                 const NodeValues  &pressing);
    Half start; // on the mesh before
  };
} // namespace Amontons

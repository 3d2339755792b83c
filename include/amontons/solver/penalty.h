/// Contact by penalty, to compare with: bodies overlap a little, and the overlap makes the pressure.
#pragma once

#include <amontons/solver/contact_kinematics.h>
#include <amontons/solver/node_states.h>

namespace Amontons
{
  /// Instead of equations of closed nodes, with eps = factor E/(1 - nu^2)/h and the slip v of the increment
  ///   p = -eps g,   trial = q_old + eps v,   stick: q = trial,   slip: q = phi(p) trial/|trial|
  /// (Wriggers, Computational Contact Mechanics, 2006). What is reported as slip is v without its elastic
  /// part (q - q_old)/eps. Tied nodes keep their equations. With multipliers that are kept (of
  /// AugmentedLagrangian) p = lambda_n - eps g and trial = lambda_t + eps v.
  template <int dim>
  class Penalty
  {
  public:
    /// A traction that no overlap makes.
    struct Multiplier
    {
      double         pressure = 0;
      Tensor<1, dim> shear;
    };

    /// scaling: that the nodes' complementarity parameters were made with.
    Penalty(const double                  factor,
            const double                  scaling,
            const ContactKinematics<dim> &contact,
            const SolutionState<dim>     &state)
        : stiffness_per_c(factor / scaling), contact(contact), state(state)
    {
    }

    /// By node, from now on.
    void
    keep(const std::vector<Multiplier> &multipliers)
    {
      kept = multipliers;
    }

    /// Of a closed node its gap is 0, as the overlap stands for a pressure; of an open one it is
    /// g - lambda_n/eps, so that it closes where there would be a pressure, and its slip trial/eps, so that
    /// it slips where the trial would exceed its bound.
    NodalContact<dim>
    answer(const unsigned int k, const NodeStates<dim> &states) const;

    /// Adds the force on each owned DoF of the node.
    void
    add_forces(const unsigned int k, const NodeStates<dim> &states, LA::Vector &forces) const;

    /// - d forces/du
    LocalMatrix
    stiffness(const unsigned int k, const NodeStates<dim> &states) const;

  private:
    double
    pressure(const unsigned int k) const
    {
      return (kept.empty() ? 0 : kept[k].pressure) - eps(k) * contact.gap(k, state.displacement);
    }
    Tensor<1, dim>
    trial(const unsigned int k) const;
    double
    eps(const unsigned int k) const
    {
      return stiffness_per_c * contact.nodes()[k].c;
    }

    const double                  stiffness_per_c;
    const ContactKinematics<dim> &contact;
    const SolutionState<dim>     &state; // the displacement is that of the contact's last move
    std::vector<Multiplier>       kept;  // empty: no pressure, and the shear that the increment began with
  };
} // namespace Amontons

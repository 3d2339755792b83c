// Contact nodes of surfaces that move far: their gaps and slips in the current configuration, with
// derivatives.
#pragma once

#include <amontons/algebra/row_system.h>
#include <amontons/contact/coupling_derivatives.h>
#include <amontons/solver/contact_kinematics.h>
#include <amontons/solver/increment_slip.h>
#include <amontons/solver/node_states.h>
#include <amontons/solver/old_partners.h>

namespace Amontons
{
  // Surfaces move with the bodies, and the coupling of each pair is integrated where they are; the nodes are
  // those of the slave surfaces, whether anything is opposite of them at present or not, so that their
  // numbers stay. Tied pairs keep the coupling of the start: material points stay together.
  template <int dim>
  class MovingContact : public ContactKinematics<dim>
  {
  public:
    using ContactKinematics<dim>::is_opposite;

    // Couples the surfaces as they are at start.committed (empty: undeformed) first. Nodes that are closed in
    // `start` may stick from the beginning of the increment.
    MovingContact(const Discretization<dim>          &discretization,
                  const Constraints                  &supports,
                  std::vector<ContactInterface<dim>> &interfaces,
                  const SolutionState<dim>           &start,
                  const double                        scaling);

    bool
    moves() const override
    {
      return true;
    }
    void
    move(const LA::Vector &u) override;

    // Derivatives for the nodes that are not open, at the last move(). Collective.
    void
    differentiate(const NodeStates<dim> &states);
    bool
    is_differentiated(const NodeStates<dim> &states) const;

    // Open nodes with something opposite on faces that have closed ones.
    std::vector<unsigned int>
    neighbours(const NodeStates<dim> &states) const;

    double
    gap(const unsigned int k, const LA::Vector &) const override
    {
      return all[k].gap;
    }
    // Where the gap grows faster than the shape functions, beyond the edge of the contact, its projection on
    // to them is negative at some nodes: what does not penetrate on average is open.
    double
    open_gap(const unsigned int k, const LA::Vector &) const override
    {
      return is_opposite(k)
                 ? std::max(all[k].gap, interfaces[all[k].interface].coupling.rows[all[k].row].mean_gap)
                 : all[k].gap;
    }
    Tensor<1, dim>
    slip(const unsigned int k, const LA::Vector &u) const override; // see IncrementSlip
    double
    violation(const unsigned int k, const ContactStatus state, const LA::Vector &u) const override;
    // Without values: those that displacements obey are the written rows.
    std::vector<ContactEquation>
    equations(const unsigned int k, const ContactStatus state, const SlipLaw<dim> &law) const override;

    Coefficients
    gap_gradient(const unsigned int k) const override
    {
      return gradient(k).gap;
    }
    std::array<Coefficients, dim>
    slip_gradient(const unsigned int k, const LA::Vector &u) const override;

    // The equations of a closed node, linearised about u, to be written into the rows `pivots`. Slip: the gap
    // g closes, -dg = g. Stick: E = v - g/|normal| n = 0 by component.
    std::vector<ContactRow>
    contact_rows(const unsigned int                                         k,
                 const ContactStatus                                        state,
                 const std::vector<std::optional<types::global_dof_index>> &pivots,
                 const LA::Vector                                          &u) const;

    // Slave nodes that passed through the other side since then, see OldPartners.
    std::vector<Point<dim>>
    passed_through(const SolutionState<dim> &state) const
    {
      return old_partners.passed_through(interfaces, state);
    }
    std::vector<Point<dim>>
    entered() const
    {
      return old_partners.entered(interfaces);
    }

    // Their values alone, by component (slip: the first).
    Tensor<1, dim>
    row_values(const unsigned int k, const ContactStatus state, const LA::Vector &u) const;

    // Derivatives of the contact forces at fixed pressures and shears; by_penalty: those of sticking nodes,
    // too, turn with the surface. This rank's part.
    std::vector<LocalMatrix>
    stiffness(const NodeStates<dim>    &states,
              const NodalContacts<dim> &answers,
              const LA::Vector         &u,
              const bool                by_penalty = false) const;

    // Blocks that stiffness() and rows may have now or after a little sliding; without values. This rank's
    // part.
    std::vector<LocalMatrix>
    links() const;

  private:
    using Rows = std::array<Gradient, dim>; // by component
    Rows
    unit_normal_gradient(const unsigned int k) const;
    const RowGradient<dim> &
    gradient(const unsigned int k) const
    {
      return derivatives[all[k].interface]->rows()[differentiated[k]];
    }
    LocalMatrix
    turning_traction(const unsigned int       k,
                     const SlipLaw<dim>      &law,
                     const NodalContact<dim> &answer,
                     const LA::Vector        &u) const;

    using ContactKinematics<dim>::all;

    const Discretization<dim>                             &discretization;
    const Constraints                                     &supports;
    std::vector<ContactInterface<dim>>                    &interfaces;
    const double                                           scaling;
    std::vector<std::vector<unsigned int>>                 node_of; // by interface and slave node
    OldPartners<dim>                                       old_partners;
    double                                                 t; // of declared gaps
    IncrementSlip<dim>                                     slips;
    std::vector<std::unique_ptr<CouplingDerivatives<dim>>> derivatives; // by interface
    std::vector<unsigned int> differentiated;                           // by node: its row there, or invalid
  };
} // namespace Amontons

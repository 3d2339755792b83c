/// The contact nodes where the surfaces are: gaps, slips and what closed nodes ask of displacements.
#pragma once

#include <amontons/solver/contact_nodes.h>

namespace Amontons
{
  /// u: readable at relevant DoFs, as in the last move().
  template <int dim>
  class ContactKinematics
  {
  public:
    virtual ~ContactKinematics() = default;

    /// Whether surfaces follow the displacement; else everything is linear in it.
    virtual bool
    moves() const = 0;
    virtual void
    move(const LA::Vector &u) = 0;

    const std::vector<SlaveNode<dim>> &
    nodes() const
    {
      return all;
    }
    bool
    any_friction() const
    {
      return std::any_of(all.begin(), all.end(), [](const auto &node) { return node.frictional; });
    }
    /// Whether anything is opposite of the node.
    bool
    is_opposite(const unsigned int k) const
    {
      return all[k].row != numbers::invalid_unsigned_int;
    }

    virtual double
    gap(const unsigned int k, const LA::Vector &u) const = 0;
    /// That decides whether an open node closes.
    virtual double
    open_gap(const unsigned int k, const LA::Vector &u) const
    {
      return gap(k, u);
    }
    /// Since the last converged state. Of nodes with something opposite.
    virtual Tensor<1, dim>
    slip(const unsigned int k, const LA::Vector &u) const = 0;
    /// Distance of a closed node from its equations.
    virtual double
    violation(const unsigned int k, const ContactStatus state, const LA::Vector &u) const = 0;
    /// Of a closed node: what test functions obey, and what displacements (MovingContact: their increments)
    /// do.
    virtual std::vector<ContactEquation>
    equations(const unsigned int k, const ContactStatus state, const SlipLaw<dim> &law) const = 0;

    /// Derivatives of gap and slip (by component), of closed nodes.
    virtual Coefficients
    gap_gradient(const unsigned int k) const = 0;
    virtual std::array<Coefficients, dim>
    slip_gradient(const unsigned int k, const LA::Vector &u) const = 0;

  protected:
    std::vector<SlaveNode<dim>> all;
  };
} // namespace Amontons

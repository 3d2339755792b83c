// From contact states to affine constraints on displacements, and from residuals back to contact forces.
#pragma once

#include <amontons/base/linear_algebra.h>
#include <amontons/discretization/elimination.h>

#include <vector>

namespace Amontons
{
  // One scalar statement of a closed node: sum_d coefficient_d u_d = value, with multiplier mu: the contact
  // force on DoF d is -coefficient_d mu. `candidates`: the DoFs of the node, one of which is eliminated.
  // Friction: test functions v obey sum_d test_d v_d = 0 instead, and the force on DoF d is -test_d mu.
  // others: those of what is opposite, where a support of the node alone has all candidates, see
  // others_hold().
  struct ContactEquation
  {
    LinearEquation                       equation;
    std::vector<types::global_dof_index> candidates;
    Coefficients                         test   = {}; // empty: the coefficients of the equation
    std::vector<types::global_dof_index> others = {};

    const Coefficients &
    force_coefficients() const
    {
      return test.empty() ? equation.coefficients : test;
    }
  };

  // Supports keep the node from moving, and not what is opposite of it: that has to be held then. Where both
  // end at a support, it takes what would hold one of them to the other.
  bool
  others_hold(const ContactEquation &equation, const Constraints &supports);

  // Frictionless contact, tied interfaces and stick: trial and test functions obey the same constraints
  // (doc/introduction.md, (12)), and the condensed matrix is symmetric. Slip with
  // friction: both eliminate the same DoF, by different lines.
  class ContactConstraints
  {
  public:
    // Adds the equations to the supports, in their order, each eliminating the candidate with the largest
    // coefficient (friction: product of both) after substitution of what is eliminated already, or one of the
    // others. Equations without a pivot (the supports own the node) are left out: pivots() has no entry for
    // them.
    ContactConstraints(const Constraints &supports, const std::vector<ContactEquation> &equations);

    // What displacements obey.
    const Constraints &
    trial() const
    {
      return trial_constraints;
    }
    // What test functions obey: the same unless a node slips with friction.
    const Constraints &
    test() const
    {
      return symmetric ? trial_constraints : test_constraints;
    }
    const std::vector<std::optional<types::global_dof_index>> &
    pivots() const
    {
      return pivot_dofs;
    }

    // DoFs that recover_multipliers needs the residual of.
    const std::vector<ContactEquation> &
    equations() const
    {
      return contact_equations;
    }

    // Solves sum_c a_c,d mu_c = - r_d (doc/introduction.md, (13)) on the pivots d, where r = internal minus
    // external forces, condensed with the supports, and a_c the equations (of the test functions) after
    // substitution of the supports. residual_at_pivots: by equation (0 without pivot). Contact force on DoF
    // d: -a_c,d mu_c, so that mu > 0 pushes slave and master apart.
    std::vector<double>
    recover_multipliers(const std::vector<double> &residual_at_pivots) const;

  private:
    Constraints                  trial_constraints, test_constraints;
    bool                         symmetric;
    std::vector<ContactEquation> contact_equations; // after substitution of the supports
    std::vector<std::optional<types::global_dof_index>> pivot_dofs;
  };
} // namespace Amontons

/// Contact nodes at small strain: surfaces are coupled where they lie at the start.
#pragma once

#include <amontons/solver/contact_kinematics.h>
#include <amontons/solver/first_touch.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  /// Gaps and jumps are linear in the displacement, and closed nodes obey their equations exactly.
  template <int dim>
  class FixedContact : public ContactKinematics<dim>
  {
  public:
    /// start: slip is counted from its `committed` displacement (empty: from none), or from where a node that
    /// was open there touches.
    FixedContact(const Discretization<dim>                &discretization,
                 const Constraints                        &supports,
                 const std::vector<ContactInterface<dim>> &interfaces,
                 const SolutionState<dim>                 &start,
                 const double                              scaling)
        : origins(initialise(discretization, supports, interfaces, start, scaling))
    {
    }

    bool
    moves() const override
    {
      return false;
    }
    void
    move(const LA::Vector &) override
    {
    }
    double
    gap(const unsigned int k, const LA::Vector &u) const override
    {
      return all[k].gap - evaluate(all[k].closing.equation, u);
    }
    Tensor<1, dim>
    slip(const unsigned int k, const LA::Vector &u) const override
    {
      return all[k].tangential(all[k].jump(u) - origins[k]);
    }
    double
    violation(const unsigned int, const ContactStatus, const LA::Vector &) const override
    {
      return 0;
    }
    std::vector<ContactEquation>
    equations(const unsigned int k, const ContactStatus state, const SlipLaw<dim> &law) const override
    {
      return equations_of(all[k], state, law, origins[k]);
    }
    Coefficients
    gap_gradient(const unsigned int k) const override
    {
      Coefficients result = all[k].closing.equation.coefficients;
      for (auto &entry : result)
        entry.second *= -1;
      return result;
    }
    std::array<Coefficients, dim>
    slip_gradient(const unsigned int k, const LA::Vector &) const override
    {
      std::array<Coefficients, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          Tensor<1, dim> unit;
          unit[d]         = 1;
          const auto part = all[k].tangential(unit);
          for (unsigned int c = 0; c < dim; ++c)
            for (const auto &[dof, weight] : all[k].components[d].equation.coefficients)
              result[c][dof] += part[c] * weight;
        }
      return result;
    }

  private:
    using ContactKinematics<dim>::all;

    std::vector<Tensor<1, dim>>
    initialise(const Discretization<dim>                &discretization,
               const Constraints                        &supports,
               const std::vector<ContactInterface<dim>> &interfaces,
               const SolutionState<dim>                 &start,
               const double                              scaling)
    {
      all = collect_contact_nodes(discretization, interfaces, scaling);
      for (auto &node : all)
        node.wedged = node.frictional && is_wedged(node, supports);
      std::vector<Tensor<1, dim>> result(all.size());
      if (start.committed.size() == discretization.dof_handler.n_dofs())
        for (unsigned int k = 0; k < all.size(); ++k)
          if (all[k].frictional)
            result[k] = all[k].jump(start.committed);
      if (start.earlier.size() == discretization.dof_handler.n_dofs() && !start.committed_contact.empty())
        move_to_first_touch(start, result);
      return result;
    }

    // Open nodes go on as in the increment before until their gap is closed, or the increment ends:
    // doc/introduction.md, *Nodes that close on the way*.
    void
    move_to_first_touch(const SolutionState<dim> &start, std::vector<Tensor<1, dim>> &jumps) const
    {
      const double longer = (start.t - start.committed_t) / (start.committed_t - start.earlier_t);
      const bool   two    = start.before_earlier.size() == start.earlier.size();
      for (unsigned int k = 0; k < all.size(); ++k)
        if (const auto &node = start.committed_contact[all[k].interface][all[k].node];
            all[k].frictional && node.has_multiplier && node.state == ContactStatus::open)
          {
            const auto [before, earlier] =
                first_touch_weights(gap(k, start.committed),
                                    gap(k, start.earlier),
                                    two ? gap(k, start.before_earlier) : std::optional<double>(),
                                    longer);
            const auto now = jumps[k];
            jumps[k] += before * (all[k].jump(start.earlier) - now);
            if (earlier != 0)
              jumps[k] += earlier * (all[k].jump(start.before_earlier) - now);
          }
    }

    const std::vector<Tensor<1, dim>> origins; // jumps from which slip counts
  };
} // namespace Amontons

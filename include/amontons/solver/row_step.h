/// Newton's step at finite strain: the linearised equations of closed nodes are rows of the system.
#pragma once

#include <amontons/algebra/row_system.h>
#include <amontons/solver/active_set_lookahead.h>
#include <amontons/solver/moving_contact.h>
#include <amontons/solver/newton_step.h>
#include <amontons/solver/tangent_reuse.h>

namespace Amontons
{
  /// Bodies, loads and surfaces are linearised where they are; multipliers are those of the iterate, and test
  /// functions of closed nodes leave the rows that their equations are written into. Supports hold what they
  /// prescribe from the first step on, and the bodies follow in the linear way.
  template <int dim>
  class RowStep : public NewtonStep<dim>
  {
  public:
    using typename NewtonStep<dim>::Solved;

    /// contact: that of the problem.
    RowStep(const ContactEquilibrium<dim> &problem, MovingContact<dim> &contact, const double smallest_cell);

    const Constraints &
    supports() const override
    {
      return homogeneous;
    }
    void
    prepare(const LA::Vector *springs) override;
    void
    linearise(Iterate<dim> &now, const LA::Vector *springs, const Drag *drag) override;
    Solved
    solve(const Iterate<dim> &now, const Drag *drag) override;
    /// Without friction, in the plane, where the set keeps changing near equilibrium: thin bodies that come
    /// to lie on something let go node by node.
    unsigned int
    look_ahead(Iterate<dim> &now, const std::vector<ContactStatus> &before, const double rounding) override;
    std::function<bool(LA::Vector &y, const LA::Vector &force)>
    inverse() override;

  private:
    bool
    looks_ahead(const Iterate<dim> &now) const;
    NodalContacts<dim>
    respond(const Iterate<dim> &now, const BaseSolution<dim> &base, const unsigned int k);
    LA::Vector
    forces_of(const LA::Vector &x) const;
    bool
    is_iterative() const;
    bool
    system_serves_again(const Iterate<dim> &now) const;
    bool
    tangent_serves_again(const Iterate<dim> &now) const;
    void
    differentiate(Iterate<dim> &now);
    std::vector<std::optional<types::global_dof_index>>
    pivots_of(const Iterate<dim> &now, const unsigned int k) const;
    void
    write_rows(const Iterate<dim> &now);
    void
    update_rows(const Iterate<dim> &now);
    LA::Vector
    prescribed_change(const Iterate<dim> &now) const;
    double
    linear_tolerance(const Iterate<dim> &now, const LA::Vector &rhs) const;

    const ContactEquilibrium<dim>      &problem;
    MovingContact<dim>                 &contact;
    const Constraints                   homogeneous; // supports
    RowSystem                           system;
    LinearSolver                        solver; // refers to the matrix, which must outlive it
    TangentReuse                        tangent;
    std::vector<LocalMatrix>            further; // of contact and loads
    std::vector<ContactRow>             rows;
    std::shared_ptr<ContactConstraints> assembled; // constraints of the matrix
    bool                                has_drag = false;
  };
} // namespace Amontons

/// Newton's step at small strain: closed nodes are eliminated from the system.
#pragma once

#include <amontons/algebra/eliminated_system.h>
#include <amontons/solver/contact_compliance.h>
#include <amontons/solver/newton_step.h>

namespace Amontons
{
  /// Moves on to the constraints of the closed nodes, then solves for the homogeneous increment:
  ///   C~^T K C du = C~^T (loads - K u),
  /// doc/introduction.md, (16): symmetric without friction. Only rows of closed nodes change with the set, so
  /// that the bulk of the matrix and a factorisation serve again.
  template <int dim>
  class EliminatedStep : public NewtonStep<dim>
  {
  public:
    using typename NewtonStep<dim>::Solved;

    explicit EliminatedStep(const ContactEquilibrium<dim> &problem);

    const Constraints &
    supports() const override
    {
      return problem.supports;
    }
    void
    prepare(const LA::Vector *springs) override;
    void
    linearise(Iterate<dim> &now, const LA::Vector *springs, const Drag *drag) override;
    Solved
    solve(const Iterate<dim> &now, const Drag *drag) override;

    /// Plane problems with friction and a direct solver.
    unsigned int
    look_ahead(Iterate<dim> &now, const std::vector<ContactStatus> &before, const double rounding) override;

    /// Plane problems with friction and a direct solver.
    bool
    settle(Iterate<dim> &now, const LA::Vector *springs) override;

    /// Of the displacement of the state, with the constraints of the last linearise(): the largest |lambda|
    /// of K_sigma v = lambda K v, what the stress adds to the stiffness against the stiffness, in the space
    /// of a few steps of Lanczos' method: -1 where the bodies buckle, much where strings are taut.
    /// most_strain: see geometric_forces(). Collective.
    double
    stress_stiffening(const Iterate<dim> &now, const double most_strain);

  private:
    ContactCompliance<dim>
    compliance(const Iterate<dim> &at, const BaseSolution<dim> &base);
    Iterate<dim>
    with_open_nodes(const Iterate<dim> &now, const LA::Vector *springs);
    double
    forcing(const Iterate<dim> &now) const;
    double
    fine_tolerance() const;
    std::vector<LocalMatrix>
    stiffness_of_contact(const Iterate<dim> &now) const;
    bool
    looks_ahead(const Iterate<dim> &now) const;
    std::vector<bool>
    movable_nodes() const;
    std::vector<ShearBound>
    linear_bounds(const Iterate<dim> &now) const;
    unsigned int
    pivot(Iterate<dim> &now, const std::vector<ContactStatus> &before);

    const ContactEquilibrium<dim> &problem;
    const bool                     any_friction;
    EliminatedSystem               system;
    LinearSolver                   solver; // its factorisation refers to the matrix, which must outlive it
    bool                           looked_in_vain = false;
    unsigned int                   n_pivoted      = 0; // see pivot()
  };
} // namespace Amontons

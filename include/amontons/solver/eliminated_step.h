/// Newton's step at small strain: closed nodes are eliminated from the system.
#pragma once

#include <amontons/solver/contact_compliance.h>
#include <amontons/solver/kept_system.h>

namespace Amontons
{
  /// Moves on to the constraints of the closed nodes, then solves for the homogeneous increment:
  ///   C~^T K C du = C~^T (loads - K u),
  /// doc/introduction.md, (16): symmetric without friction. Only rows of closed nodes change with the set, so
  /// that the bulk of the matrix and a factorisation serve again, from one increment to the next, too.
  /// Plane problems with friction and a direct solver: as long as states are near those that the factors
  /// belong to (the base), the solution is (18), and no system is made.
  template <int dim>
  class EliminatedStep : public NewtonStep<dim>
  {
  public:
    using typename NewtonStep<dim>::Solved;

    /// kept: of this mesh, from the steps before.
    EliminatedStep(const ContactEquilibrium<dim> &problem, KeptSystem<dim> &kept);

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
    struct Push
    {
      LA::Vector condensed;
      double     internal; // norm of the internal forces
    };

    void
    assemble(const Iterate<dim> &now);
    bool
    is_near_base(const Iterate<dim> &now);
    void
    find_base(const Iterate<dim> &now);
    Push
    push_at(const Iterate<dim> &now, LA::Vector &moved) const;
    std::optional<Solved>
    solve_by_base(const Iterate<dim> &now);
    ContactCompliance<dim>
    compliance(const Iterate<dim> &at, const BaseSolution<dim> &from) const;
    BaseSolution<dim>
    base_solution(const std::vector<ContactStatus> &states,
                  const std::vector<SlipLaw<dim>>  &laws,
                  const Iterate<dim>               &at) const;
    ActiveSetLookahead<dim>
    condensed(const BaseSolution<dim> &from);
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
    std::vector<ShearBound>
    linear_bounds(const Iterate<dim> &now) const;
    unsigned int
    pivot(Iterate<dim> &now, const std::vector<ContactStatus> &before);

    const ContactEquilibrium<dim> &problem;
    const bool                     any_friction;
    const std::vector<bool>        movable; // by node, see BaseSolution
    KeptSystem<dim>               &kept;
    const LA::Vector              *springs = nullptr; // of the last linearise()
    std::optional<Iterate<dim>>    base;              // with the states of the matrix, at the present loads
    bool                           by_base        = false;
    bool                           looked_in_vain = false;
    unsigned int                   n_pivoted      = 0; // see pivot()
  };
} // namespace Amontons

/// What the solves on one mesh have in common at small strain.
#pragma once

#include <amontons/algebra/eliminated_system.h>
#include <amontons/solver/active_set_lookahead.h>
#include <amontons/solver/newton_step.h>

namespace Amontons
{
  /// The condensed system with its factors, and what the contact nodes have answered by them. From one
  /// increment to the next loads, gaps and origins of slip change: right hand sides.
  template <int dim>
  class KeptSystem
  {
  public:
    /// The pattern and the bulk of the matrix, unless they are there: springs are those that there may be on
    /// the diagonal (null: none). What belongs to other bodies or surfaces is lost. Collective.
    void
    prepare(const ContactEquilibrium<dim> &problem, const LA::Vector *springs);
    /// For the states and laws of `now`; further: see EliminatedSystem.
    void
    assemble(const ContactEquilibrium<dim>  &problem,
             const Iterate<dim>             &now,
             const LA::Vector               *springs,
             const std::vector<LocalMatrix> &further);
    /// The matrix may be that of anything.
    void
    forget_states();

    bool
    has_states() const
    {
      return !states.empty();
    }
    /// Where they are not those of the matrix.
    unsigned int
    n_other_states(const NodeStates<dim> &now) const;
    /// Collective.
    bool
    has_springs(const LA::Vector *others) const;

    std::unique_ptr<EliminatedSystem> system;
    std::unique_ptr<LinearSolver>     solver; // its factorisation refers to the matrix, which must outlive it
    std::vector<ContactStatus>        states; // of the matrix, by contact node
    std::vector<SlipLaw<dim>>         laws;
    Responses<dim>                    responses; // of contact nodes, by the factors of this matrix

  private:
    std::optional<std::size_t> fingerprint; // of all that prepare() has read
    LA::Vector                 springs;     // in the matrix; empty: none
  };
} // namespace Amontons

// Responses of the contact nodes to inputs at single ones, by solving the system that is there.
#pragma once

#include <amontons/algebra/linear_solver.h>
#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/solver/active_set_lookahead.h>

namespace Amontons
{
  // Multipliers of the equations, from what internal minus external forces are.
  std::vector<double>
  multipliers_of(const LA::Vector         &unbalanced,
                 const Constraints        &supports,
                 const ContactConstraints &constraints);

  // With the test and trial functions C~ and C of the base and an input that moves the constraints by w_0 or
  // adds the forces f, the bodies move by
  //
  //   w = w_0 + C dw,   C~^T K C dw = C~^T (f - K w_0),
  //
  // and the multipliers follow from K w - f as in the base.
  template <int dim>
  class ContactCompliance
  {
  public:
    // solver: has solved with `matrix`, the system of the base. first_equation: of each closed node in
    // `constraints`.
    ContactCompliance(const Discretization<dim>       &discretization,
                      const ElasticityOperator<dim>   &elasticity,
                      const Constraints               &supports,
                      const ContactConstraints        &constraints,
                      const std::vector<unsigned int> &first_equation,
                      const BaseSolution<dim>         &base,
                      const LA::SparseMatrix          &matrix,
                      LinearSolver                    &solver);

    // motion (may be null): of the bodies, w.
    NodalContacts<dim>
    respond(const unsigned int node, const NodeInput input, LA::Vector *motion = nullptr) const;

  private:
    LA::Vector
    displacement_of(const unsigned int node, const Tensor<1, dim> &jump) const;
    LA::Vector
    force_of(const unsigned int node, const Tensor<1, dim> &traction) const;
    LA::Vector
    internal_forces(const LA::Vector &w) const;
    NodalContacts<dim>
    answers(const LA::Vector &offset, const LA::Vector &force, LA::Vector *motion) const;
    NodalContact<dim>
    answer(const unsigned int node, const LA::Vector &w, const std::vector<double> &mu) const;

    const Discretization<dim>       &discretization;
    const ElasticityOperator<dim>   &elasticity;
    const Constraints               &supports;
    const ContactConstraints        &constraints;
    const std::vector<unsigned int> &first_equation;
    const BaseSolution<dim>         &base;
    const LA::SparseMatrix          &matrix;
    LinearSolver                    &solver;
    // Equations that a pivot stands in, with its coefficient.
    std::map<types::global_dof_index, std::vector<std::pair<unsigned int, double>>> equations_of_pivot;
  };
} // namespace Amontons

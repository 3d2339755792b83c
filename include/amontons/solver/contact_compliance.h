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
  // and the multipliers follow from K w - f as in the base. Of K the rows and columns of pivots are needed
  // only, with what hangs on them: few cells have these.
  template <int dim>
  class ContactCompliance
  {
  public:
    // solver: has solved with `matrix`, the system of the base. first_equation: of each closed node in
    // `constraints`. Collective, as all of it.
    ContactCompliance(const Discretization<dim>       &discretization,
                      const ElasticityOperator<dim>   &elasticity,
                      const Constraints               &supports,
                      const ContactConstraints        &constraints,
                      const std::vector<unsigned int> &first_equation,
                      const BaseSolution<dim>         &base,
                      const LA::SparseMatrix          &matrix,
                      LinearSolver                    &solver);

    // What all nodes answer to a unit of each input.
    std::vector<NodalContacts<dim>>
    respond(const std::vector<ContactInput> &inputs) const;

    // How the bodies move, w, by so much of each input.
    LA::Vector
    motion(const std::map<ContactInput, double> &inputs) const;

  private:
    struct Load
    {
      Coefficients offset, force; // w_0 and f
    };

    void
    add(const ContactInput &input, const double factor, Load &load) const;
    void
    add_offset(const unsigned int node, const Tensor<1, dim> &jump, Coefficients &offset) const;
    void
    add_force(const unsigned int node, const Tensor<1, dim> &traction, Coefficients &force) const;
    // dw of each, w_0 and what the constraints make of it added.
    std::vector<LA::Vector>
    motions(const std::vector<Load> &loads) const;
    NodalContacts<dim>
    answers(const Load &load, const LA::Vector &w) const;
    NodalContact<dim>
    answer(const unsigned int node, const LA::Vector &w, const std::vector<double> &mu) const;
    void
    set(const Coefficients &values, LA::Vector &owned) const;
    // Forces of the shear across the slip, of nodes that slip in the base; w readable.
    void
    add_shear_stiffness(const LA::Vector &w, LA::Vector &unbalanced) const;

    const Discretization<dim>       &discretization;
    const ElasticityOperator<dim>   &elasticity;
    const ContactConstraints        &constraints;
    const std::vector<unsigned int> &first_equation;
    const BaseSolution<dim>         &base;
    const LA::SparseMatrix          &matrix;
    LinearSolver                    &solver;
    // Equations that a pivot stands in, with its coefficient; DoFs that supports make of it, with their
    // weight.
    std::map<types::global_dof_index, std::vector<std::pair<unsigned int, double>>> equations_of_pivot;
    std::map<types::global_dof_index, Coefficients>                                 hanging_on_pivot;
    std::vector<unsigned int>                                                       cells_at_pivots;
    mutable LA::Vector                                                              readable;
  };
} // namespace Amontons

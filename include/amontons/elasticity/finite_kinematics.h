// Deformation of one cell at finite strain, with the mean-dilatation projection against locking.
#pragma once

#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // F = I + Grad u at the quadrature points, always 3x3: F_33 = 1 in plane strain (and here in plane stress),
  // 1 + u_r/R in axisymmetry.
  //
  // Mean dilatation (Simo, Taylor and Pister 1985): the law sees
  //   F_bar = (theta/J)^(1/3) F,  theta = P J,
  // whose determinant theta is J projected on to what the pressure can carry. At u = 0 its derivative is the
  // strain of StrainOperator. Plane stress needs none: theta = J there.
  //
  // On the way to a solution theta may be another polynomial: the excess P J - theta is what it lacks.
  // Inside, all of this is kept as what it differs from 1 by, so that tiny strains keep their digits.
  template <int dim>
  class FiniteKinematics
  {
  public:
    FiniteKinematics(const FiniteElement<dim> &fe, const ProblemType kind);

    // Values as for StrainOperator; u on the cell's degrees of freedom; theta: coefficients of theta - 1, or
    // null for P J.
    // Returns the smallest det F or theta (or not a number), 0 for less than a millionth; unless that is
    // positive, nothing below holds.
    double
    reinit(const FEValues<dim> &values, const std::vector<double> &u, const double *theta = nullptr);

    unsigned int
    n_points() const
    {
      return weights.size();
    }
    double
    weight(const unsigned int q) const // JxW times measure, in the reference configuration
    {
      return weights[q];
    }
    double
    jacobian(const unsigned int q) const
    {
      return 1 + volume_changes[q];
    }
    double
    dilatation(const unsigned int q) const // theta
    {
      return 1 + dilatations[q];
    }

    // e = F_bar F_bar^T - I
    SymmetricTensor<2, 3>
    strain(const unsigned int q) const;

    // Of the scalar shape functions, row q dim + d: d/dx_d at point q in the current configuration.
    const FullMatrix<double> &
    gradients() const
    {
      return spatial_gradients;
    }
    // Axisymmetric: N_m/r at point q, with the current r; else zero.
    double
    hoop(const unsigned int m, const unsigned int q) const
    {
      return hoops.empty() ? 0. : hoops[q * n_nodes + m];
    }

    // Coefficients of theta - 1 and of P J - theta; values of the latter at the points.
    const std::vector<double> &
    dilatation() const
    {
      return theta_coefficients;
    }
    const std::vector<double> &
    excess() const
    {
      return excess_coefficients;
    }
    void
    evaluate_excess(std::vector<double> &values) const
    {
      projection.evaluate(excess_coefficients.data(), values);
    }

    // P of every column; P of one.
    void
    project(FullMatrix<double> &f)
    {
      projection.apply(f);
    }
    void
    project(std::vector<double> &f)
    {
      projection.apply(f);
    }
    const FullMatrix<double> &
    coefficients_of_columns() const
    {
      return projection.coefficients_of_columns();
    }

    // Shape function of the cell with component c at node m.
    unsigned int
    index(const unsigned int c, const unsigned int m) const
    {
      return indices[c][m];
    }

    const ProblemType  kind;
    const unsigned int n_nodes; // of the scalar element

  private:
    Tensor<2, 3>
    displacement_gradient(const FEValues<dim> &values, const unsigned int q, const std::vector<double> &u);
    void
    push_forward(const FEValues<dim> &values, const unsigned int q);
    void
    set_dilatations(const FEValues<dim> &values, const double *theta);

    std::array<std::vector<unsigned int>, dim> indices;

    std::vector<Tensor<2, 3>> displacement;                // F - I
    std::vector<double>       volume_changes, dilatations; // J - 1, theta - 1
    std::vector<double>       weights, hoops, theta_coefficients, excess_coefficients;
    FullMatrix<double>        spatial_gradients;
    PressureProjection<dim>   projection;
  };
} // namespace Amontons

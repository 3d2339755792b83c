// Strains of the shape functions in Voigt form, with the mean-dilatation projection against locking.
#pragma once

#include <amontons/scene/scene.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>

namespace Amontons
{
  using namespace dealii;

  // Components: 2D kinds xx, yy, zz, xy (axisymmetric: rr, zz, hoop, rz); 3D xx, yy, zz, xy, xz, yz. Shears
  // are engineering strains.
  template <int dim>
  constexpr unsigned int n_voigt = dim == 2 ? 4 : 6;

  template <int dim>
  using Voigt = std::array<double, n_voigt<dim>>;

  // int f dx of a cell becomes sum_q f JxW measure(q): 2 pi r in axisymmetric scenes (full turn), else 1.
  template <int dim>
  double
  measure(const ProblemType kind, const Point<dim> &X)
  {
    return kind == ProblemType::axisymmetric ? 2 * numbers::PI * X[0] : 1.;
  }

  // L2 projection P in a cell, in the weight of the kind, on to the polynomials that the pressure can carry:
  // constants for Q1 and span{1, x, y(, z)} for Q2 (inf-sup stable pairs Q1/P0 in practice, Q2/P1disc).
  template <int dim>
  class PressureProjection
  {
  public:
    // weights: JxW times measure
    void
    reinit(const FEValues<dim> &values, const std::vector<double> &weights);

    // From values at the quadrature points to those of the projection.
    void
    apply(std::vector<double> &f);
    // The same for every column.
    void
    apply(FullMatrix<double> &f);

    // In terms of coefficients of the polynomials: of P f, of the columns that apply() had, and back to
    // values at the points.
    static unsigned int
    n_coefficients(const unsigned int degree)
    {
      return degree == 1 ? 1 : dim + 1;
    }
    const Vector<double> &
    project(const std::vector<double> &f);
    const FullMatrix<double> &
    coefficients_of_columns() const
    {
      return coefficients;
    }
    void
    evaluate(const double *coefficients, std::vector<double> &f) const;

  private:
    FullMatrix<double> polynomials, weighted, inverse_mass, moments, coefficients; // rows: points
    Vector<double>     moment, coefficient;
  };

  // Strain operator of one cell at all quadrature points: B[q][i] = strain of shape function i of the
  // vector-valued element.
  //
  // Mean dilatation: div v is replaced by its projection,
  //   B_bar = B + 1/3 (P div - div) (1, 1, 1, 0, ...)   (doc/introduction.md, (29)).
  // For nu = 0.3 it changes results by less than the discretisation error (doc/results), so it is always on;
  // plane stress needs none.
  template <int dim>
  class StrainOperator
  {
  public:
    StrainOperator(const FiniteElement<dim> &fe, const ProblemType kind);

    // values: update_values | update_gradients | update_quadrature_points | update_JxW_values, reinited on
    // the cell.
    void
    reinit(const FEValues<dim> &values);

    const Voigt<dim> &
    strain(const unsigned int i, const unsigned int q) const
    {
      return B[q * n_dofs + i];
    }
    double
    weight(const unsigned int q) const
    {
      return weights[q];
    } // JxW times measure

  private:
    void
    project_dilatation(const FEValues<dim> &values);

    const ProblemType         kind;
    const unsigned int        n_dofs;
    std::vector<Voigt<dim>>   B;
    std::vector<double>       weights;
    PressureProjection<dim>   projection;
    std::vector<unsigned int> component; // of shape function i
  };
} // namespace Amontons

// Areas that tractions are given by, where those of stresses are others.
#pragma once

#include <amontons/discretization/discretization.h>
#include <amontons/elasticity/hyperelastic.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  // At finite strain tractions of tied surfaces are per reference area, and in plane stress those of all
  // surfaces per thickness before deformation, but stresses are Cauchy's. With H = Grad u, F = I + H and the
  // stretch l of the thickness (1 but in plane stress), where sigma n is a traction per current area,
  //   sigma m,  m = l J F^-T N  (tied, N: the reference normal),  m = l n  (else, n: the current one),
  // is one of the kind that multipliers have.
  template <int dim>
  class NominalArea
  {
  public:
    // At points of the unit cell. displacement: readable at relevant DoFs.
    NominalArea(const Discretization<dim>     &discretization,
                const std::vector<Point<dim>> &points,
                const LA::Vector              &displacement);

    void
    reinit(const typename DoFHandler<dim>::active_cell_iterator &cell);

    // m at point q; normal: N or n.
    Tensor<1, dim>
    vector(const unsigned int q, const Tensor<1, dim> &normal, const bool tied) const;

  private:
    const Discretization<dim>   &discretization;
    const LA::Vector            &displacement;
    FEValues<dim>                values;
    std::vector<Tensor<2, dim>>  gradients; // H
    std::vector<Tensor<1, dim>>  motions;   // u, in axisymmetric scenes
    std::vector<HyperelasticLaw> laws;      // by body
    unsigned int                 body = 0;
  };
} // namespace Amontons

// Dry friction at one node: the shear traction q = q_t d on the master, along the slip d of the slave, is at
// most phi(p), and equal to it where the node slips. Tensors only.
#pragma once

#include <amontons/scene/scene.h>

namespace Amontons
{
  // phi = min(mu p, s) of doc/introduction.md, (14), and its derivative by p, at a pressure p >= 0.
  struct ShearBound
  {
    double value = 0, slope = 0;
  };

  ShearBound
  shear_bound(const PairData &pair, const Point<3> &X, const double t, const double pressure);

  // Throws InputError where an expression of the bound is negative: on the way to a solution it is taken for
  // 0 there, as the pressures may be anything.
  void
  refuse_negative_bound(const PairData &pair, const Point<3> &X, const double t, const double pressure);

  // The law of a slipping node, linearised (doc/introduction.md, (17)): q = (constant + slope p) d +
  // stiffness (1 - d d^T) v, where v is the slip (tangential, like d). Unsymmetric where slope > 0.
  template <int dim>
  struct SlipLaw
  {
    Tensor<1, dim> direction; // d, unit
    double         constant = 0, slope = 0;
    double         stiffness = 0; // 3D only

    Tensor<1, dim>
    traction(const double pressure, const Tensor<1, dim> &slip) const;
  };

  // Semismooth Newton step of |trial| q = phi(p) trial, trial = q + c v with any c > 0. In 2D the direction
  // of the trial traction is all that it takes. In 3D the derivative of d = trial/|trial| remains, which
  // after elimination of the change of q across d leaves the stiffness phi c/(|trial| - phi) = phi/|v| across
  // d; it is capped where the node hardly slips (the solution does not depend on the stiffness).
  template <int dim>
  SlipLaw<dim>
  linearise_slip(const Tensor<1, dim> &trial, const double pressure, const ShearBound &bound, const double c);
} // namespace Amontons

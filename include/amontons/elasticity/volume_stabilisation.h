/// What keeps elements of degree 2 stable where nearly incompressible bodies are compressed by a third and
/// more.
#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace Amontons
{
  /// The law sees theta = P J alone (finite_kinematics.h): volumes that the projection does not see cost
  /// nothing, and under pressure their second variation, pi ((tr A)^2 - tr A^2) with pi < 0, is negative. A
  /// homogeneous block (plane strain, nu = 0.4999, frictionless ends) becomes unstable at a stretch of 0.65
  /// on any mesh, where Biot's condition says 0.542. (Stable pairs of the linear problem may fail at finite
  /// strain: Auricchio, Beirao da Veiga, Lovadina, Reali, Comput. Methods Appl. Mech. Eng. 194 (2005) 1075.)
  /// To the energy is added, at each point,
  ///
  ///   W_s = m/2 phi r^2,   r = J/theta - 1,   phi = tr (J^(-2/3) b) - 3 >= 0:
  ///
  /// the penalty of r^2 makes that block stable down to 0.53 with m = mu (grad-div stabilisation does the
  /// same for the Stokes equations); in space, where cells are longer in the direction that is held than in
  /// the others, m = mu is stable to 0.75 only and m = 2 mu to 0.57 at least, which is taken. phi leaves
  /// small strain as it is: W_s goes with the fourth power of the strain. It vanishes with the mesh, r being
  /// of the order of the element.
  struct VolumeStabilisation
  {
    /// mu: shear modulus; dilatation: theta; strain: b_bar - I.
    VolumeStabilisation(const double                         mu,
                        const double                         jacobian,
                        const double                         dilatation,
                        const dealii::SymmetricTensor<2, 3> &strain)
        : m(2 * mu), ratio(jacobian / dilatation), r((jacobian - dilatation) / dilatation),
          unimodular(std::pow(dilatation, -2. / 3) * (dealii::unit_symmetric_tensor<3>() + strain)),
          phi(trace(unimodular) - 3)
    {
    }

    double
    energy() const
    {
      return m / 2 * phi * r * r;
    }
    /// Of the shear stress m r^2 dev unimodular.
    double
    shear() const
    {
      return m * r * r;
    }
    /// s = J dW_s/dJ at constant theta and phi; theta dW_s/dtheta = -s.
    double
    pressure() const
    {
      return m * phi * r * ratio;
    }

    const double                        m, ratio, r; // ratio: J/theta; r: less 1
    const dealii::SymmetricTensor<2, 3> unimodular;  // J^(-2/3) b = theta^(-2/3) b_bar
    const double                        phi;
  };
} // namespace Amontons

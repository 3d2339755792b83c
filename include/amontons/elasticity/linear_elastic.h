// Isotropic linear elasticity, small strain.
#pragma once

#include <amontons/elasticity/kinematics.h>

namespace Amontons
{
  // sigma = lambda tr(eps) I + 2 mu eps (doc/introduction.md, (1)). Plane stress: lambda is replaced by 2
  // lambda mu / (lambda + 2 mu) and sigma_zz = 0; eps_zz of the argument is ignored.
  template <int dim>
  struct LinearElastic
  {
    LinearElastic(const MaterialData &material, const ProblemType kind);

    Voigt<dim>
    stress(const Voigt<dim> &strain) const;

    double lambda, mu;
    bool   plane_stress;
    double poisson;
  };

  // Bulk stiffness scale of the material: the plane-strain modulus E / (1 - nu^2).
  double
  contact_modulus(const MaterialData &material);

  template <int dim>
  double
  von_mises(const Voigt<dim> &stress);

  // sigma : C^-1 : sigma = ((1 + nu) sigma : sigma - nu (tr sigma)^2) / E, in plane stress as well, as
  // sigma_zz = 0 there.
  template <int dim>
  double
  complementary_energy(const Voigt<dim> &sigma, const MaterialData &material);

  // sigma n of a stress; in the plane kinds zz takes no part.
  template <int dim>
  Tensor<1, dim>
  times_vector(const Voigt<dim> &sigma, const Tensor<1, dim> &n)
  {
    Tensor<2, dim> tensor;
    for (unsigned int d = 0; d < dim; ++d)
      tensor[d][d] = sigma[d];
    for (unsigned int i = 0, k = 3; i < dim; ++i)
      for (unsigned int j = i + 1; j < dim; ++j, ++k)
        tensor[i][j] = tensor[j][i] = sigma[k];
    return tensor * n;
  }
} // namespace Amontons

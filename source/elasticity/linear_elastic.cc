#include <amontons/elasticity/linear_elastic.h>

namespace Amontons
{
  template <int dim>
  LinearElastic<dim>::LinearElastic(const MaterialData &material, const ProblemType kind)
      : plane_stress(kind == ProblemType::plane_stress), poisson(material.poisson)
  {
    const double E = material.young, nu = material.poisson;
    mu     = E / (2 * (1 + nu));
    lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    if (plane_stress)
      lambda = 2 * lambda * mu / (lambda + 2 * mu);
  }

  template <int dim>
  Voigt<dim>
  LinearElastic<dim>::stress(const Voigt<dim> &strain) const
  {
    Voigt<dim>   sigma;
    const double pressure = lambda * (strain[0] + strain[1] + (plane_stress ? 0 : strain[2]));
    for (unsigned int k = 0; k < 3; ++k)
      sigma[k] = pressure + 2 * mu * strain[k];
    if (plane_stress)
      sigma[2] = 0;
    for (unsigned int k = 3; k < n_voigt<dim>; ++k)
      sigma[k] = mu * strain[k];
    return sigma;
  }

  double
  contact_modulus(const MaterialData &material)
  {
    return material.young / (1 - material.poisson * material.poisson);
  }

  template <int dim>
  double
  von_mises(const Voigt<dim> &s)
  {
    double shear = 0;
    for (unsigned int k = 3; k < n_voigt<dim>; ++k)
      shear += s[k] * s[k];
    return std::sqrt(0.5 * ((s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) +
                            (s[2] - s[0]) * (s[2] - s[0])) +
                     3 * shear);
  }

  template <int dim>
  double
  complementary_energy(const Voigt<dim> &sigma, const MaterialData &material)
  {
    double square = 0, trace = 0;
    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      square += (k < 3 ? 1 : 2) * sigma[k] * sigma[k];
    for (unsigned int k = 0; k < 3; ++k)
      trace += sigma[k];
    return ((1 + material.poisson) * square - material.poisson * trace * trace) / material.young;
  }

  template struct LinearElastic<2>;
  template struct LinearElastic<3>;
  template double
  von_mises<2>(const Voigt<2> &);
  template double
  von_mises<3>(const Voigt<3> &);
  template double
  complementary_energy<2>(const Voigt<2> &, const MaterialData &);
  template double
  complementary_energy<3>(const Voigt<3> &, const MaterialData &);
} // namespace Amontons

// Laws of finite strain at a point: stress is the derivative of the energy, the tangent that of the stress,
// uniaxial tension, simple shear and equibiaxial tension have their closed forms, and tiny strains keep their
// digits.
#include "check.h"

#include <amontons/elasticity/hyperelastic.h>

#include <random>

namespace test_hyperelastic
{
using namespace Amontons;

namespace
{
  const double E = 7;

  HyperelasticLaw
  law_of(const Law law, const double nu)
  {
    MaterialData material;
    material.young   = E;
    material.poisson = nu;
    material.law     = law;
    return make_law(material);
  }

  std::mt19937 generator(1);

  Tensor<2, 3>
  random_tensor(const double size)
  {
    std::uniform_real_distribution<double> random(-size, size);
    Tensor<2, 3>                           t;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        t[i][j] = random(generator);
    return t;
  }

  // b - I
  SymmetricTensor<2, 3>
  strain_of(const Tensor<2, 3> &F)
  {
    return symmetrize(F * transpose(F)) - unit_symmetric_tensor<3>();
  }

  Voigt<3>
  engineering(const Tensor<2, 3> &L)
  {
    Voigt<3> e;
    for (unsigned int k = 0; k < 6; ++k)
      {
        const auto [i, j] = voigt_indices[k];
        e[k]              = i == j ? L[i][i] : L[i][j] + L[j][i];
      }
    return e;
  }

  Tensor<2, 3>
  as_tensor(const Voigt<3> &v)
  {
    Tensor<2, 3> t;
    for (unsigned int k = 0; k < 6; ++k)
      {
        const auto [i, j] = voigt_indices[k];
        t[i][j] = t[j][i] = v[k];
      }
    return t;
  }

  // Fourth-order central difference at 0.
  double
  derivative(const std::function<double(double)> &f)
  {
    const double h = 1e-3;
    return (f(-2 * h) - 8 * f(-h) + 8 * f(h) - f(2 * h)) / (12 * h);
  }

  // Along F(s) = (I + s L) F:  dW/ds = tau:L,  d tau/ds = c:sym L + L tau + tau L^T
  void
  check_derivatives(const HyperelasticLaw &law, const std::string &name)
  {
    const auto I = Tensor<2, 3>(unit_symmetric_tensor<3>());
    for (unsigned int sample = 0; sample < 5; ++sample)
      {
        const Tensor<2, 3> F = I + random_tensor(0.3), L = random_tensor(1);
        const auto         e      = [&](const double s) { return strain_of((I + s * L) * F); };
        const Voigt<3>     stress = kirchhoff_stress(law, e(0)), rate = engineering(L);
        const auto         tangent = spatial_tangent(law, e(0));
        const Tensor<2, 3> tau = as_tensor(stress), rotated = L * tau + tau * transpose(L);
        double             power = 0;
        for (unsigned int k = 0; k < 6; ++k)
          {
            const auto [i, j] = voigt_indices[k];
            power += stress[k] * rate[k];
            double expected = rotated[i][j], scale = std::abs(expected);
            for (unsigned int l = 0; l < 6; ++l)
              {
                expected += tangent[k][l] * rate[l];
                scale = std::max(scale, std::abs(tangent[k][l]));
              }
            check::is_close(derivative([&](const double s) { return kirchhoff_stress(law, e(s))[k]; }),
                            expected,
                            1e-8,
                            name + ": derivative of the stress",
                            scale);
          }
        check::is_close(derivative([&](const double s) { return energy(law, e(s)); }),
                        power,
                        1e-8,
                        name + ": derivative of the energy",
                        tau.norm());
      }
  }

  // The same in the plane, the thickness following.
  void
  check_plane_stress(const HyperelasticLaw &law, const std::string &name)
  {
    const auto in_plane = [](Tensor<2, 3> t) {
      for (unsigned int i = 0; i < 3; ++i)
        t[i][2] = t[2][i] = 0;
      return t;
    };
    const auto         I = Tensor<2, 3>(unit_symmetric_tensor<3>());
    const Tensor<2, 3> F = I + in_plane(random_tensor(0.3)), L = in_plane(random_tensor(1));
    const auto         e = [&](const double s) {
      auto result  = strain_of((I + s * L) * F);
      result[2][2] = thickness_strain(law, result);
      return result;
    };
    const Voigt<3> stress = kirchhoff_stress(law, e(0)), rate = engineering(L);
    check::is_close(stress[2], 0, 1e-13, name + ": no stress along the thickness", E / (1 - 2 * 0.4999));
    const auto         tangent = condense_thickness(spatial_tangent(law, e(0)));
    const Tensor<2, 3> tau = as_tensor(stress), rotated = L * tau + tau * transpose(L);
    for (const unsigned int k : {0, 1, 3})
      {
        const auto [i, j] = voigt_indices[k];
        double expected   = rotated[i][j];
        for (const unsigned int l : {0, 1, 3})
          expected += tangent[k][l] * rate[l];
        check::is_close(derivative([&](const double s) { return kirchhoff_stress(law, e(s))[k]; }),
                        expected,
                        1e-7,
                        name + ": derivative of the stress in plane stress",
                        E);
      }
  }

  void
  check_stress(const HyperelasticLaw       &law,
               const SymmetricTensor<2, 3> &e,
               const Voigt<3>              &expected,
               const std::string           &what)
  {
    const Voigt<3> stress = kirchhoff_stress(law, e);
    for (unsigned int k = 0; k < 6; ++k)
      check::is_close(stress[k], expected[k], 1e-11, what + ", component " + std::to_string(k), 1e3 * E);
  }

  SymmetricTensor<2, 3>
  diagonal(const double b_1, const double b_2, const double b_3)
  {
    SymmetricTensor<2, 3> e;
    e[0][0] = b_1 - 1;
    e[1][1] = b_2 - 1;
    e[2][2] = b_3 - 1;
    return e;
  }

  // gamma along x per y
  SymmetricTensor<2, 3>
  sheared(const double gamma)
  {
    Tensor<2, 3> F(unit_symmetric_tensor<3>());
    F[0][1] = gamma;
    return strain_of(F);
  }

  // Stretch a along x. With x the square of the lateral stretch, sigma_22 = 0 is
  // mu (x - 1) + lambda/2 (a^2 x^2 - 1) = 0, and tau_11 = mu (a^2 - x).
  void
  check_neo_hookean(const double nu)
  {
    const std::string     name = "neo-Hookean, nu " + std::to_string(nu);
    const HyperelasticLaw law  = law_of(Law::neo_hookean, nu);
    const double          mu = E / 2 / (1 + nu), lambda = 2 * mu * nu / (1 - 2 * nu);
    for (const double a : {0.5, 0.9, 1.4, 3.})
      {
        const double half = lambda / 2 * a * a;
        const double x    = 2 * (mu + lambda / 2) / (mu + std::sqrt(mu * mu + 4 * half * (mu + lambda / 2)));
        check_stress(law, diagonal(a * a, x, x), {{mu * (a * a - x)}}, name + ": uniaxial");
        if (nu > 0.49)
          check::is_close(kirchhoff_stress(law, diagonal(a * a, x, x))[0],
                          mu * (a * a - 1 / a),
                          2e-3,
                          name + ": incompressible limit");
        const double thickness = 1 + thickness_strain(law, diagonal(a * a, a * a, 1));
        const double biaxial   = mu * (a * a - thickness);
        check::is_close(
            thickness, (2 * mu + lambda) / (2 * mu + lambda * std::pow(a, 4)), 1e-13, name + ": thickness");
        check_stress(law, diagonal(a * a, a * a, thickness), {{biaxial, biaxial}}, name + ": biaxial");
      }
    const double gamma = 0.7;
    check_stress(law, sheared(gamma), {{mu * gamma * gamma, 0, 0, mu * gamma, 0, 0}}, name + ": shear");
  }

  // Hooke's law between S and E, tau = F S F^T.
  void
  check_st_venant_kirchhoff(const double nu)
  {
    const std::string     name = "St. Venant-Kirchhoff, nu " + std::to_string(nu);
    const HyperelasticLaw law  = law_of(Law::st_venant_kirchhoff, nu);
    const double          mu = E / 2 / (1 + nu), lambda = 2 * mu * nu / (1 - 2 * nu);
    for (const double a : {0.7, 0.9, 1.3})
      {
        const double strain = (a * a - 1) / 2, x = 1 - 2 * nu * strain;
        check_stress(law, diagonal(a * a, x, x), {{a * a * E * strain}}, name + ": uniaxial");
        const double thickness = 1 - 4 * nu / (1 - nu) * strain;
        const double biaxial   = a * a * E / (1 - nu) * strain;
        check::is_close(
            1 + thickness_strain(law, diagonal(a * a, a * a, 1)), thickness, 1e-12, name + ": thickness");
        check_stress(law, diagonal(a * a, a * a, thickness), {{biaxial, biaxial}}, name + ": biaxial");
      }
    const double g = 0.7, S_33 = lambda * g * g / 2, S_11 = S_33, S_22 = S_33 + mu * g * g, S_12 = mu * g;
    check_stress(law,
                 sheared(g),
                 {{S_11 + 2 * g * S_12 + g * g * S_22, S_22, S_33, S_12 + g * S_22, 0, 0}},
                 name + ": shear");
  }

  // Hooke's law, to as many digits as the strain has.
  void
  check_tiny_strains(const HyperelasticLaw &law, const double nu, const std::string &name)
  {
    const double                mu = E / 2 / (1 + nu), lambda = 2 * mu * nu / (1 - 2 * nu);
    const SymmetricTensor<2, 3> strain = 1e-13 * symmetrize(random_tensor(1));
    const SymmetricTensor<2, 3> sigma = lambda * trace(strain) * unit_symmetric_tensor<3>() + 2 * mu * strain;
    const Voigt<3>              stress = kirchhoff_stress(law, 2 * strain), expected = as_voigt(sigma);
    for (unsigned int k = 0; k < 6; ++k)
      check::is_close(stress[k], expected[k], 1e-11, name + ": tiny stress", sigma.norm());
    check::is_close(energy(law, 2 * strain), 0.5 * (sigma * strain), 1e-2, name + ": tiny energy", 1e-26 * E);
    const double thickness = thickness_strain(law, 2 * strain);
    check::is_close(thickness,
                    -2 * nu / (1 - nu) * (strain[0][0] + strain[1][1]),
                    1e-11,
                    name + ": tiny change of the thickness",
                    strain.norm());
  }
} // namespace

int
main(int, char **)
{
  for (const double nu : {0., 0.3, 0.4999})
    {
      for (const Law law : {Law::neo_hookean, Law::st_venant_kirchhoff})
        {
          const std::string name =
              (law == Law::neo_hookean ? "neo-Hookean, nu " : "St. Venant-Kirchhoff, nu ") +
              std::to_string(nu);
          check_derivatives(law_of(law, nu), name);
          check_plane_stress(law_of(law, nu), name);
          check_tiny_strains(law_of(law, nu), nu, name);
        }
      check_neo_hookean(nu);
      check_st_venant_kirchhoff(nu);
    }
  return check::result();
}
} // namespace test_hyperelastic

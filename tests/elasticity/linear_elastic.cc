// Hooke's law and von Mises' stress against hand calculation, in every kind.
#include "check.h"

#include <amontons/elasticity/linear_elastic.h>

namespace test_linear_elastic
{
using namespace Amontons;

template <int dim>
void
check_stress(const ProblemType  kind,
             const Voigt<dim>  &strain,
             const Voigt<dim>  &wanted,
             const std::string &what)
{
  MaterialData material;
  material.young    = 1000;
  material.poisson  = 0.25;
  const auto stress = LinearElastic<dim>(material, kind).stress(strain);
  for (unsigned int k = 0; k < n_voigt<dim>; ++k)
    check::is_close(stress[k], wanted[k], 1e-13, what + ", component " + std::to_string(k), 1);
}

int
main(int, char **)
{
  // E = 1000, nu = 1/4: lambda = mu = 400; shear strains are twice the tensor's.
  check_stress<2>(ProblemType::plane_strain, {{0.01, 0.02, 0, 0.03}}, {{20, 28, 12, 12}}, "plane strain");
  check_stress<2>(ProblemType::axisymmetric, {{0.01, 0.02, 0.04, 0.03}}, {{36, 44, 60, 12}}, "axisymmetric");
  // E/(1 - nu^2) (e_x + nu e_y); the third strain follows
  check_stress<2>(ProblemType::plane_stress, {{0.01, 0.02, 7, 0.03}}, {{16, 24, 0, 12}}, "plane stress");
  check_stress<3>(ProblemType::three_dimensional,
                  {{0.01, 0.02, 0.04, 0.03, 0.05, 0.07}},
                  {{36, 44, 60, 12, 20, 28}},
                  "in space");

  // von Mises: sigma for one normal stress, 0 for a pressure, sqrt(3) tau for one shear; all at once:
  // sqrt(((1-3)^2 + (3-6)^2 + (6-1)^2)/2 + 3 (2^2 + 4^2 + 5^2)) = sqrt(19 + 135)
  for (unsigned int k = 0; k < n_voigt<3>; ++k)
    {
      Voigt<3> stress = Voigt<3>();
      stress[k]       = -7;
      check::is_close(von_mises<3>(stress), k < 3 ? 7 : 7 * std::sqrt(3.), 1e-14, "3D: one stress");
    }
  for (unsigned int k = 0; k < n_voigt<2>; ++k)
    {
      Voigt<2> stress = Voigt<2>();
      stress[k]       = -7;
      check::is_close(von_mises<2>(stress), k < 3 ? 7 : 7 * std::sqrt(3.), 1e-14, "2D: one stress");
    }
  check::is_close(von_mises<3>({{5, 5, 5, 0, 0, 0}}), 0, 0, "pressure", 1);
  check::is_close(von_mises<3>({{1, 3, 6, 2, 4, 5}}), std::sqrt(154.), 1e-14, "3D: all stresses");
  check::is_close(von_mises<2>({{1, 3, 6, 2}}), std::sqrt(31.), 1e-14, "2D: all stresses");
  MaterialData steel;
  steel.young   = 96;
  steel.poisson = 0.2;
  check::is_close(contact_modulus(steel), 100, 1e-14, "plane-strain modulus");
  return check::result();
}
} // namespace test_linear_elastic

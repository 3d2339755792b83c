// The half space under Hertz's pressure on a circle, in elementary functions everywhere.
#include <amontons/base/closed_forms.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace ClosedForms
  {
    namespace
    {
      const double pi = 3.14159265358979323846;

      // u >= 0 and v in [0, a] with u + i v = sqrt(r^2 + (z + i a)^2): oblate spheroidal coordinates,
      //   u v = a z,  u^2 - v^2 = r^2 + z^2 - a^2,  a^2 - v^2 = a^2 r^2 / (u^2 + a^2).
      // The larger of the two by the root, the other by the product, so that none suffers from cancellation.
      struct Spheroidal
      {
        double u, v;
      };

      Spheroidal
      spheroidal(const double r, const double z, const double a)
      {
        const double s = r * r + z * z - a * a, root = std::hypot(s, 2 * a * z);
        const double larger = std::sqrt((std::abs(s) + root) / 2), smaller = larger > 0 ? a * z / larger : 0.;
        return s >= 0 ? Spheroidal{larger, smaller} : Spheroidal{smaller, larger};
      }
    } // namespace

    // The pressure's potentials psi = int p/rho and chi = int p ln(rho+z) are integrals of complex point
    // sources,
    //   psi = (3P/(4a^3)) int_{-a}^{a} (a^2-t^2) / sqrt(r^2+(z+it)^2) dt,
    // which are elementary. With C = 3P/(2a^3), phi = arctan(a/u), q = u^2+v^2:
    //   psi      = C [(a^2+z^2-r^2/2) phi - 3/2 z v + a u/2]
    //   psi_r/r  = -C [phi - a u/(u^2+a^2)]
    //   psi_z    = -2C (v - z phi)
    //   psi_zz   = 2C (phi - a u/q)
    //   psi_rz   = 2C r a^2 v / ((u^2+a^2) q)
    //   chi_r/r  = C [(2a+v) (a-v) a^2 / (3 (a+v) (u^2+a^2)) + v - z phi]
    // and psi, chi are harmonic with chi_z = psi. Love's solution for normal tractions ([J] sec. 3.2):
    //   4 pi G u_r = -(1-2nu) chi_r - z psi_r,   4 pi G u_z = 2 (1-nu) psi - z psi_z,
    //   2 pi rr = 2 nu psi_z - z psi_rr - (1-2nu) chi_rr,   2 pi tt = 2 nu psi_z - z psi_r/r - (1-2nu)
    //   chi_r/r, 2 pi zz = psi_z - z psi_zz,   2 pi rz = -z psi_rz.
    // Rounding grows like the square of the distance: relative 1e-16 (distance/a)^2.
    HalfSpaceState
    half_space_hertz(
        const double r, const double depth, const double E, const double nu, const double P, const double a)
    {
      const double z    = std::max(depth, 0.);
      const auto [u, v] = spheroidal(r, z, a);
      const double phi = std::atan2(a, u), C = 3 * P / (2 * a * a * a);
      const double spheroid = u * u + a * a, q = u * u + v * v;

      const double psi      = C * ((a * a + z * z - r * r / 2) * phi - 1.5 * z * v + a * u / 2);
      const double psi_r_r  = -C * (phi - a * u / spheroid);
      const double psi_z    = -2 * C * (v - z * phi);
      const double z_psi_zz = z > 0 ? z * 2 * C * (phi - a * u / q) : 0.;
      const double z_psi_rz = z > 0 ? z * 2 * C * r * a * a * v / (spheroid * q) : 0.;
      const double chi_r_r  = C * ((2 * a + v) * (a - v) * a * a / (3 * (a + v) * spheroid) + v - z * phi);
      const double z_psi_rr = -z_psi_zz - z * psi_r_r, chi_rr = -psi_z - chi_r_r;

      const double   compliance = (1 + nu) / (2 * pi * E); // 1/(4 pi G)
      HalfSpaceState state;
      state.ur = -compliance * r * ((1 - 2 * nu) * chi_r_r + z * psi_r_r);
      state.uz = compliance * (2 * (1 - nu) * psi - z * psi_z);
      state.rr = (2 * nu * psi_z - z_psi_rr - (1 - 2 * nu) * chi_rr) / (2 * pi);
      state.tt = (2 * nu * psi_z - z * psi_r_r - (1 - 2 * nu) * chi_r_r) / (2 * pi);
      state.zz = (psi_z - z_psi_zz) / (2 * pi);
      state.rz = -z_psi_rz / (2 * pi);
      return state;
    }
  } // namespace ClosedForms
} // namespace Amontons

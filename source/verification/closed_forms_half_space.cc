// The half space under Hertz's pressure and Mindlin's shear on a circle, in elementary functions everywhere.
#include <amontons/verification/closed_forms.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace Amontons
{
  namespace ClosedForms
  {
    namespace
    {
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

    namespace
    {
      // The traction's potentials psi = int p/rho and chi = int p ln(rho+z) are integrals of complex point
      // sources,
      //   psi = (3P/(4a^3)) int_{-a}^{a} (a^2-t^2) / sqrt(r^2+(z+it)^2) dt,
      // which are elementary. With C = 3P/(2a^3), phi = arctan(a/u), q = u^2+v^2:
      //   psi      = C [(a^2+z^2-r^2/2) phi - 3/2 z v + a u/2]
      //   psi_r/r  = -C [phi - a u/(u^2+a^2)]
      //   psi_z    = -2C (v - z phi)
      //   psi_zz   = 2C (phi - a u/q)
      //   psi_rz   = 2C r a^2 v / ((u^2+a^2) q)
      //   chi_r/r  = C [(2a+v) (a-v) a^2 / (3 (a+v) (u^2+a^2)) + v - z phi]
      // and psi, chi are harmonic with chi_z = psi.
      struct Potentials
      {
        double psi, psi_r_r, psi_z, psi_zz, z_psi_zz, z_psi_rz, chi_r_r, chi_rr;
      };

      Potentials
      potentials(const double r, const double z, const double P, const double a)
      {
        const auto [u, v] = spheroidal(r, z, a);
        const double phi = std::atan2(a, u), C = 3 * P / (2 * a * a * a);
        const double spheroid = u * u + a * a, q = u * u + v * v;
        Potentials   p;
        p.psi      = C * ((a * a + z * z - r * r / 2) * phi - 1.5 * z * v + a * u / 2);
        p.psi_r_r  = -C * (phi - a * u / spheroid);
        p.psi_z    = -2 * C * (v - z * phi);
        p.psi_zz   = 2 * C * (phi - a * u / q);
        p.z_psi_zz = z > 0 ? z * p.psi_zz : 0.;
        p.z_psi_rz = z > 0 ? z * 2 * C * r * a * a * v / (spheroid * q) : 0.;
        p.chi_r_r  = C * ((2 * a + v) * (a - v) * a * a / (3 * (a + v) * spheroid) + v - z * phi);
        p.chi_rr   = -p.psi_z - p.chi_r_r;
        return p;
      }

      // omega_r/r of omega = int p (z ln(rho+z) - rho), for which omega_z = chi:
      //   omega_r/r = -(1/r^2) int p (rho - z) = [P z - (3P/(4a^3)) S] / r^2,
      // S the integral of (a^2-t^2) sqrt(r^2+s^2), s = z+it, over |t| < a; with w = u+iv and L = i phi at s =
      // z+ia: S = 2 Im [(a^2+z^2) (s w + r^2 L)/2 + s w^3/4 - r^2 (s w + r^2 L)/8 - 2 z w^3/3].
      // Near the axis the two terms cancel, but omega_r/r = -psi/2 - r^2 psi_zz/16 + O(r^4).
      double
      omega_r_r(const double r, const double z, const double P, const double a, const Potentials &potentials)
      {
        if (r < 3e-3 * std::hypot(a, z))
          return -potentials.psi / 2 - r * r * potentials.psi_zz / 16;
        const auto [u, v] = spheroidal(r, z, a);
        const std::complex<double> s(z, a), w(u, v),
            cube = w * w * w, sum = s * w + r * r * std::complex<double>(0, std::atan2(a, u));
        const double S =
            2 * ((a * a + z * z) / 2 * sum + s * cube / 4. - r * r / 8 * sum - 2 * z / 3 * cube).imag();
        return (P * z - 3 * P / (4 * a * a * a) * S) / (r * r);
      }
    } // namespace

    // Love's solution for normal tractions ([J] sec. 3.2):
    //   4 pi G u_r = -(1-2nu) chi_r - z psi_r,   4 pi G u_z = 2 (1-nu) psi - z psi_z,
    //   2 pi rr = 2 nu psi_z - z psi_rr - (1-2nu) chi_rr,   2 pi tt = 2 nu psi_z - z psi_r/r - (1-2nu)
    //   chi_r/r, 2 pi zz = psi_z - z psi_zz,   2 pi rz = -z psi_rz.
    // Rounding grows like the square of the distance: relative 1e-16 (distance/a)^2.
    HalfSpaceState
    half_space_hertz(
        const double r, const double depth, const double E, const double nu, const double P, const double a)
    {
      const double     z        = std::max(depth, 0.);
      const Potentials p        = potentials(r, z, P, a);
      const double     z_psi_rr = -p.z_psi_zz - z * p.psi_r_r;

      const double   compliance = (1 + nu) / (2 * pi * E); // 1/(4 pi G)
      HalfSpaceState state;
      state.ur = -compliance * r * ((1 - 2 * nu) * p.chi_r_r + z * p.psi_r_r);
      state.uz = compliance * (2 * (1 - nu) * p.psi - z * p.psi_z);
      state.rr = (2 * nu * p.psi_z - z_psi_rr - (1 - 2 * nu) * p.chi_rr) / (2 * pi);
      state.tt = (2 * nu * p.psi_z - z * p.psi_r_r - (1 - 2 * nu) * p.chi_r_r) / (2 * pi);
      state.zz = (p.psi_z - p.z_psi_zz) / (2 * pi);
      state.rz = -p.z_psi_rz / (2 * pi);
      return state;
    }

    // Cerruti's potentials ([J] (3.2)-(3.7)): 4 pi G u = (2 psi + 2 nu omega_xx - z chi_xx, 2 nu omega_xy - z
    // chi_xy, (1-2nu) chi_x - z psi_x), with omega harmonic and omega_zz = psi.
    Displacement
    half_space_shear(const double x,
                     const double y,
                     const double depth,
                     const double E,
                     const double nu,
                     const double Q,
                     const double a)
    {
      const double     z = std::max(depth, 0.), r = std::hypot(x, y);
      const Potentials p = potentials(r, z, Q, a);
      const double     c = r > 0 ? x / r : 1., s = r > 0 ? y / r : 0.;
      const double     omega_t = omega_r_r(r, z, Q, a, p), omega_rr = -p.psi - omega_t;
      const double     compliance = (1 + nu) / (2 * pi * E); // 1/(4 pi G)
      Displacement     u;
      u.x = compliance * (2 * p.psi + 2 * nu * (omega_rr * c * c + omega_t * s * s) -
                          z * (p.chi_rr * c * c + p.chi_r_r * s * s));
      u.y = compliance * c * s * (2 * nu * (omega_rr - omega_t) - z * (p.chi_rr - p.chi_r_r));
      u.z = compliance * x * ((1 - 2 * nu) * p.chi_r_r - z * p.psi_r_r);
      return u;
    }
  } // namespace ClosedForms
} // namespace Amontons

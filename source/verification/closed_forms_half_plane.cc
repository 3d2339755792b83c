// The half plane under elliptic tractions by complex functions.
#include <amontons/verification/closed_forms.h>

#include <cmath>
#include <complex>

namespace Amontons
{
  namespace ClosedForms
  {
    namespace
    {
      // I(zeta) = int p(t) ln(zeta-t) dt over the ellipse of resultant F, its derivative d = int p/(zeta-t)
      // dt, and z I''. With s = sqrt(zeta-a) sqrt(zeta+a) and zeta - s = a^2/(zeta+s):
      //   I = F [zeta/(zeta+s) + ln((zeta+s)/2) - 1/2],  I' = 2F/(zeta+s),  I'' = -2F/(s (zeta+s)),  Im zeta
      //   >= 0.
      // The two square roots keep s on one branch in the upper half plane. z I'' vanishes on the surface.
      struct Potential
      {
        std::complex<double> value, derivative, z_second;
        double               z;
      };

      Potential
      potential(const double x, const double depth, const EllipticTraction &traction)
      {
        const double               z = depth > 0 ? depth : 0.; // also takes -0. to the upper side of the cut
        const std::complex<double> zeta(x - traction.centre, z);
        const std::complex<double> s   = std::sqrt(zeta - traction.size) * std::sqrt(zeta + traction.size);
        const std::complex<double> sum = zeta + s;
        Potential                  p;
        p.z          = z;
        p.value      = traction.force * (zeta / sum + std::log(sum / 2.) - 0.5);
        p.derivative = 2 * traction.force / sum;
        p.z_second   = z > 0 ? -2 * traction.force * z / (s * sum) : 0.;
        return p;
      }
    } // namespace

    // With psi = -2 Re I:  4 pi G ux = (1-2nu) 2 (Im I - pi F/2) + 2 z Re I',  4 pi G uz = -4 (1-nu) Re I - 2
    // z Im I'; pi xx = Im I' + z Re I'',  pi zz = Im I' - z Re I'',  pi xz = -z Im I''.
    HalfPlaneState
    half_plane_pressure(
        const double x, const double z, const double E, const double nu, const EllipticTraction &traction)
    {
      const Potential p = potential(x, z, traction);
      const double    c = (1 + nu) / (2 * pi * E); // 1/(4 pi G)
      HalfPlaneState  state;
      state.ux =
          c * (2 * (1 - 2 * nu) * (p.value.imag() - pi * traction.force / 2) + 2 * p.z * p.derivative.real());
      state.uz     = c * (-4 * (1 - nu) * p.value.real() - 2 * p.z * p.derivative.imag());
      state.stress = {(p.derivative.imag() + p.z_second.real()) / pi,
                      (p.derivative.imag() - p.z_second.real()) / pi,
                      -p.z_second.imag() / pi};
      return state;
    }

    // 4 pi G ux = -4 (1-nu) Re I + 2 z Im I',  4 pi G uz = -2 (1-2nu) (Im I - pi F/2) + 2 z Re I';
    // pi xx = -2 Re I' + z Im I'',  pi zz = -z Im I'',  pi xz = Im I' + z Re I''.
    HalfPlaneState
    half_plane_shear(
        const double x, const double z, const double E, const double nu, const EllipticTraction &traction)
    {
      const Potential p = potential(x, z, traction);
      const double    c = (1 + nu) / (2 * pi * E);
      HalfPlaneState  state;
      state.ux     = c * (-4 * (1 - nu) * p.value.real() + 2 * p.z * p.derivative.imag());
      state.uz     = c * (-2 * (1 - 2 * nu) * (p.value.imag() - pi * traction.force / 2) +
                      2 * p.z * p.derivative.real());
      state.stress = {(-2 * p.derivative.real() + p.z_second.imag()) / pi,
                      -p.z_second.imag() / pi,
                      (p.derivative.imag() + p.z_second.real()) / pi};
      return state;
    }
  } // namespace ClosedForms
} // namespace Amontons

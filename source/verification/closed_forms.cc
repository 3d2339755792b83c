#include <amontons/verification/closed_forms.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace ClosedForms
  {
    double
    contact_modulus(const double E1, const double nu1, const double E2, const double nu2)
    {
      return 1. / ((1 - nu1 * nu1) / E1 + (1 - nu2 * nu2) / E2);
    }

    double
    contact_modulus_plane_stress(const double E1, const double E2)
    {
      return 1. / (1. / E1 + 1. / E2);
    }

    double
    confined_modulus(const double E, const double nu)
    {
      return E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    }

    Hertz
    hertz_line(const double P, const double R, const double modulus)
    {
      return hertz_line_of_size(std::sqrt(4 * P * R / (pi * modulus)), R, modulus);
    }

    Hertz
    hertz_line_of_size(const double a, const double R, const double modulus)
    {
      return {
          pi * modulus * a * a / (4 * R), a, modulus * a / (2 * R), std::numeric_limits<double>::quiet_NaN()};
    }

    Hertz
    hertz_point(const double P, const double R, const double modulus)
    {
      const double a = std::cbrt(3 * P * R / (4 * modulus));
      return {P, a, 3 * P / (2 * pi * a * a), a * a / R};
    }

    Hertz
    hertz_point_of_size(const double a, const double R, const double modulus)
    {
      return hertz_point(4 * modulus * a * a * a / (3 * R), R, modulus);
    }

    double
    elliptic_pressure(const double r, const double a, const double p0)
    {
      return std::abs(r) < a ? p0 * std::sqrt(1 - (r / a) * (r / a)) : 0;
    }

    double
    hertz_line_gap(const double x, const double a, const double R)
    {
      const double X = std::max(std::abs(x), a);
      return (X * std::sqrt(X * X - a * a) - a * a * std::acosh(X / a)) / (2 * R);
    }

    double
    hertz_point_gap(const double r, const double a, const double R)
    {
      const double s = std::max(std::abs(r) / a, 1.);
      return a * a / (pi * R) * (std::sqrt(s * s - 1) + (s * s - 2) * std::acos(1 / s));
    }

    PlaneStress
    hertz_line_axis(const double z, const double a, const double p0)
    {
      const double s = std::sqrt(a * a + z * z);
      return {-p0 / a * ((a * a + 2 * z * z) / s - 2 * z), -p0 * a / s, 0};
    }

    // m^2 = (B+A)/2, n^2 = (B-A)/2 with A = a^2-x^2+z^2, B^2 = A^2+4x^2z^2, sign(n) = sign(x).
    PlaneStress
    hertz_line_field(const double x, const double z, const double a, const double p0, const double mu)
    {
      const double A = a * a - x * x + z * z;
      const double B = std::sqrt(A * A + 4 * x * x * z * z);
      const double m = std::sqrt(std::max(0., (B + A) / 2));
      const double n = std::copysign(std::sqrt(std::max(0., (B - A) / 2)), x);
      const double d = std::max(m * m + n * n, 1e-300);

      const double along = m * (1 + (z * z + n * n) / d) - 2 * z;
      const double cross = n * (m * m - z * z) / d;
      PlaneStress  s     = {-p0 / a * along, -p0 / a * m * (1 - (z * z + n * n) / d), -p0 / a * cross};
      s.xx += mu * p0 / a * (n * (2 - (z * z - m * m) / d) - 2 * x);
      s.zz -= mu * p0 / a * cross;
      s.xz -= mu * p0 / a * along;
      return s;
    }

    PlaneStress
    hertz_point_axis(const double z, const double a, const double p0, const double nu)
    {
      const double t = z / a;
      return {-p0 * ((1 + nu) * (1 - t * std::atan2(1., t)) - 0.5 / (1 + t * t)), -p0 / (1 + t * t), 0};
    }

    // The modulus e of the ellipse solves B/A = (E(e)/(1-e^2) - K(e)) / (K(e) - E(e)); bisection in
    // log(1-e^2).
    EllipticContact
    hertz_elliptic(const double P, const double A, const double B, const double modulus)
    {
      if (std::abs(B / A - 1) < 1e-9)
        {
          const Hertz h = hertz_point(P, 1 / (A + B), modulus);
          return {h.size, h.size, h.peak, h.approach};
        }
      const auto ratio = [](const double e) {
        const double K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
        return (E / (1 - e * e) - K) / (K - E);
      };
      double lower = std::log(1e-14), upper = -1e-10;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double middle                                             = (lower + upper) / 2;
          (ratio(std::sqrt(-std::expm1(middle))) > B / A ? lower : upper) = middle;
        }
      const double e = std::sqrt(-std::expm1(lower)), K = std::comp_ellint_1(e), E = std::comp_ellint_2(e);
      const double a = std::cbrt(3 * P * (K - E) / (2 * pi * modulus * e * e * A));
      const double b = a * std::sqrt(1 - e * e);
      return {a, b, 3 * P / (2 * pi * a * b), 3 * P * K / (2 * pi * a * modulus)};
    }

    // The sum of the curvature tensors in the axes of the first surface, in its principal axes.
    QuadraticGap
    quadratic_gap(const double k1x, const double k1y, const double k2x, const double k2y, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      const double xx = k1x + k2x * c * c + k2y * s * s, yy = k1y + k2x * s * s + k2y * c * c,
                   xy   = (k2x - k2y) * c * s;
      const double mean = (xx + yy) / 2, difference = std::hypot((xx - yy) / 2, xy);
      const double direction = difference < 1e-9 * std::abs(mean) ? 0. : std::atan2(-2 * xy, yy - xx) / 2;
      return {(mean - difference) / 2, (mean + difference) / 2, direction};
    }

    EllipticContact
    crossed_cylinders(
        const double P, const double R1, const double R2, const double angle, const double modulus)
    {
      const QuadraticGap gap = quadratic_gap(0, 1 / R1, 0, 1 / R2, angle);
      return hertz_elliptic(P, gap.A, gap.B, modulus);
    }

    double
    circle_correction(const double a_over_R, const int dim)
    {
      return -(dim == 2 ? 3. / 16. : 2. / 15.) * a_over_R * a_over_R;
    }

    double
    flat_punch_line_pressure(const double x, const double P, const double a)
    {
      return std::abs(x) < a ? P / (pi * std::sqrt(a * a - x * x)) : 0;
    }

    double
    flat_punch_force(const double a, const double delta, const double modulus)
    {
      return 2 * modulus * a * delta;
    }

    double
    flat_punch_pressure(const double r, const double P, const double a)
    {
      return std::abs(r) < a ? P / (2 * pi * a * std::sqrt(a * a - r * r)) : 0;
    }

    Cone
    cone(const double P, const double flank, const double modulus)
    {
      const double tangent  = std::tan(flank);
      const double approach = std::sqrt(P * pi * tangent / (2 * modulus));
      return {2 * approach / (pi * tangent), approach};
    }

    double
    cone_pressure(const double r, const double a, const double flank, const double modulus)
    {
      return std::abs(r) < a ? modulus / 2 * std::tan(flank) * std::acosh(a / std::abs(r)) : 0;
    }

    // With x = a sin t: P = E* int_0^(pi/2) x f'(x) dt.
    double
    line_profile_force(const std::function<double(double)> &slope, const double a, const double modulus)
    {
      const dealii::QGauss<1> quadrature(100);
      double                  force = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double x = a * std::sin(pi / 2 * quadrature.point(q)[0]);
          force += modulus * x * slope(x) * pi / 2 * quadrature.weight(q);
        }
      return force;
    }
  } // namespace ClosedForms
} // namespace Amontons

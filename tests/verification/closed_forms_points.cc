// Elliptic contacts, and the half space under Hertz's pressure: published digits, the law, equilibrium, and
// limits.
#include <amontons/verification/closed_forms.h>

#include <check.h>

namespace test_closed_forms_points
{
using namespace Amontons::ClosedForms;
using check::is_close;

namespace
{
  const double pi = 3.14159265358979323846;

  // Digits of `curvatures` and `hertz_elliptic` of analytic.py; directions from the symmetry of the cases.
  void
  elliptic()
  {
    const QuadraticGap skew = quadratic_gap(.1, .05, 1. / 30, 0, .3);
    is_close(skew.A, .025892436557679185, 1e-14, "A of two skew surfaces");
    is_close(skew.B, .06577423010898749, 1e-14, "B of two skew surfaces");
    const EllipticContact cylinders =
        crossed_cylinders(1000, 10, 15, pi / 3, contact_modulus(210e3, .3, 70e3, .33));
    is_close(cylinders.a, .820287297455968, 1e-9, "skew cylinders: a");
    is_close(cylinders.b, .37583155992195605, 1e-9, "skew cylinders: b");
    is_close(cylinders.peak, 1548.752974421607, 1e-9, "skew cylinders: p0");
    is_close(cylinders.approach, .02220053124472088, 1e-9, "skew cylinders: delta");
    // an ellipsoid of semi-axes 10, 6, 5 on a plane: radii 100/5 and 36/5
    const QuadraticGap ellipsoid = quadratic_gap(5. / 100, 5. / 36, 0, 0);
    is_close(ellipsoid.direction, 0, 1e-14, "the long axis is x", 1);
    const EllipticContact e = hertz_elliptic(1000, ellipsoid.A, ellipsoid.B, contact_modulus(200e3, .3));
    is_close(e.a, .47699055528542394, 1e-9, "ellipsoid: a");
    is_close(e.b, .24214851409831633, 1e-9, "ellipsoid: b");
    is_close(e.approach, .009759937445785563, 1e-9, "ellipsoid: delta");
    // A cylinder along x (long axis of the gap) turned by 0.4, alone; two equal ones along 0 and 0.8: between
    // them
    is_close(quadratic_gap(0, 0, 0, .1, .4).direction, .4, 1e-14, "direction of one cylinder");
    is_close(quadratic_gap(0, .1, 0, .1, .8).direction, .4, 1e-14, "direction of two cylinders");
    is_close(std::abs(quadratic_gap(.1, 0, 0, 0).direction), pi / 2, 1e-14, "the long axis is y");
    is_close(quadratic_gap(0, .1, 0, .1, pi / 2).A, .05, 1e-14, "crossed at 90 degrees: a circle");
  }

  // The half space under Hertz's pressure: digits of the quadrature `halfspace_hertz_farfield` of analytic.py
  // (E = 1, nu = 0.3, P = 1.25, a = 1, n = 60), Johnson's formulas of the axis and the surface, the law and
  // equilibrium.
  void
  half_space()
  {
    const double far[8][4] = {{2, 0, -5.172535650487e-02, 1.859774639067e-01},
                              {4, 2, 8.967263394021e-03, 9.303973882359e-02},
                              {3, 4, 1.739828257778e-02, 1.051604407314e-01},
                              {std::sqrt(32.), 4, 6.955937956478e-03 * std::sqrt(2.), 6.480709720104e-02},
                              {std::sqrt(32.), 0, -1.293133912622e-02 * std::sqrt(2.), 6.420892327632e-02},
                              {std::sqrt(2.), 2, 2.244526967390e-02 * std::sqrt(2.), 2.141765651355e-01},
                              {0, 4, 0, 1.517524828788e-01},
                              {1.6, .1, -4.852500096941e-02, 2.367910031928e-01}};
    for (const auto &row : far)
      {
        const HalfSpaceState s = half_space_hertz(row[0], row[1], 1, .3, 1.25, 1);
        is_close(s.ur, row[2], 1e-11, "u_r of the quadrature", .1);
        is_close(s.uz, row[3], 1e-11, "u_z of the quadrature");
      }

    const double E = 7, nu = .27, P = 2, a = 1.3, p0 = 3 * P / (2 * pi * a * a);
    const auto   at = [&](const double r, const double z) { return half_space_hertz(r, z, E, nu, P, a); };
    for (const double z : {0., 1e-9, .3, 1., 5.})
      {
        const PlaneStress axis = hertz_point_axis(z, a, p0, nu);
        is_close(at(0, z).rr, axis.xx, 1e-13, "rr on the axis", p0);
        is_close(at(0, z).tt, axis.xx, 1e-13, "tt on the axis", p0);
        is_close(at(0, z).zz, axis.zz, 1e-13, "zz on the axis", p0);
      }
    const double R = 4 * a * a * a / (3 * P) * E / (1 - nu * nu), centre = at(0, 0).uz;
    is_close(centre, a * a / R, 1e-14, "approach to a rigid sphere");
    for (const double r : {.1, .9, 1.3, 1.4, 3., 10., 100.})
      {
        const HalfSpaceState s = at(r, 0);
        is_close(r * r / (2 * R) - (centre - s.uz), hertz_point_gap(r, a, R), 1e-13, "gap", a * a / R);
        is_close(s.zz, -elliptic_pressure(r, a, p0), 1e-13, "-p", p0);
        is_close(s.rz, 0, 1e-14, "no shear", p0);
        const double ellipse = elliptic_pressure(r, a, 1), ring = (1 - 2 * nu) * a * a / (3 * r * r);
        is_close(s.rr, p0 * (ring * (1 - std::pow(ellipse, 3)) - ellipse), 1e-12, "rr on the surface", p0);
      }
    // far away a point force: u_z = P (1-nu^2)/(pi E r) on the surface
    is_close(at(1000, 0).uz, P * (1 - nu * nu) / (pi * E * 1000), 1e-6, "Boussinesq");

    const double h = 1e-4, G = E / 2 / (1 + nu), lame = 2 * G * nu / (1 - 2 * nu);
    for (const double r : {.05, .5, 1.25, 1.35, 3., 8.})
      for (const double z : {.05, .4, 1.3, 6.})
        {
          const HalfSpaceState s = at(r, z), rp = at(r + h, z), rm = at(r - h, z), zp = at(r, z + h),
                               zm = at(r, z - h);
          const auto   d  = [h](const double plus, const double minus) { return (plus - minus) / (2 * h); };
          const double rr = d(rp.ur, rm.ur), zz = d(zp.uz, zm.uz), tt = s.ur / r, trace = rr + zz + tt;
          is_close(s.rr, lame * trace + 2 * G * rr, 1e-6, "rr by the law", p0);
          is_close(s.tt, lame * trace + 2 * G * tt, 1e-6, "tt by the law", p0);
          is_close(s.zz, lame * trace + 2 * G * zz, 1e-6, "zz by the law", p0);
          is_close(s.rz, G * (d(zp.ur, zm.ur) + d(rp.uz, rm.uz)), 1e-6, "rz by the law", p0);
          is_close(d(rp.rr, rm.rr) + d(zp.rz, zm.rz) + (s.rr - s.tt) / r, 0, 1e-5, "equilibrium, r", p0);
          is_close(d(rp.rz, rm.rz) + d(zp.zz, zm.zz) + s.rz / r, 0, 1e-5, "equilibrium, z", p0);
        }
    const HalfSpaceState edge = at(a, 0), above = at(a, -1e-3);
    check::is_true(std::isfinite(edge.ur) && std::isfinite(edge.rr) && std::isfinite(edge.rz), "edge");
    is_close(above.uz, edge.uz, 1e-15, "points outside of the body");
  }
  // Boussinesq's and Cerruti's point forces ([J] sec. 3.2, 3.6) over the circle: r = a sin t, midpoint rules.
  Displacement
  shear_by_quadrature(const double x,
                      const double y,
                      const double z,
                      const double E,
                      const double nu,
                      const double Q,
                      const double a)
  {
    const double G = E / 2 / (1 + nu);
    const int    n = 400, m = 200;
    Displacement u{0, 0, 0};
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < m; ++k)
        {
          const double t = pi / 2 * (i + .5) / n, angle = 2 * pi * (k + .5) / m;
          const double X = x - a * std::sin(t) * std::cos(angle), Y = y - a * std::sin(t) * std::sin(angle);
          const double rho = std::sqrt(X * X + Y * Y + z * z), sum = rho + z;
          const double f = 3 * Q / (2 * pi) * std::cos(t) * std::cos(t) * std::sin(t) * pi / 2 / n * 2 * pi /
                           m / (4 * pi * G);
          u.x +=
              f * (1 / rho + X * X / std::pow(rho, 3) + (1 - 2 * nu) * (1 / sum - X * X / (rho * sum * sum)));
          u.y += f * (X * Y / std::pow(rho, 3) - (1 - 2 * nu) * X * Y / (rho * sum * sum));
          u.z += f * (X * z / std::pow(rho, 3) + (1 - 2 * nu) * X / (rho * sum));
        }
    return u;
  }

  // The same half space under Mindlin's shear: point forces, and [J] (3.91) on the loaded circle.
  void
  sheared_half_space()
  {
    const double E = 7, Q = 2, a = 1.3;
    for (const double nu : {0., .27, .5})
      {
        const double points[][3] = {{3, 0, 0},
                                    {4, 2, 2},
                                    {-3, .5, 4},
                                    {0, 0, 4},
                                    {.001, .002, 3},
                                    {0, 4, 4},
                                    {1, -3, 0},
                                    {.3, .2, 1}};
        for (const auto &p : points)
          {
            const Displacement u = half_space_shear(p[0], p[1], p[2], E, nu, Q, a),
                               v = shear_by_quadrature(p[0], p[1], p[2], E, nu, Q, a);
            is_close(u.x, v.x, 1e-5, "u_x of the quadrature");
            is_close(u.y, v.y, 1e-5, "u_y of the quadrature", u.x);
            is_close(u.z, v.z, 1e-5, "u_z of the quadrature", u.x);
          }
        const double scale = 3 * Q / (2 * a * a) / (32 * E / 2 / (1 + nu) * a);
        for (const double x : {-.7, 0., .0003, .5, .9})
          for (const double y : {0., .0005, .9})
            {
              const Displacement u = half_space_shear(x, y, 0, E, nu, Q, a);
              is_close(u.x,
                       scale * (4 * (2 - nu) * a * a - (4 - 3 * nu) * x * x - (4 - nu) * y * y),
                       1e-9,
                       "u_x on the circle");
              is_close(u.y, scale * 2 * nu * x * y, 1e-9, "u_y on the circle", u.x);
            }
        for (const double z : {0., .8, 5.}) // both sides of the change of formulas near the axis
          {
            const double r = 3e-3 * std::hypot(a, z);
            is_close(half_space_shear(r * (1 - 1e-9), 0, z, E, nu, Q, a).x,
                     half_space_shear(r * (1 + 1e-9), 0, z, E, nu, Q, a).x,
                     1e-9,
                     "near the axis");
          }
      }
  }
} // namespace

int
main(int, char **)
{
  elliptic();
  half_space();
  sheared_half_space();
  return check::result();
}
} // namespace test_closed_forms_points

// The closed forms give the numbers of the published cases, and those of independent formulas.
#include <amontons/verification/closed_forms.h>
#include <amontons/verification/closed_forms_friction.h>

#include <check.h>

namespace test_closed_forms
{
using namespace Amontons::ClosedForms;
using check::is_close;

namespace
{
  const double pi = 3.14159265358979323846;

  // Six digits of a printed number, or what is given.
  void
  digits(const double value, const double printed, const std::string &what, const double tolerance = 5e-7)
  {
    is_close(value, printed, tolerance, what);
  }

  void
  hertz()
  {
    const Hertz roller = hertz_line(1000, 10, contact_modulus(200e3, .3));
    digits(roller.size, .2406915, "1a: a");
    digits(roller.peak, 2644.962, "1a: p0");
    const PlaneStress axis = hertz_line_axis(.78615 * roller.size, roller.size, roller.peak);
    digits(std::abs(axis.xx - axis.zz) / 2 / roller.peak, .300283, "1a: largest shear", 2e-6);
    const double R = 1 / (1. / 10 + 1. / 20), modulus = contact_modulus(210e3, .3, 70e3, .33);
    const Hertz  pair = hertz_line(500, R, modulus);
    digits(pair.size, .2691079, "1b: a");
    digits(pair.peak, 1182.834, "1b: p0");
    const Hertz nafems = hertz_line(35e3, 50, contact_modulus(210e3, .3, 70e3, .3));
    digits(nafems.size, 6.2146, "1d: a", 1e-5);
    digits(nafems.peak, 3585.36, "1d: p0", 2e-6);
    const Hertz box = hertz_line_of_size(1, 50, contact_modulus(1, .3, 1, .3));
    digits(box.force, 8.630749e-3, "box: P");
    digits(box.peak, 5.494505e-3, "box: p0");

    const Hertz sphere = hertz_point(1000, 10, contact_modulus(200e3, .3));
    digits(sphere.size, .3243577, "2a: a");
    digits(sphere.peak, 4538.297, "2a: p0");
    digits(sphere.approach, .01052079, "2a: delta");
    const Hertz spheres = hertz_point(500, R, modulus);
    digits(spheres.size, .3494094, "2b: a");
    digits(spheres.peak, 1955.429, "2b: p0");
    digits(spheres.approach, .01831304, "2b: delta");
    const EllipticContact crossed =
        crossed_cylinders(1000, 10, 10, pi / 2, contact_modulus(210e3, .3, 210e3, .3));
    digits(crossed.a, .4020726, "2c: a");
    digits(crossed.peak, 2953.469, "2c: p0");
    digits(crossed.approach, .01616624, "2c: delta");
    // across a slender ellipse the contact is a line contact with R = 1/(2 B): b = 2 R p0 / E*
    const EllipticContact slender = hertz_elliptic(10, 1e-7, .05, 1e5);
    is_close(slender.b, slender.peak / (1e5 * .05), 1e-3, "slender ellipse");
    is_close(slender.peak * 2 * pi * slender.a * slender.b / 3, 10, 1e-12, "load of an ellipse");
    const EllipticContact round  = hertz_elliptic(10, .05, .05 * (1 + 1e-6), 1e5),
                          circle = hertz_elliptic(10, .05, .05, 1e5);
    is_close(round.a, circle.a, 1e-5, "a nearly round ellipse");
    is_close(round.approach, circle.approach, 1e-5, "its approach");
    is_close(circle_correction(.1, 2), -.001875, 1e-14, "circle");
    is_close(circle_correction(.1, 3), -.2 / 150, 1e-14, "sphere");
    // Gaps: flat inside; far outside the profile less the penetration
    is_close(hertz_line_gap(.5, 1, 10), 0, 1e-15, "gap inside", 1);
    is_close(hertz_point_gap(100, 1, 10), 100. * 100 / 20 - 1. / 10, 2e-5, "gap of a sphere far away");
  }

  void
  profiles()
  {
    digits(flat_punch_line_pressure(0, 1e4, 10), 318.310, "3a: p(0)", 2e-6);
    digits(flat_punch_line_pressure(9, 1e4, 10), 730.253, "3a: p(9)", 2e-6);
    const double modulus = contact_modulus(200e3, .3), flank = 5 * pi / 180;
    digits(flat_punch_force(10, .01, modulus), 43956.04, "3b: P");
    digits(flat_punch_pressure(0, 2 * pi, 1), 1, "3b: p(0)");
    const Cone c = cone(1000, flank, modulus);
    digits(c.size, .1819575, "3c: a");
    digits(c.approach, .02500584, "3c: delta");
    // P = int 2 pi r p dr (midpoint rule)
    double force = 0;
    for (unsigned int i = 0; i < 20000; ++i)
      {
        const double h = c.size / 20000, r = (i + .5) * h;
        force += 2 * pi * r * cone_pressure(r, c.size, flank, modulus) * h;
      }
    is_close(force, 1000, 1e-4, "load of the cone");
    is_close(line_profile_force([](const double x) { return x / 50; }, 1, contact_modulus(1, .3, 1, .3)),
             8.630749e-3,
             1e-6,
             "a parabola as a profile");
  }

  void
  uniform_pressures()
  {
    digits(two_block_patch(1000, .3, 1, 100, .2, 2, .01, Confinement::plane_strain), .4972650, "patch");
    digits(two_block_patch(1000, .3, 1, 100, .2, 2, .01, Confinement::confined), .5335366, "confined patch");
    const Tube inside = {210e3, .3, 20, 40}, outside = {70e3, .33, 40, 60};
    digits(
        shrink_fit_cylinders(inside, outside, .02, Confinement::plane_strain), 11.177411, "plane strain fit");
    digits(
        shrink_fit_cylinders(inside, outside, .02, Confinement::plane_stress), 10.338037, "plane stress fit");
    digits(shrink_fit_spheres(inside, outside, .02), 27.526733, "spheres");
    digits(tubes_external_pressure(1e6, {1e9, .2, .6, 1}, {1e9, .2, .2, .6}, Confinement::plane_stress),
           .925926e6,
           "rings");
  }

  void
  friction()
  {
    const double modulus = contact_modulus(200e3, .3, 200e3, .3), mu = .3, P = 1000;
    const Hertz  line = hertz_line(P, 10, modulus);
    digits(line.size, .3403892, "Cattaneo: a");
    digits(line.peak, 1870.270, "Cattaneo: p0");
    const double rows[4][4] = {{.25, .866025, .152977e-3, .00311630},
                               {.50, .707107, .463030e-3, .02964258},
                               {.75, .500000, .932919e-3, .12740351},
                               {.90, .316228, 1.332744e-3, .27606798}};
    for (const auto &row : rows)
      {
        const double Q = row[0] * mu * P, c = cattaneo_stick_size(Q, P, mu, line.size);
        digits(c / line.size, row[1], "c/a", 1e-6);
        digits(cattaneo_slip(line.size, c, line.size, 10, mu), row[2], "slip", 4e-6);
        digits(cattaneo_dissipation_per_cycle(P, Q, mu, 10, modulus), row[3], "dissipation", 2e-6);
        is_close(cattaneo_traction_unloading(.3, -Q, Q, P, mu, line.size),
                 -cattaneo_traction(.3, Q, P, mu, line.size),
                 1e-12,
                 "reversal mirrors the loading");
      }
    const Hertz  sphere     = hertz_point(P, 10, modulus);
    const double compliance = mindlin_compliance(200e3, .3, 200e3, .3);
    digits(sphere.size, .4086651, "Mindlin: a");
    digits(sphere.peak, 2858.948, "Mindlin: p0");
    digits(mindlin_stick_radius(150, P, mu, sphere.size) / sphere.size, .793701, "Mindlin: c/a", 1e-6);
    digits(mindlin_displacement(150, P, mu, sphere.size, compliance), 2.251258e-3, "delta_t");
    digits(mindlin_dissipation_per_cycle(150, P, mu, sphere.size, compliance), .05142120, "W");
  }

  // The complex functions and McEwen's real formulas are independent of each other.
  void
  half_plane()
  {
    const double a = 1.3, p0 = 2, mu = .4, P = pi * a * p0 / 2;
    for (const double x : {-3., -1.3, -.7, 0., .2, 1.29, 5.})
      for (const double z : {0., .01, .5, 4.})
        {
          if (std::abs(x) == a && z == 0)
            continue;
          const PlaneStress s        = hertz_line_field(x, z, a, p0, mu);
          const PlaneStress pressure = half_plane_pressure(x, z, 10, .3, {P, a, 0}).stress;
          const PlaneStress shear    = half_plane_shear(x, z, 10, .3, {mu * P, a, 0}).stress;
          is_close(pressure.xx + shear.xx, s.xx, 1e-12, "xx", p0);
          is_close(pressure.zz + shear.zz, s.zz, 1e-12, "zz", p0);
          is_close(pressure.xz + shear.xz, s.xz, 1e-12, "xz", p0);
          is_close(half_plane_pressure(x, 0, 10, .3, {P, a, 0}).stress.zz,
                   -elliptic_pressure(x, a, p0),
                   1e-13,
                   "-p",
                   p0);
        }
    // Hertz's surface shape: u(0) - u(x) = (1-nu^2) p0/(a E) x^2 inside
    const double u0 = half_plane_pressure(0, 0, 10, .3, {P, a, 0}).uz,
                 u  = half_plane_pressure(1, 0, 10, .3, {P, a, 0}).uz;
    is_close(u0 - u, .91 * p0 / (a * 10), 1e-13, "parabolic depression");
    // outside: half of the relative gap of equal bodies is missing, x^2/(2R) - (u0-u) = gap
    const double R  = 10. * a / (2 * .91 * p0);
    const double u3 = half_plane_pressure(3, 0, 10, .3, {P, a, 0}).uz;
    is_close(9 / (2 * R) - (u0 - u3), hertz_line_gap(3, a, R), 1e-13, "gap outside");
    const auto edge = half_plane_pressure(-a, -0., 10, .3, {P, a, 0});
    check::is_true(std::isfinite(edge.ux) && std::isfinite(edge.uz) && std::isfinite(edge.stress.xx), "edge");
  }
} // namespace

int
main(int, char **)
{
  hertz();
  profiles();
  uniform_pressures();
  friction();
  half_plane();
  return check::result();
}
} // namespace test_closed_forms

// Histories of the shear force: tractions, stick sizes and dissipation against the published formulas, the
// loop of force and displacement, and each other.
#include <amontons/verification/closed_forms_friction.h>

#include <check.h>

namespace test_closed_forms_friction
{
using namespace Amontons::ClosedForms;
using check::is_close;

namespace
{
  const double pi = 3.14159265358979323846;
  const double P = 1000, mu = .3, modulus = contact_modulus(200e3, .3, 200e3, .3);

  // Resultant of the shear traction: x = a sin t (line), r = a sin t (sphere); midpoint rule.
  double
  resultant(const ContactShape shape, const ShearState &state, const double a)
  {
    double       sum = 0;
    const double n = 20000, h = pi / 2 / n;
    for (double t = h / 2; t < pi / 2; t += h)
      {
        const double r = a * std::sin(t), dr = a * std::cos(t) * h;
        sum += shear_traction(r, shape, state) * dr * (shape == ContactShape::line ? 2 : 2 * pi * r);
      }
    return sum;
  }

  void
  tractions()
  {
    const double a = hertz_line(P, 10, modulus).size, p0 = 2 * P / (pi * a);
    for (const double Q : {-200., 0., 75., 150., 270.})
      {
        const ShearState state = shear_state(ContactShape::line, {Q, Q, 0}, P, mu, a);
        is_close(state.stick_size, cattaneo_stick_size(Q, P, mu, a), 1e-14, "stick size");
        for (const double x : {0., .1, -.2, .3, .34})
          is_close(shear_traction(x, ContactShape::line, state),
                   Q == 0 ? 0 : cattaneo_traction(x, Q, P, mu, a),
                   1e-13,
                   "first loading",
                   p0);
        is_close(resultant(ContactShape::line, state, a), Q, 1e-5, "resultant of the first loading", 1);
        const ShearState ball = shear_state(ContactShape::sphere, {Q, Q, 0}, P, mu, a);
        is_close(resultant(ContactShape::sphere, ball, a), Q, 1e-5, "resultant on the sphere", 1);
        is_close(shear_traction(.2, ContactShape::sphere, ball),
                 Q == 0 ? 0 : mindlin_traction(.2, Q, P, mu, a),
                 1e-13,
                 "sphere",
                 p0);
      }
    for (const ContactShape shape : {ContactShape::line, ContactShape::sphere})
      for (const double Q_max : {225., -225.})
        for (const double Q : {225., 100., 0., -30., -225.})
          {
            const ShearState back  = shear_state(shape, {Q, Q_max, 1}, P, mu, a),
                             forth = shear_state(shape, {-Q, Q_max, 2}, P, mu, a),
                             again = shear_state(shape, {Q, Q_max, 3}, P, mu, a);
            is_close(resultant(shape, back, a), Q, 1e-5, "resultant on the way back", 10);
            const double peak = shape == ContactShape::line ? p0 : 3 * P / (2 * pi * a * a);
            for (const double x : {0., .05, .15, .25, .3, .33})
              {
                const double q = shear_traction(x, shape, back);
                if (Q_max > 0 && shape == ContactShape::line)
                  is_close(
                      q, cattaneo_traction_unloading(x, Q, Q_max, P, mu, a), 1e-13, "on the way back", p0);
                is_close(shear_traction(x, shape, forth), -q, 1e-13, "the mirror image", peak);
                is_close(shear_traction(x, shape, again), q, 1e-13, "the next cycle", peak);
                check::is_true(std::abs(q) <= mu * elliptic_pressure(x, a, peak) * (1 + 1e-12) + 1e-10,
                               "Coulomb's law");
                if (x > back.stick_size)
                  is_close(q,
                           -std::copysign(mu, Q_max) * elliptic_pressure(x, a, peak),
                           1e-12,
                           "sliding outside of the stick region",
                           peak);
              }
            const ShearState turn  = shear_state(shape, {Q_max, Q_max, 0}, P, mu, a),
                             start = shear_state(shape, {Q_max, Q_max, 1}, P, mu, a);
            is_close(shear_traction(.3, shape, turn),
                     shear_traction(.3, shape, start),
                     1e-13,
                     "no jump where the force turns",
                     peak);
          }
  }

  void
  dissipation()
  {
    const double rows[4][2] = {{.25, .00311630}, {.50, .02964258}, {.75, .12740351}, {.90, .27606798}};
    const auto   line = [](const double Q) { return cattaneo_dissipation_per_cycle(P, Q, mu, 10, modulus); };
    for (const auto &row : rows)
      {
        const double Q = row[0] * mu * P, W = row[1];
        is_close(shear_dissipation({Q, Q, 0}, line), W / 4, 3e-6, "first loading");
        is_close(shear_dissipation({-Q, -Q, 0}, line), W / 4, 3e-6, "first loading in -x");
        is_close(shear_dissipation({Q, Q, 1}, line), W / 4, 3e-6, "nothing yet on the way back");
        is_close(shear_dissipation({-Q, Q, 1}, line), .75 * W, 3e-6, "half a cycle");
        is_close(shear_dissipation({Q, Q, 2}, line), 1.25 * W, 3e-6, "a cycle");
        is_close(shear_dissipation({-Q, -Q, 2}, line), 1.25 * W, 3e-6, "a cycle in -x");
        is_close(shear_dissipation({Q, Q, 6}, line), 3.25 * W, 3e-6, "three cycles");
        is_close(shear_dissipation({0, Q, 1}, line), W / 4 + line(Q / 2) / 2, 3e-6, "half way back");
      }
    // The loop of force and displacement of the sphere: way back delta(Q_max) - 2 delta((Q_max-Q)/2).
    const Hertz  h          = hertz_point(P, 10, modulus);
    const double compliance = mindlin_compliance(200e3, .3, 200e3, .3), Q_max = 150, n = 4000;
    const auto   sphere = [&](const double Q) {
      return mindlin_dissipation_per_cycle(Q, P, mu, h.size, compliance);
    };
    const auto delta = [&](const double Q) {
      return mindlin_displacement(Q_max, P, mu, h.size, compliance) -
             2 * mindlin_displacement((Q_max - Q) / 2, P, mu, h.size, compliance);
    };
    double loop = 0;
    for (double i = 0; i < n; ++i)
      {
        const double Q1 = Q_max * (1 - 2 * i / n), Q2 = Q_max * (1 - 2 * (i + 1) / n);
        loop += (Q1 + Q2) * (delta(Q2) - delta(Q1)); // both halves of the loop
      }
    is_close(shear_dissipation({Q_max, Q_max, 2}, sphere) - shear_dissipation({Q_max, Q_max, 0}, sphere),
             loop,
             1e-5,
             "the loop");
    is_close(loop, .05142120, 1e-5, "its published area");
  }

  void
  program()
  {
    const auto force = [](const double t) { return normal_then_shear(t, -8).shear.Q; };
    is_close(normal_then_shear(0, 8).normal_fraction, 0, 1e-15, "nothing at t = 0", 1);
    is_close(normal_then_shear(.25, 8).normal_fraction, .25, 1e-15, "normal force first");
    is_close(normal_then_shear(1.5, 8).normal_fraction, 1, 1e-15, "and then it stays");
    const double points[][2] = {{.5, 0},
                                {1, 0},
                                {1.25, -2},
                                {2, -8},
                                {2.25, -4},
                                {2.5, 0},
                                {3, 8},
                                {3.5, 0},
                                {4, -8},
                                {5, 8},
                                {5.75, -4}};
    for (const auto &point : points)
      is_close(force(point[0]), point[1], 1e-14, "shear force at t = " + std::to_string(point[0]), 1);
    check::is_true(normal_then_shear(2, 1).shear.reversals == 0 &&
                       normal_then_shear(3, 1).shear.reversals == 1 &&
                       normal_then_shear(3.1, 1).shear.reversals == 2,
                   "reversals");
  }
} // namespace

int
main(int, char **)
{
  tractions();
  dissipation();
  program();
  return check::result();
}
} // namespace test_closed_forms_friction

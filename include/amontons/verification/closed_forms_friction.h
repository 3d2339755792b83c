// Closed-form solutions of frictional contact problems (Coulomb, equal bodies unless said otherwise).
// Sources: Cattaneo (1938); Mindlin (1949); Mindlin and Deresiewicz (1953); [J] Johnson, Contact Mechanics
// (1985), ch. 7.
#pragma once

#include <amontons/verification/closed_forms.h>

#include <vector>

namespace Amontons
{
  namespace ClosedForms
  {
    // Line contact, normal load P first, then Q <= mu P: c = a sqrt(1 - Q/(mu P)); [J] sec. 7.2
    double
    cattaneo_stick_size(const double Q, const double P, const double mu, const double a);
    // q = mu [p_a - p_c] with p_s = (p0 s/a) sqrt(1-x^2/s^2); [J] sec. 7.2
    double
    cattaneo_traction(const double x, const double Q, const double P, const double mu, const double a);
    // Unloading from Q_max to Q: q = mu [-p_a + 2 p_c1 - p_c], c1 = a sqrt(1-(Q_max-Q)/(2 mu P))
    double
    cattaneo_traction_unloading(
        const double x, const double Q, const double Q_max, const double P, const double mu, const double a);
    // Relative slip on c < |x| < a: (mu/(2R)) [x sqrt(x^2-c^2) - c^2 arccosh(x/c)]
    double
    cattaneo_slip(const double x, const double c, const double a, const double R, const double mu);
    // Dissipation of one cycle +-Q: (4 mu^2/R) int_c^a p [x sqrt(x^2-c^2) - c^2 arccosh(x/c)] dx; the first
    // loading: a quarter.
    double
    cattaneo_dissipation_per_cycle(
        const double P, const double Q, const double mu, const double R, const double modulus);

    // Sphere: c = a (1 - Q/(mu P))^(1/3); [J] sec. 7.2
    double
    mindlin_stick_radius(const double Q, const double P, const double mu, const double a);
    double
    mindlin_traction(const double r, const double Q, const double P, const double mu, const double a);
    // compliance = (2-nu1)/G1 + (2-nu2)/G2; delta_t = (3 mu P/(16 a)) compliance [1-(1-Q/(mu P))^(2/3)]; [J]
    // sec. 7.2
    double
    mindlin_compliance(const double E1, const double nu1, const double E2 = rigid, const double nu2 = 0);
    double
    mindlin_displacement(
        const double Q, const double P, const double mu, const double a, const double compliance);
    // Of one cycle +-Q: (9 mu^2 P^2/(10 a)) compliance [1-t^(5/3) - (5s/6)(1+t^(2/3))], s = Q/(mu P), t = 1-s
    // [J] (7.57)
    double
    mindlin_dissipation_per_cycle(
        const double Q, const double P, const double mu, const double a, const double compliance);

    // ---- Histories of the shear force under a constant normal force P; Mindlin and Deresiewicz, [J]
    // sec. 7.4.

    enum class ContactShape
    {
      line,
      sphere
    };

    // How the shear force came to Q. reversals = 0: first loading; odd: on the way from Q_max to -Q_max;
    // even: on the way back. |Q| <= |Q_max| <= mu P.
    struct ShearHistory
    {
      double       Q = 0, Q_max = 0;
      unsigned int reversals = 0;
    };

    // With p_s the Hertz pressure scaled to s, of resultant P (s/a)^2 (sphere: ^3), and s(Q) the stick size
    // of the first loading:
    //   first loading: q = mu [p_a - p_s(Q)];  on the way from Q_max: q = mu [-p_a + 2 p_s((Q_max-Q)/2) -
    //   p_s(Q_max)],
    // and the way back is the mirror image. Elliptic tractions of these resultants and sizes:
    struct ShearState
    {
      std::vector<EllipticTraction> tractions;
      double                        stick_size;
    };
    ShearState
    shear_state(const ContactShape  shape,
                const ShearHistory &history,
                const double        P,
                const double        mu,
                const double        a);
    double
    shear_traction(const double r, const ContactShape shape, const ShearState &state);

    // Work of friction from the beginning, where one cycle +-Q costs W(Q). The first loading to Q costs
    // W(Q)/4. On the way from Q_max to Q the slip is twice that of a first loading to (Q_max-Q)/2 while the
    // traction of the sliding part is mu p again, which costs W((Q_max-Q)/2)/2.
    double
    shear_dissipation(const ShearHistory &history, const std::function<double(double)> &cost_of_cycle);

    // Normal force first, then shear to and fro, all linear in t: the normal force is the fraction t of P on
    // [0, 1] and P from then on; the shear force is 0 at t = 1, Q_max at t = 2, -Q_max at t = 3, Q_max at t =
    // 4, ...
    struct NormalThenShear
    {
      double       normal_fraction;
      ShearHistory shear;
    };
    NormalThenShear
    normal_then_shear(const double t, const double Q_max);
  } // namespace ClosedForms
} // namespace Amontons

#include <amontons/verification/closed_forms_friction.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace ClosedForms
  {
    namespace
    {
      // x sqrt(x^2-c^2) - c^2 arccosh(x/c) for |x| > c, else 0
      double
      slip_function(const double x, const double c)
      {
        const double X = std::abs(x);
        if (X <= c)
          return 0;
        return X * std::sqrt(X * X - c * c) - (c > 0 ? c * c * std::acosh(X / c) : 0);
      }

      // p_s of the header; zero for s = 0
      double
      scaled_ellipse(const double x, const double p0, const double s, const double a)
      {
        return s > 0 ? elliptic_pressure(x, s, p0 * s / a) : 0;
      }
    } // namespace

    double
    cattaneo_stick_size(const double Q, const double P, const double mu, const double a)
    {
      return a * std::sqrt(std::max(0., 1 - std::abs(Q) / (mu * P)));
    }

    double
    cattaneo_traction(const double x, const double Q, const double P, const double mu, const double a)
    {
      const double p0 = 2 * P / (pi * a), c = cattaneo_stick_size(Q, P, mu, a);
      return std::copysign(mu, Q) * (scaled_ellipse(x, p0, a, a) - scaled_ellipse(x, p0, c, a));
    }

    double
    cattaneo_traction_unloading(
        const double x, const double Q, const double Q_max, const double P, const double mu, const double a)
    {
      const double p0 = 2 * P / (pi * a), c = cattaneo_stick_size(Q_max, P, mu, a);
      const double c1 = cattaneo_stick_size((Q_max - Q) / 2, P, mu, a);
      return mu *
             (-scaled_ellipse(x, p0, a, a) + 2 * scaled_ellipse(x, p0, c1, a) - scaled_ellipse(x, p0, c, a));
    }

    double
    cattaneo_slip(const double x, const double c, const double a, const double R, const double mu)
    {
      return std::abs(x) <= a ? mu / (2 * R) * slip_function(x, c) : 0;
    }

    // W = (4 mu^2/R) int_c^a p(x) [x sqrt(x^2-c^2) - c^2 arccosh(x/c)] dx, with x = a sin t.
    double
    cattaneo_dissipation_per_cycle(
        const double P, const double Q, const double mu, const double R, const double modulus)
    {
      const Hertz             h = hertz_line(P, R, modulus);
      const double            c = cattaneo_stick_size(Q, P, mu, h.size), begin = std::asin(c / h.size);
      const dealii::QGauss<1> quadrature(200);
      double                  integral = 0;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double t = begin + (pi / 2 - begin) * quadrature.point(q)[0];
          integral += h.peak * h.size * std::cos(t) * std::cos(t) * slip_function(h.size * std::sin(t), c) *
                      (pi / 2 - begin) * quadrature.weight(q);
        }
      return 4 * mu * mu / R * integral;
    }

    double
    mindlin_stick_radius(const double Q, const double P, const double mu, const double a)
    {
      return a * std::cbrt(std::max(0., 1 - std::abs(Q) / (mu * P)));
    }

    double
    mindlin_traction(const double r, const double Q, const double P, const double mu, const double a)
    {
      const double p0 = 3 * P / (2 * pi * a * a), c = mindlin_stick_radius(Q, P, mu, a);
      return std::copysign(mu, Q) * (scaled_ellipse(r, p0, a, a) - scaled_ellipse(r, p0, c, a));
    }

    double
    mindlin_compliance(const double E1, const double nu1, const double E2, const double nu2)
    {
      return (2 - nu1) * 2 * (1 + nu1) / E1 + (2 - nu2) * 2 * (1 + nu2) / E2;
    }

    double
    mindlin_displacement(
        const double Q, const double P, const double mu, const double a, const double compliance)
    {
      const double t = 1 - std::abs(Q) / (mu * P);
      return 3 * mu * P / (16 * a) * compliance * (1 - std::pow(t, 2. / 3.));
    }

    double
    mindlin_dissipation_per_cycle(
        const double Q, const double P, const double mu, const double a, const double compliance)
    {
      const double s = Q / (mu * P), t = 1 - s;
      return 9 * mu * mu * P * P / (10 * a) * compliance *
             (1 - std::pow(t, 5. / 3.) - 5 * s / 6 * (1 + std::pow(t, 2. / 3.)));
    }

    namespace
    {
      // The shear force of the first loading that has the slip of the present half cycle, halved.
      double
      half_of_way_back(const ShearHistory &h)
      {
        const double sign = (h.reversals % 2 == 1 ? 1 : -1) * std::copysign(1., h.Q_max);
        return (std::abs(h.Q_max) - sign * h.Q) / 2;
      }
    } // namespace

    ShearState
    shear_state(
        const ContactShape shape, const ShearHistory &h, const double P, const double mu, const double a)
    {
      const bool   line = shape == ContactShape::line;
      ShearState   state{{}, a};
      const double largest = h.reversals == 0 ? h.Q : h.Q_max;
      if (largest == 0)
        return state;

      const auto stick = [&](const double Q) {
        return line ? cattaneo_stick_size(Q, P, mu, a) : mindlin_stick_radius(Q, P, mu, a);
      };
      const auto add = [&](const double factor, const double s) {
        if (s > 0)
          state.tractions.push_back(
              {factor * mu * P * (line ? std::pow(s / a, 2) : std::pow(s / a, 3)), s, 0});
      };
      double sign = std::copysign(1., largest);
      if (h.reversals == 0)
        {
          state.stick_size = stick(h.Q);
          add(sign, a);
          add(-sign, state.stick_size);
        }
      else
        {
          sign *= h.reversals % 2 == 1 ? -1 : 1;
          state.stick_size = stick(half_of_way_back(h));
          add(sign, a);
          add(-2 * sign, state.stick_size);
          add(sign, stick(h.Q_max));
        }
      return state;
    }

    double
    shear_traction(const double r, const ContactShape shape, const ShearState &state)
    {
      double q = 0;
      for (const EllipticTraction &t : state.tractions)
        {
          const double peak = shape == ContactShape::line ? 2 * t.force / (pi * t.size)
                                                          : 3 * t.force / (2 * pi * t.size * t.size);
          q += elliptic_pressure(r, t.size, peak);
        }
      return q;
    }

    double
    shear_dissipation(const ShearHistory &h, const std::function<double(double)> &cost_of_cycle)
    {
      if (h.reversals == 0)
        return cost_of_cycle(std::abs(h.Q)) / 4;
      return (0.25 + 0.5 * (h.reversals - 1)) * cost_of_cycle(std::abs(h.Q_max)) +
             cost_of_cycle(half_of_way_back(h)) / 2;
    }

    NormalThenShear
    normal_then_shear(const double t, const double Q_max)
    {
      if (t <= 1)
        return {std::max(0., t), {}};
      if (t <= 2)
        return {1, {Q_max * (t - 1), Q_max, 0}};
      const double reversals = std::ceil(t - 2), part = t - 1 - reversals;
      const auto   n = static_cast<unsigned int>(reversals);
      return {1, {(n % 2 == 1 ? 1 : -1) * Q_max * (1 - 2 * part), Q_max, n}};
    }
  } // namespace ClosedForms
} // namespace Amontons

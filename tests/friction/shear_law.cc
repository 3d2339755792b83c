// The linearised law of a slipping node is the derivative of q(p, v) = phi(p) v/|v|; its fixed points obey
// the law.
#include "check.h"

#include <amontons/friction/shear_law.h>

namespace test_shear_law
{
using namespace Amontons;

PairData
pair_with(const std::string &friction, const std::string &tresca)
{
  PairData             pair;
  const SourceLocation where;
  if (!friction.empty())
    pair.friction = Expression(friction, where, {"x", "y", "z", "t", "p"});
  if (!tresca.empty())
    pair.tresca_bound = Expression(tresca, where, {"x", "y", "z", "t", "p"});
  return pair;
}

void
check_bounds()
{
  const Point<3> X(2, 0, 0);
  const auto     coulomb = shear_bound(pair_with("0.3", ""), X, 0, 5);
  check::is_close(coulomb.value, 1.5, 1e-14, "Coulomb: bound");
  check::is_close(coulomb.slope, 0.3, 1e-14, "Coulomb: slope");
  check::is_close(shear_bound(pair_with("0.3", ""), X, 0, -1).value, 0, 0, "no bound under tension", 1);
  check::is_close(shear_bound(pair_with("0.3", ""), X, 0, 0).slope, 0.3, 1e-14, "slope at p = 0");
  const auto tresca = shear_bound(pair_with("", "7*x"), X, 0, 5);
  check::is_close(tresca.value, 14, 1e-14, "Tresca: bound");
  check::is_close(tresca.slope, 0, 1e-12, "Tresca: slope", 1);
  const auto both = shear_bound(pair_with("0.3", "1"), X, 0, 5);
  check::is_close(both.value, 1, 1e-14, "both: the smaller one");
  check::is_close(both.slope, 0, 1e-12, "both: slope", 1);
  const auto varying = shear_bound(pair_with("0.1*t*(1 + p/10)", ""), X, 2, 5);
  check::is_close(varying.value, 1.5, 1e-12, "of t and p: bound");
  check::is_close(varying.slope, 0.2 * (1 + 1), 1e-6, "of t and p: slope");
  // phi = p / (1 + p/50), phi' = 1 / (1 + p/50)^2; from p = 0 on
  const auto saturating = shear_bound(pair_with("1/(1 + p/50)", ""), X, 0, 100);
  check::is_close(saturating.value, 100. / 3, 1e-12, "saturating: bound");
  check::is_close(saturating.slope, 1. / 9, 1e-6, "saturating: slope");
  check::is_close(
      shear_bound(pair_with("1/(1 + p/50)", ""), X, 0, 0).slope, 1, 1e-6, "saturating: slope at p = 0");
  check::is_close(shear_bound(pair_with("-1", ""), X, 0, 5).value, 0, 0, "no negative bound", 1);
  check::is_true(pair_with("", "1").has_friction() && !PairData().has_friction(), "has_friction");
}

template <int dim>
Tensor<1, dim>
exact(const Tensor<1, dim> &v, const ShearBound &bound)
{
  return bound.value / v.norm() * v;
}

// At a point that obeys the law the linearised one gives the same q and, for small changes of p and v, the
// same change to second order.
template <int dim>
void
check_derivative(const Tensor<1, dim> &v, const Tensor<1, dim> &dv, const std::string &mu)
{
  const auto        pair = pair_with(mu, "");
  const double      p = 4, c = 50;
  const Point<3>    X;
  const auto        bound = shear_bound(pair, X, 0, p);
  const auto        q     = exact(v, bound);
  const auto        law   = linearise_slip(q + c * v, p, bound, c);
  const std::string what  = std::to_string(dim) + "D, mu = " + mu + ": ";
  check::is_close((law.traction(p, v) - q).norm(), 0, 1e-12, what + "value", q.norm());
  double last = 0;
  for (const double step : {1e-2, 1e-3})
    {
      const auto   now   = exact(v + step * dv, shear_bound(pair, X, 0, p * (1 + step)));
      const double error = (law.traction(p * (1 + step), v + step * dv) - now).norm() / q.norm();
      check::is_true(last == 0 || error < 0.02 * last || error < 1e-9,
                     what + "derivative is of second order");
      last = error;
    }
}

// A closing node: q = phi(p) v / sqrt(|v|^2 + d^2). The linearised law has its value and its derivatives.
template <int dim>
void
check_closing(const Tensor<1, dim> &v, const Tensor<1, dim> &dv, const std::string &mu)
{
  const auto   pair = pair_with(mu, "");
  const double p = 4, distance = 0.3;
  const auto   bound = shear_bound(pair, Point<3>(), 0, p);
  const auto   exact = [&](const Tensor<1, dim> &slip, const double pressure) {
    return shear_bound(pair, Point<3>(), 0, pressure).value / std::hypot(slip.norm(), distance) * slip;
  };
  const auto        law  = linearise_closing(v, p, bound, distance);
  const std::string what = "closing, " + std::to_string(dim) + "D, mu = " + mu + ": ";
  check::is_close((law.traction(p, v) - exact(v, p)).norm(), 0, 1e-12, what + "value", bound.value);
  double last = 0;
  for (const double step : {1e-2, 1e-3})
    {
      const auto   now   = exact(v + step * dv, p * (1 + step));
      const double error = (law.traction(p * (1 + step), v + step * dv) - now).norm() / bound.value;
      check::is_true(error < 1e-9 || (last > 0 && error < 0.02 * last) || (last == 0 && error < step),
                     what + "derivative is of second order");
      last = error;
    }
}

// A closing node on a spring, stiffness v + phi v/sqrt(v^2 + d^2) = force: Newton's iteration with force <
// phi and a stiffness that lets it overshoot. The potential is convex, so that there is one solution, found
// here by bisection.
void
check_swinging(const double stiffness, const double force, const double distance)
{
  const ShearBound bound{1., 0.};
  const auto       excess = [&](const double v) {
    return stiffness * v + bound.value * v / std::hypot(v, distance) - force;
  };
  double lower = 0, upper = force / stiffness;
  for (unsigned int n = 0; n < 200; ++n)
    (excess((lower + upper) / 2) < 0 ? lower : upper) = (lower + upper) / 2;

  ClosingSlip<2> slip;
  Tensor<1, 2>   v({force / stiffness, 0.});
  unsigned int   n = 0;
  for (; n < 100 && std::abs(excess(v[0])) > 1e-10 * force; ++n)
    {
      const auto law = linearise_closing(slip.where(v), 1., bound, distance);
      // (stiffness + along) v = force - constant along the direction
      const double q0 = law.traction(1., Tensor<1, 2>())[0];
      v[0]            = (force - q0) / (stiffness + (law.direction.norm() > 0 ? law.along : law.stiffness));
    }
  check::is_true(n < 40, "a closing node comes to rest, after " + std::to_string(n) + " iterations");
  check::is_close(v[0], lower, 1e-8, "its slip", force / stiffness);
}

int
main(int, char **)
{
  for (const double distance : {1e-1, 1e-3, 1e-6})
    for (const double force : {0.01, 0.5, 0.9, 0.99, 1.1})
      check_swinging(1e-2, force, distance);
  check_bounds();
  for (const std::string mu : {"0.3", "0.2 + 0.1*p"})
    {
      check_closing<2>(Tensor<1, 2>({0.3, 0.}), Tensor<1, 2>({0.2, 0.}), mu);
      check_closing<2>(Tensor<1, 2>(), Tensor<1, 2>({0.2, 0.}), mu);
      check_closing<3>(Tensor<1, 3>({0.3, 0.4, 0.}), Tensor<1, 3>({0.2, -0.3, 0.}), mu);
    }
  for (const std::string mu : {"0.3", "0.2 + 0.1*p"})
    {
      check_derivative<2>(Tensor<1, 2>({0.3, 0.}), Tensor<1, 2>({0.2, 0.}), mu);
      check_derivative<3>(Tensor<1, 3>({0.3, 0.4, 0.}), Tensor<1, 3>({0.2, -0.3, 0.}), mu);
    }
  // Whatever the trial, the linearised law only has fixed points with q along v.
  const auto law = linearise_slip(Tensor<1, 3>({1., 0., 0.}), 1, ShearBound{0.9, 0.9}, 10);
  check::is_close(law.stiffness, 90, 1e-12, "stiffness across the slip");
  return check::result();
}
} // namespace test_shear_law

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

int
main(int, char **)
{
  check_bounds();
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

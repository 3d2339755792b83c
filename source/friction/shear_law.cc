#include <amontons/friction/shear_law.h>

namespace Amontons
{
  namespace
  {
    double
    bound_value(const PairData &pair, const Point<3> &X, const double t, const double p)
    {
      const double coulomb =
          pair.friction ? pair.friction->value(X, t, p) * p : std::numeric_limits<double>::max();
      const double tresca =
          pair.tresca_bound ? pair.tresca_bound->value(X, t, p) : std::numeric_limits<double>::max();
      return std::max(0., std::min(coulomb, tresca));
    }
  } // namespace

  // The expressions are the user's, without derivatives: differences, exact for constant coefficients.
  ShearBound
  shear_bound(const PairData &pair, const Point<3> &X, const double t, const double pressure)
  {
    if (!pair.friction && !pair.tresca_bound)
      return {};
    const double p = std::max(0., pressure), step = p > 0 ? 1e-6 * p : 1e-100;
    ShearBound   bound;
    bound.value = bound_value(pair, X, t, p);
    bound.slope = (bound_value(pair, X, t, p + step) - bound_value(pair, X, t, std::max(0., p - step))) /
                  (step + std::min(p, step));
    const bool constant = !pair.tresca_bound && pair.friction->is_constant();
    if (constant)
      bound.slope = pair.friction->value(X, t, p);
    return bound;
  }

  void
  refuse_negative_bound(const PairData &pair, const Point<3> &X, const double t, const double pressure)
  {
    for (const auto *const expression : {&pair.friction, &pair.tresca_bound})
      if (*expression)
        (*expression)->refuse_negative(X, t, pressure);
  }

  template <int dim>
  Tensor<1, dim>
  SlipLaw<dim>::traction(const double pressure, const Tensor<1, dim> &slip) const
  {
    return (constant + slope * pressure) * direction + stiffness * (slip - (slip * direction) * direction);
  }

  template <int dim>
  SlipLaw<dim>
  linearise_slip(const Tensor<1, dim> &trial, const double pressure, const ShearBound &bound, const double c)
  {
    SlipLaw<dim> law;
    const double norm = trial.norm();
    if (norm > 0)
      law.direction = trial / norm;
    //! [law of a slipping node]
    law.slope    = bound.slope;
    law.constant = bound.value - bound.slope * std::max(0., pressure);
    if (std::abs(law.constant) <= 1e-12 * bound.value)
      law.constant = 0;
    if (dim == 3)
      law.stiffness = std::min(1e4 * c, bound.value * c / std::max(norm - bound.value, 1e-100));
    //! [law of a slipping node]
    return law;
  }

  template struct SlipLaw<2>;
  template struct SlipLaw<3>;
  template SlipLaw<2>
  linearise_slip(const Tensor<1, 2> &, const double, const ShearBound &, const double);
  template SlipLaw<3>
  linearise_slip(const Tensor<1, 3> &, const double, const ShearBound &, const double);
} // namespace Amontons

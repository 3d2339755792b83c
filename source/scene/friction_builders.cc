// References with friction: Cattaneo's line contact and Mindlin's sphere, with the history of the shear
// force.
#include <amontons/base/closed_forms_friction.h>
#include <amontons/scene/reference_builders.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    // Q alone: first loading. Q_max: on the way back, after the given number of reversals.
    ClosedForms::ShearHistory
    read_history(const ClosedFormArguments &get)
    {
      ClosedForms::ShearHistory h;
      const double              limit = get("friction") * get("P") * (1 + 1e-12);
      h.Q                             = get("Q");
      h.Q_max                         = get.is_given("Q_max") ? get("Q_max") : h.Q;
      if (get.is_given("Q_max") || get.is_given("reversals"))
        {
          const double n = get.is_given("reversals") ? get("reversals") : 1;
          if (!get.is_given("Q_max"))
            get.fail("found reversals without Q_max", "both, or none for the first loading");
          if (n != std::floor(n) || n > 1e6)
            get.fail("found a number of reversals that is no integer", "reversals = 1, 2, 3, ...");
          h.reversals = static_cast<unsigned int>(n);
        }
      if (std::abs(h.Q_max) > limit)
        get.fail("found a shear force that friction cannot carry", "|Q|, |Q_max| <= friction P");
      if (std::abs(h.Q) > std::abs(h.Q_max))
        get.fail("found |Q| > |Q_max|", "Q between -Q_max and Q_max");
      return h;
    }
  } // namespace

  void
  set_shear(const ClosedForms::ShearHistory &history,
            const ClosedForms::ContactShape  shape,
            const double                     mu,
            ReferenceSolution               &s)
  {
    const auto state   = ClosedForms::shear_state(shape, history, *s.normal_force, mu, *s.contact_size);
    s.tangential_force = history.Q;
    s.stick_size       = state.stick_size;
    s.shear_traction   = [=](const double x) { return ClosedForms::shear_traction(x, shape, state); };
  }

  ReferenceSolution
  ReferenceBuilders::cattaneo_mindlin(const ClosedFormArguments &get, const Scene &scene)
  {
    const double      modulus = contact_modulus(get, scene), mu = get("friction");
    const auto        history = read_history(get);
    ReferenceSolution s       = hertz_solution(get, ClosedForms::hertz_line(get("P"), get("R"), modulus));
    set_shear(history, ClosedForms::ContactShape::line, mu, s);
    s.dissipation = ClosedForms::shear_dissipation(history, [&](const double Q) {
      return ClosedForms::cattaneo_dissipation_per_cycle(get("P"), Q, mu, get("R"), modulus);
    });
    return s;
  }

  ReferenceSolution
  ReferenceBuilders::mindlin_sphere(const ClosedFormArguments &get, const Scene &scene)
  {
    const double mu      = get("friction");
    const auto   history = read_history(get);
    const auto   hertz   = ClosedForms::hertz_point(get("P"), get("R"), contact_modulus(get, scene));
    const double compliance =
        get.is_given("E2") ? ClosedForms::mindlin_compliance(get("E1"), get("nu1"), get("E2"), get("nu2"))
                           : ClosedForms::mindlin_compliance(get("E1"), get("nu1"));
    ReferenceSolution s = hertz_solution(get, hertz);
    set_shear(history, ClosedForms::ContactShape::sphere, mu, s);
    s.dissipation = ClosedForms::shear_dissipation(history, [&](const double Q) {
      return ClosedForms::mindlin_dissipation_per_cycle(Q, get("P"), mu, hertz.size, compliance);
    });
    return s;
  }
} // namespace Amontons

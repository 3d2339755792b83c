// Cattaneo's line contact, Mindlin's sphere, and the shear of two half bodies.
#include <amontons/verification/half_body_side.h>
#include <amontons/verification/half_plane_field.h>
#include <amontons/verification/half_space_field.h>
#include <amontons/verification/reference_builders.h>

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

    // Similar bodies: shear tractions leave the gap as it is, since (1-2 nu) (1+nu)/E, in plane stress
    // (1-nu)/E, are the same in both.
    void
    check_similarity(const ClosedFormArguments &get, const Scene &scene)
    {
      const auto value = [&](const double E, const double nu) {
        return scene.kind == ProblemType::plane_stress ? (1 - nu) / E : (1 - 2 * nu) * (1 + nu) / E;
      };
      const double first  = value(get("E1"), get("nu1")),
                   second = get.is_given("E2") ? value(get("E2"), get("nu2")) : 0;
      if (std::abs(first - second) > 1e-9 * (first + second))
        get.fail("found friction between bodies that are not elastically similar", "E1 = E2 and nu1 = nu2");
    }

    // The shear force on the slave in +x has this sign if that on the lower body is positive.
    int
    sign_of_slave(const Scene        &scene,
                  const Point<3>     &centre,
                  const double        size,
                  const unsigned int  axis,
                  const MaterialData &lower)
    {
      const std::string name = scene.reference ? scene.reference->pair : "";
      const PairData   *pair = nullptr;
      for (const PairData &candidate : scene.pairs)
        if (pair == nullptr && (name.empty() || candidate.name == name))
          pair = &candidate;
      if (pair == nullptr || pair->slave == PairData::Slave::automatic)
        return 1;
      const bool      first = pair->slave == PairData::Slave::first || !pair->second;
      const TwoHalves halves(centre, size, axis, lower, lower, scene.bodies);
      return -halves.side(first ? pair->first.body : pair->second->body, centre);
    }
  } // namespace

  double
  mindlin_compliance(const ClosedFormArguments &get)
  {
    return get.is_given("E2") ? ClosedForms::mindlin_compliance(get("E1"), get("nu1"), get("E2"), get("nu2"))
                              : ClosedForms::mindlin_compliance(get("E1"), get("nu1"));
  }

  void
  set_shear(const ClosedForms::ShearHistory &history,
            const ClosedForms::ContactShape  shape,
            const double                     mu,
            ReferenceSolution               &s)
  {
    const auto state   = ClosedForms::shear_state(shape, history, *s.normal_force, mu, *s.contact_size);
    s.tangential_force = history.Q;
    s.stick_size       = state.stick_size;
    // after a reversal only at its end
    s.unused_shear_is_hertzian =
        history.reversals == 0 || std::abs(history.Q) >= (1 - 1e-9) * std::abs(history.Q_max);
    s.shear_traction = [=](const double x) { return ClosedForms::shear_traction(x, shape, state); };
  }

  template <typename Field>
  void
  set_shear_of_halves(const ClosedFormArguments           &get,
                      const Scene                         &scene,
                      ClosedForms::ShearHistory            history,
                      const Field                         &lower,
                      ReferenceSolution                   &s,
                      const std::function<double(double)> &cost_of_cycle)
  {
    check_similarity(get, scene);
    s.dissipation = ClosedForms::shear_dissipation(history, cost_of_cycle);
    const int sign =
        sign_of_slave(scene, lower.centre, lower.size, normal_axis(scene.kind), {get("E1"), get("nu1")});
    history.Q *= sign;
    history.Q_max *= sign;
    set_shear(history, Field::shape, get("friction"), s);
  }

  template void
  set_shear_of_halves(const ClosedFormArguments &,
                      const Scene &,
                      ClosedForms::ShearHistory,
                      const HalfPlaneField &,
                      ReferenceSolution &,
                      const std::function<double(double)> &);
  template void
  set_shear_of_halves(const ClosedFormArguments &,
                      const Scene &,
                      ClosedForms::ShearHistory,
                      const HalfSpaceField &,
                      ReferenceSolution &,
                      const std::function<double(double)> &);

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
    const double      mu      = get("friction");
    const auto        history = read_history(get);
    const auto        hertz   = ClosedForms::hertz_point(get("P"), get("R"), contact_modulus(get, scene));
    ReferenceSolution s       = hertz_solution(get, hertz);
    set_shear(history, ClosedForms::ContactShape::sphere, mu, s);
    s.dissipation = ClosedForms::shear_dissipation(history, [&](const double Q) {
      return ClosedForms::mindlin_dissipation_per_cycle(Q, get("P"), mu, hertz.size, mindlin_compliance(get));
    });
    return s;
  }
} // namespace Amontons

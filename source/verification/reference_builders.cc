#include <amontons/verification/reference_builders.h>
#include <amontons/verification/closed_forms.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Amontons
{
  using Arguments = ClosedFormArguments;
  using ClosedForms::Confinement;

  namespace
  {
    void
    check_pair(const Arguments &get)
    {
      if (get.is_given("nu2") != get.is_given("E2"))
        get.fail("one of E2 and nu2 is missing", "both, or none for a rigid body");
    }

  } // namespace

  double
  contact_modulus(const Arguments &get, const Scene &scene)
  {
    check_pair(get);
    const double E2 = get.is_given("E2") ? get("E2") : ClosedForms::rigid;
    if (scene.kind == ProblemType::plane_stress)
      return ClosedForms::contact_modulus_plane_stress(get("E1"), E2);
    return ClosedForms::contact_modulus(get("E1"), get("nu1"), E2, get.is_given("nu2") ? get("nu2") : 0);
  }

  ReferenceSolution
  hertz_solution(const Arguments &get, const ClosedForms::Hertz &h)
  {
    ReferenceSolution s;
    s.normal_force   = h.force;
    s.contact_size   = h.size;
    s.peak_pressure  = h.peak;
    s.pressure       = [h](const double r) { return ClosedForms::elliptic_pressure(r, h.size, h.peak); };
    s.pressure_range = 1.3 * h.size;
    s.centre         = get.centre();
    if (!std::isnan(h.approach))
      s.approach = h.approach;
    return s;
  }

  namespace
  {
    // A constant pressure; `range` unless the user gave a width.
    ReferenceSolution
    uniform_solution(const Arguments &get, const double p, const double range)
    {
      ReferenceSolution s;
      s.peak_pressure  = p;
      s.pressure       = [p](const double) { return p; };
      s.pressure_range = get.is_given("width") ? get("width") : range;
      s.centre         = get.centre();
      return s;
    }

    Confinement
    confinement(const Arguments &get, const Scene &scene)
    {
      const bool plane_stress =
          get.is_given("plane_stress") ? get("plane_stress") != 0 : scene.kind == ProblemType::plane_stress;
      return plane_stress ? Confinement::plane_stress : Confinement::plane_strain;
    }

    ReferenceSolution
    flat_punch(const double P, const double a, const std::function<double(double)> &pressure)
    {
      ReferenceSolution s;
      s.normal_force   = P;
      s.contact_size   = a;
      s.pressure       = pressure;
      s.pressure_range = 0.9 * a;
      return s;
    }

    ReferenceSolution
    shrink_fit(const Arguments &get, const Scene &scene, const bool spheres)
    {
      const double rc = get("rc");
      if (!(get("ri") < rc && rc < get("ro")))
        get.fail("found radii that do not grow", "ri < rc < ro");
      const ClosedForms::Tube inside  = {get("Ei"), get("nui"), get("ri"), rc},
                              outside = {get("Eo"), get("nuo"), rc, get("ro")};
      const double delta              = get("delta");
      return uniform_solution(
          get,
          spheres ? ClosedForms::shrink_fit_spheres(inside, outside, delta)
                  : ClosedForms::shrink_fit_cylinders(inside, outside, delta, confinement(get, scene)),
          2 * rc);
    }

  } // namespace

  namespace ReferenceBuilders
  {
    ReferenceSolution
    hertz_line(const Arguments &get, const Scene &scene)
    {
      return hertz_solution(get, ClosedForms::hertz_line(get("P"), get("R"), contact_modulus(get, scene)));
    }

    ReferenceSolution
    hertz_point(const Arguments &get, const Scene &scene)
    {
      return hertz_solution(get, ClosedForms::hertz_point(get("P"), get("R"), contact_modulus(get, scene)));
    }

    // Radii that are not given are those of planes. The ellipse's first axis is the long one.
    ReferenceSolution
    hertz_elliptic(const Arguments &get, const Scene &scene)
    {
      const auto curvature = [&](const char *const radius) {
        return get.is_given(radius) ? 1 / get(radius) : 0.;
      };
      const auto gap = ClosedForms::quadratic_gap(curvature("R1x"),
                                                  curvature("R1y"),
                                                  curvature("R2x"),
                                                  curvature("R2y"),
                                                  get("angle") * dealii::numbers::PI / 180);
      if (!(gap.A > 1e-14 * gap.B))
        get.fail("found radii of surfaces that do not touch in a point",
                 "R1x, R1y, R2x, R2y (left out: plane; negative: concave) with a gap that grows in all "
                 "directions");
      const auto        e = ClosedForms::hertz_elliptic(get("P"), gap.A, gap.B, contact_modulus(get, scene));
      ReferenceSolution s;
      s.normal_force       = get("P");
      s.contact_size       = e.a;
      s.peak_pressure      = e.peak;
      s.approach           = e.approach;
      s.pressure           = [e](const double r) { return ClosedForms::elliptic_pressure(r, e.a, e.peak); };
      s.pressure_range     = 1.3 * e.a;
      s.centre             = get.centre();
      const double       c = std::cos(gap.direction), d = std::sin(gap.direction);
      const Tensor<1, 3> first({c, d, 0.}), second({-d, c, 0.});
      s.ellipse = {e.b, {{first, second}}, [=](const Tensor<1, 3> &x) {
                     return ClosedForms::elliptic_pressure(
                         std::hypot(x * first / e.a, x * second / e.b), 1, e.peak);
                   }};
      return s;
    }

    ReferenceSolution
    flat_punch_line(const Arguments &get, const Scene &)
    {
      const double      P = get("P"), a = get("a");
      ReferenceSolution s =
          flat_punch(P, a, [=](const double x) { return ClosedForms::flat_punch_line_pressure(x, P, a); });
      s.size_factor = 2;
      s.centre      = get.centre();
      return s;
    }

    ReferenceSolution
    flat_punch_axisymmetric(const Arguments &get, const Scene &)
    {
      const double      a = get("a"), modulus = ClosedForms::contact_modulus(get("E"), get("nu"));
      const double      P = ClosedForms::flat_punch_force(a, get("delta"), modulus);
      ReferenceSolution s =
          flat_punch(P, a, [=](const double r) { return ClosedForms::flat_punch_pressure(r, P, a); });
      s.size_factor = 1.5;
      s.approach    = get("delta");
      s.centre      = get.centre();
      return s;
    }

    ReferenceSolution
    cone(const Arguments &get, const Scene &)
    {
      const double      modulus = ClosedForms::contact_modulus(get("E"), get("nu"));
      const double      flank   = get("flank") * dealii::numbers::PI / 180;
      const auto        c       = ClosedForms::cone(get("P"), flank, modulus);
      ReferenceSolution s;
      s.normal_force = get("P");
      s.contact_size = c.size;
      s.approach     = c.approach;
      s.size_factor  = 3;
      s.pressure     = [=](const double r) { return ClosedForms::cone_pressure(r, c.size, flank, modulus); };
      s.pressure_range = 1.3 * c.size;
      s.centre         = get.centre();
      return s;
    }

    ReferenceSolution
    shrink_fit_cylinders(const Arguments &get, const Scene &scene)
    {
      return shrink_fit(get, scene, false);
    }

    ReferenceSolution
    shrink_fit_spheres(const Arguments &get, const Scene &scene)
    {
      return shrink_fit(get, scene, true);
    }

    ReferenceSolution
    uniform(const Arguments &get, const Scene &)
    {
      return uniform_solution(get, get("p"), 0);
    }

    ReferenceSolution
    tubes_external_pressure(const Arguments &get, const Scene &scene)
    {
      if (!(get("R1") > get("R2") && get("R2") > get("R3")))
        get.fail("found radii that do not decrease", "R1 > R2 > R3");
      return uniform_solution(
          get,
          ClosedForms::tubes_external_pressure(get("p"),
                                               {get("E1"), get("nu1"), get("R2"), get("R1")},
                                               {get("E2"), get("nu2"), get("R3"), get("R2")},
                                               confinement(get, scene)),
          2 * get("R2"));
    }

    ReferenceSolution
    two_block_patch(const Arguments &get, const Scene &scene)
    {
      const Confinement c = get("confined") != 0                      ? Confinement::confined
                            : scene.kind == ProblemType::plane_strain ? Confinement::plane_strain
                                                                      : Confinement::plane_stress;
      return uniform_solution(
          get,
          ClosedForms::two_block_patch(
              get("E1"), get("nu1"), get("h1"), get("E2"), get("nu2"), get("h2"), get("delta"), c),
          0);
    }
  } // namespace ReferenceBuilders
} // namespace Amontons

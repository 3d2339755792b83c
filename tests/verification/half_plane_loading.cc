// Two half planes with friction through their load program: the gap stays closed, the surfaces stick where
// they should and slip by Cattaneo's amount elsewhere, tractions and dissipation are those of the reference.
#include <amontons/verification/closed_forms_friction.h>
#include <amontons/verification/half_plane_field.h>
#include <amontons/verification/reference_solution.h>

#include <check.h>

namespace test_half_plane_loading
{
using namespace Amontons;

namespace
{
  const double mu = .3, R = 50, a = 1;

  Scene
  boxes(const ProblemType kind)
  {
    Scene scene;
    scene.kind = kind;
    for (const char *const name : {"below", "above"})
      {
        BodyData body;
        body.name     = name;
        body.lower    = body.name == "below" ? Point<3>(-4, -4, 0) : Point<3>(-4, 0, 0);
        body.upper    = body.name == "below" ? Point<3>(4, 0, 0) : Point<3>(4, 4, 0);
        body.material = {1, .3};
        scene.bodies.push_back(body);
      }
    PairData pair;
    pair.name   = "interface";
    pair.first  = {"below", "top", {}};
    pair.second = BoundaryName{"above", "bottom", {}};
    scene.pairs.push_back(pair);
    return scene;
  }

  ReferenceSolution
  reference(Scene scene, const double t, const double ratio)
  {
    scene.end_time = t;
    return make_reference_solution({"half_plane_box",
                                    {{"a", a},
                                     {"R", R},
                                     {"E1", 1},
                                     {"nu1", .3},
                                     {"E2", 1},
                                     {"nu2", .3},
                                     {"friction", mu},
                                     {"shear_ratio", ratio}},
                                    {}},
                                   scene);
  }

  // Displacement of the lower surface relative to the upper one.
  Tensor<1, 3>
  relative(const ReferenceSolution &s, const double x)
  {
    const Point<3> p(x, 0, 0);
    return s.displacement("below", p) - s.displacement("above", p);
  }

  void
  at_all_times(const ProblemType kind, const double ratio)
  {
    const Scene  scene = boxes(kind);
    const double P = *reference(scene, 1, ratio).normal_force, Q_max = ratio * mu * P;
    for (const double t : {.25, .7, 1., 1.3, 1.9, 2., 2.3, 2.7, 3., 3.45, 4., 4.8, 5.2})
      {
        const auto        s    = reference(scene, t, ratio);
        const std::string when = " at t = " + std::to_string(t);
        const double      n    = std::min(t, 1.);
        check::is_close(*s.normal_force, n * P, 1e-13, "normal force" + when);
        check::is_close(*s.contact_size, a * std::sqrt(n), 1e-13, "contact size" + when);
        check::is_close(*s.tangential_force,
                        ClosedForms::normal_then_shear(t, Q_max).shear.Q,
                        1e-13,
                        "shear force" + when,
                        P);
        // the state at the last turn of the load, where the sliding of this half cycle begins
        const double turn  = t <= 2 ? std::min(t, 1.) : std::ceil(t) - 1;
        const auto   begin = reference(scene, turn, ratio);
        const double way   = t <= 2 ? 1 : 2;
        const double sign  = (*s.tangential_force > *begin.tangential_force ? 1 : -1);
        for (const double x : {0., .1, -.3, .48, .49, .55, -.6, .7, -.83, .9, .99})
          {
            if (std::abs(x) >= *s.contact_size)
              continue;
            const auto u = relative(s, x), before = relative(begin, x);
            check::is_close(u[1], x * x / (2 * R), 1e-14, "closed" + when, 1);
            const double slip = way * ClosedForms::cattaneo_slip(x, *s.stick_size, *s.contact_size, R, mu);
            check::is_close(u[0] - before[0], -sign * slip, 1e-14, "slip" + when, 1);
            const Point<3> p(x, 0, 0);
            const double   q = s.shear_traction(x);
            check::is_close(s.stress("below", p)[0][1], q, 1e-14, "shear on the lower body" + when, 1);
            check::is_close(s.stress("above", p)[0][1], q, 1e-14, "shear on the upper body" + when, 1);
            check::is_close(s.stress("below", p)[1][1], -s.pressure(x), 1e-14, "pressure" + when, 1);
            check::is_true(std::abs(q) <= mu * s.pressure(x) * (1 + 1e-10) + 1e-16, "Coulomb" + when);
          }
        for (const double side : {-1., 1.})
          {
            const FieldData boundary{"halfplane_elliptic",
                                     {{"P", P},
                                      {"a", a},
                                      {"side", side},
                                      {"friction", mu},
                                      {"shear_ratio", ratio},
                                      {"plane_stress", kind == ProblemType::plane_stress ? 1. : 0.}},
                                     {}};
            const Point<3>  p(-4, 2 * side, 0);
            const auto      field = make_displacement_field(boundary, {1, .3});
            check::is_close((field(p, t) - s.displacement(side < 0 ? "below" : "above", p)).norm(),
                            0,
                            1e-15,
                            "boundary values" + when,
                            1);
            check::is_close(field(p, 0).norm(), 0, 1e-15, "nothing at t = 0", 1);
          }
      }
  }

  // -int int q ds dx with the traction at the middle of the time step and x = a sin phi (midpoint rule).
  void
  work_of_friction()
  {
    const Scene        scene = boxes(ProblemType::plane_strain);
    const unsigned int n_x = 100, n_t = 60;
    const double       pi   = dealii::numbers::PI;
    double             work = 0;
    for (unsigned int i = n_t; i < 4 * n_t; ++i)
      {
        const auto before = reference(scene, double(i) / n_t, .6),
                   after  = reference(scene, (i + 1.) / n_t, .6);
        const auto middle = reference(scene, (i + .5) / n_t, .6);
        for (unsigned int k = 0; k < n_x; ++k)
          {
            const double phi = pi / 2 * ((k + .5) / n_x * 2 - 1), x = a * std::sin(phi);
            work -= middle.shear_traction(x) * (relative(after, x)[0] - relative(before, x)[0]) * a *
                    std::cos(phi) * pi / n_x;
          }
        if ((i + 1) % (n_t / 2) == 0 && i > n_t)
          check::is_close(
              work, *after.dissipation, 4e-3, "work until t = " + std::to_string((i + 1.) / n_t), 1e-8);
      }
  }

  void
  slave_and_messages()
  {
    Scene      scene = boxes(ProblemType::plane_strain);
    const auto lower = reference(scene, 2, .6);
    check::is_close(*lower.stick_size, .632456, 1e-6, "c of the published box");
    check::is_close(*lower.normal_force, 8.630749e-3, 1e-6, "P of the published box");
    scene.pairs[0].slave = PairData::Slave::first;
    check::is_close(*reference(scene, 2, .6).tangential_force, *lower.tangential_force, 1e-14, "lower slave");
    scene.pairs[0].slave = PairData::Slave::second;
    const auto upper     = reference(scene, 2, .6);
    check::is_close(*upper.tangential_force, -*lower.tangential_force, 1e-14, "upper slave");
    check::is_close(upper.shear_traction(.7), -lower.shear_traction(.7), 1e-14, "its traction");
    check::is_close(*upper.dissipation, *lower.dissipation, 1e-14, "its dissipation");

    const auto fails = [&](const FieldData &data, const std::string &part, const bool boundary = false) {
      try
        {
          if (boundary)
            make_displacement_field(data, {1, .3});
          else
            make_reference_solution(data, scene);
          check::is_true(false, part);
        }
      catch (const InputError &error)
        {
          check::is_true(std::string(error.what()).find(part) != std::string::npos,
                         std::string(error.what()) + " contains " + part);
        }
    };
    FieldData box{"half_plane_box",
                  {{"a", 1}, {"R", 50}, {"E1", 1}, {"nu1", .3}, {"E2", 2}, {"nu2", .3}, {"friction", .3}},
                  {}};
    fails(box, "not elastically similar");
    box.parameters["E2"]          = 1;
    box.parameters["shear_ratio"] = 1;
    fails(box, "-1 < shear_ratio < 1");
    box.parameters["friction"] = 0;
    fails(box, "friction = 0");
    box.parameters.erase("friction");
    fails(box, "shear_ratio without friction");
    fails({"halfplane_elliptic", {{"P", 1}, {"a", 1}, {"Q", .1}, {"friction", .3}}, {}},
          "Q and friction",
          true);
    for (const double c : {-.1, 1., 1.1})
      fails({"halfplane_elliptic", {{"P", 1}, {"a", 1}, {"Q", .1}, {"c", c}}, {}}, "0 <= c < a", true);
    fails({"halfplane_elliptic", {{"P", 1}, {"a", 1}, {"side", 0}}, {}}, "the side is neither", true);
  }
} // namespace

int
main(int, char **)
{
  for (const ProblemType kind : {ProblemType::plane_strain, ProblemType::plane_stress})
    for (const double ratio : {.6, -.9, 0.})
      at_all_times(kind, ratio);
  work_of_friction();
  slave_and_messages();
  return check::result();
}
} // namespace test_half_plane_loading

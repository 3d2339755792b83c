// Closed forms by name; the half-plane fields satisfy equilibrium, the law and the boundary condition on both
// sides.
#include <amontons/verification/half_plane_field.h>
#include <amontons/verification/reference_solution.h>

#include <check.h>

namespace test_reference_solution
{
using namespace Amontons;
using dealii::SymmetricTensor;

namespace
{
  Point<3>
  moved(Point<3> p, const unsigned int i, const double h)
  {
    p[i] += h;
    return p;
  }

  void
  field(const int side, const bool plane_stress)
  {
    HalfPlaneField f;
    f.material     = {7., .27};
    f.force        = 1.7;
    f.size         = 1.1;
    f.shear        = {{.4 / (1 - .36 / 1.21), 1.1, 0}, {-.4 * .36 / (1.21 - .36), .6, 0}};
    f.centre       = Point<3>(.3, -.2, 0);
    f.side         = side;
    f.plane_stress = plane_stress;

    const double h = 1e-5, G = 7. / 2 / 1.27;
    const double lame = plane_stress ? 2 * G * .27 / (1 - .27) : 2 * G * .27 / (1 - 2 * .27);
    for (const double x : {-2.7, -.8, -.4, .1, .3, .9, 1.4, 3.})
      for (const double depth : {.02, .3, 1.5})
        {
          const Point<3>              p(x, -.2 + side * depth, 0);
          const SymmetricTensor<2, 3> stress = f.stress(p);
          Tensor<2, 2>                gradient;
          for (unsigned int j = 0; j < 2; ++j)
            {
              const auto d = (f.displacement(moved(p, j, h)) - f.displacement(moved(p, j, -h))) / (2 * h);
              for (unsigned int i = 0; i < 2; ++i)
                gradient[i][j] = d[i];
            }
          for (unsigned int i = 0; i < 2; ++i)
            {
              double divergence = 0;
              for (unsigned int j = 0; j < 2; ++j)
                {
                  divergence += (f.stress(moved(p, j, h))[i][j] - f.stress(moved(p, j, -h))[i][j]) / (2 * h);
                  const double law =
                      G * (gradient[i][j] + gradient[j][i]) + (i == j ? lame * trace(gradient) : 0);
                  check::is_close(stress[i][j], law, 1e-8, "sigma = C eps(u)", 1);
                }
              check::is_close(divergence, 0, 1e-6, "div sigma", 1);
            }
        }
    for (const double s : {-.9, -.2, 0., .7, 1.05})
      {
        const Point<3> p(.3 + s, -.2, 0);
        const double   p0 = 2 * 1.7 / (dealii::numbers::PI * 1.1), r = .6 / 1.1;
        const double   mu = .4 / (1 - r * r) / 1.7;
        const double   q =
            mu * p0 * (std::sqrt(1 - s * s / 1.21) - r * std::sqrt(std::max(0., 1 - s * s / .36)));
        const auto t = f.stress(p) * Tensor<1, 3>({0., -1. * side, 0.}); // outward normal of the surface
        check::is_close(
            t[1], side * p0 * std::sqrt(1 - s * s / 1.21), 1e-12, "pressure pushes into the body", 1);
        check::is_close(t[0], q, 1e-12, "shear traction in +x", 1);
      }
    check::is_close(f.displacement(f.centre).norm(), 0, 1e-14, "zero at the centre", 1);
  }

  void
  box()
  {
    Scene scene;
    for (const char *const name : {"below", "above"})
      {
        BodyData body;
        body.name     = name;
        body.lower    = body.name == "below" ? Point<3>(-4, -4, 0) : Point<3>(-4, 0, 0);
        body.upper    = body.name == "below" ? Point<3>(4, 0, 0) : Point<3>(4, 4, 0);
        body.material = {1, .3};
        scene.bodies.push_back(body);
      }
    const FieldData data{
        "half_plane_box", {{"a", 1}, {"R", 50}, {"E1", 1}, {"nu1", .3}, {"E2", 1}, {"nu2", .3}}, {}};
    const auto s = make_reference_solution(data, scene);
    check::is_close(*s.normal_force, 8.630749e-3, 1e-6, "P");
    check::is_close(s.pressure(.6), .8 * 5.494505e-3, 1e-6, "p(0.6)");
    for (const double y : {0., 1e-16, -1e-16}) // gap x^2/(2R) closes inside of the contact
      {
        const Point<3> p(.5, y, 0);
        check::is_close(
            s.displacement("above", p)[1] - s.displacement("below", p)[1] + .25 / 100, 0, 1e-15, "closed", 1);
        check::is_close(s.stress("above", p)[1][1], -s.pressure(.5), 1e-12, "surface stress");
      }
    const FieldData boundary{"halfplane_elliptic", {{"P", *s.normal_force}, {"a", 1}, {"side", 1}}, {}};
    const Point<3>  p(4, 2, 0);
    check::is_close((make_displacement_field(boundary, {1, .3})(p, 0) - s.displacement("above", p)).norm(),
                    0,
                    1e-15,
                    "field",
                    1);
  }

  // Digits of references.md, for both contacts at |Q| = mu P/2.
  void
  friction()
  {
    const Scene                         scene;
    const std::map<std::string, double> equal = {{"P", 1000},
                                                 {"R", 10},
                                                 {"E1", 200e3},
                                                 {"nu1", .3},
                                                 {"E2", 200e3},
                                                 {"nu2", .3},
                                                 {"friction", .3},
                                                 {"Q", -150}};

    const auto line = make_reference_solution({"cattaneo_mindlin", equal, {}}, scene);
    check::is_close(*line.normal_force, 1000, 1e-14, "line: P");
    check::is_close(*line.contact_size, .3403892, 1e-6, "line: a");
    check::is_close(*line.peak_pressure, 1870.270, 1e-6, "line: p0");
    check::is_close(*line.tangential_force, -150, 1e-14, "line: Q");
    check::is_close(*line.stick_size / *line.contact_size, .707107, 1e-6, "line: c/a");
    check::is_close(*line.dissipation, .02964258 / 4, 1e-6, "line: first loading");
    check::is_close(line.shear_traction(.3), -.3 * line.pressure(.3), 1e-12, "line: sliding part");
    check::is_close(line.shear_traction(0), -.3 * 1870.270 * (1 - .707107), 2e-6, "line: centre");
    auto cycle         = equal;
    cycle["Q_max"]     = -150;
    cycle["reversals"] = 2;
    const auto full    = make_reference_solution({"cattaneo_mindlin", cycle, {}}, scene);
    check::is_close(*full.dissipation, .02964258 * 5 / 4, 1e-6, "line: a cycle later");
    check::is_close(full.shear_traction(.1), line.shear_traction(.1), 1e-12, "line: the same traction");
    cycle.erase("reversals");
    cycle["Q"]      = 0;
    const auto back = make_reference_solution({"cattaneo_mindlin", cycle, {}}, scene);
    check::is_close(
        back.shear_traction(.3), .3 * back.pressure(.3), 1e-12, "line: unloaded, not free of traction");
    check::is_close(
        *back.stick_size / *back.contact_size, std::sqrt(.75), 1e-12, "line: unloaded, stick size");

    const auto sphere = make_reference_solution({"mindlin_sphere", equal, {}}, scene);
    check::is_close(*sphere.contact_size, .4086651, 1e-6, "sphere: a");
    check::is_close(*sphere.peak_pressure, 2858.948, 1e-6, "sphere: p0");
    check::is_close(*sphere.stick_size / *sphere.contact_size, .793701, 1e-6, "sphere: c/a");
    check::is_close(*sphere.dissipation, .05142120 / 4, 1e-6, "sphere: first loading");
    check::is_close(sphere.shear_traction(.35), -.3 * sphere.pressure(.35), 1e-12, "sphere: sliding part");
    check::is_true(sphere.approach.has_value() && !line.approach, "only the sphere has an approach");
    auto rigid = equal;
    rigid.erase("E2");
    rigid.erase("nu2");
    check::is_close(*make_reference_solution({"mindlin_sphere", rigid, {}}, scene).dissipation,
                    .05142120 / 8 * std::cbrt(2.),
                    1e-6,
                    "sphere on a rigid plane: half of the compliance, a smaller by 2^(-1/3)");
  }

  std::string
  message(const FieldData &data)
  {
    try
      {
        make_reference_solution(data, Scene());
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  void
  messages()
  {
    const auto contains = [](const std::string &text, const std::string &part) {
      check::is_true(text.find(part) != std::string::npos, "'" + text + "' contains '" + part + "'");
    };
    const SourceLocation where{"a.prm", 7, "Reference/Solution"};
    contains(message({"hertz_lin", {}, where}), "did you mean 'hertz_line'");
    contains(message({"hertz_line", {{"P", 1}}, where}), "a.prm:7");
    contains(message({"hertz_line", {{"P", 1}}, where}), "'R' is missing");
    contains(message({"uniform", {{"p", 1}, {"widht", 1}}, where}), "did you mean 'width'");
    contains(message({"hertz_line", {{"P", 1}, {"R", -1}, {"E1", 1}, {"nu1", 0}}, where}), "R = -1");
    contains(message({"hertz_line", {{"P", 1}, {"R", 1}, {"E1", 1}, {"nu1", 0}, {"E2", 1}}, where}), "nu2");
    contains(message({"hertz_elliptic", {{"P", 1}, {"E1", 1}, {"nu1", 0}, {"R1y", 1}}, where}),
             "do not touch in a point");
    contains(message({"hertz_elliptic", {{"P", 1}, {"E1", 1}, {"nu1", 0}, {"R1y", 0}}, where}), "R1y = 0");
    contains(message({"half_space_box", {{"a", 1}, {"R", 1}, {"E1", 1}, {"nu1", 0}}, where}), "Kind = 3D");

    const auto sheared = [&](const std::map<std::string, double> &more) {
      std::map<std::string, double> all = {
          {"P", 10}, {"R", 1}, {"E1", 1}, {"nu1", 0}, {"friction", .5}, {"Q", 3}};
      all.insert(more.begin(), more.end());
      for (const auto &[name, value] : more)
        all[name] = value;
      return message({"cattaneo_mindlin", all, where});
    };
    check::is_true(sheared({}).empty() && sheared({{"Q_max", -4}, {"reversals", 3}}).empty(),
                   "right histories");
    contains(sheared({{"Q", 6}}), "friction cannot carry; allowed: |Q|, |Q_max| <= friction P");
    contains(sheared({{"Q_max", -6}}), "friction cannot carry");
    contains(sheared({{"Q_max", 2}}), "|Q| > |Q_max|");
    contains(sheared({{"reversals", 2}}), "reversals without Q_max");
    contains(sheared({{"Q_max", 4}, {"reversals", 1.5}}), "no integer");
    contains(sheared({{"friction", 0}}), "friction = 0");
  }
} // namespace

int
main(int, char **)
{
  for (const int side : {-1, 1})
    for (const bool plane_stress : {false, true})
      field(side, plane_stress);
  box();
  friction();
  messages();

  Scene      plane;
  const auto cone =
      make_reference_solution({"cone", {{"P", 1000}, {"flank", 5}, {"E", 200e3}, {"nu", .3}}, {}}, plane);
  check::is_close(*cone.contact_size, .1819575, 1e-6, "cone");

  // What is compared does not depend on the unit of length: the part of a punch where its pressure is finite.
  const auto range = [&](const double a) {
    return make_reference_solution({"flat_punch_line", {{"P", 1000}, {"a", a}}, {}}, plane).pressure_range;
  };
  check::is_true(range(1) > .5 && range(1) < 1, "punch: most of it is compared");
  check::is_close(range(10), 10 * range(1), 1e-12, "punch: ten times as wide");

  const auto fit = make_reference_solution({"shrink_fit_cylinders",
                                            {{"ri", 20},
                                             {"rc", 40},
                                             {"ro", 60},
                                             {"Ei", 210e3},
                                             {"nui", .3},
                                             {"Eo", 70e3},
                                             {"nuo", .33},
                                             {"delta", .02}},
                                            {}},
                                           plane);
  check::is_close(fit.pressure(40), 11.177411, 1e-7, "shrink fit");

  // Equal cylinders, crossed: z = (1 - cos 60)/(2R) x^2 + (1 + cos 60)/(2R) y^2, the long axis between them.
  const auto crossed = [](const double angle) {
    Scene space;
    space.kind = ProblemType::three_dimensional;
    return make_reference_solution(
        {"hertz_elliptic",
         {{"P", 50}, {"E1", 200}, {"nu1", .3}, {"R1y", 10}, {"R2y", 10}, {"angle", angle}},
         {}},
        space);
  };
  const auto at_60  = crossed(60);
  const auto wanted = ClosedForms::hertz_elliptic(50, .5 / 20, 1.5 / 20, 200 / .91);
  check::is_close(*at_60.contact_size, wanted.a, 1e-12, "crossed cylinders: long axis");
  check::is_close(at_60.ellipse->second_size, wanted.b, 1e-12, "crossed cylinders: short axis");
  check::is_close(*at_60.peak_pressure, wanted.peak, 1e-12, "crossed cylinders: peak");
  check::is_close(*at_60.approach, wanted.approach, 1e-12, "crossed cylinders: approach");
  const Tensor<1, 3> between({std::sqrt(.75), .5, 0.});
  check::is_close(std::abs(at_60.ellipse->axes[0] * between), 1, 1e-12, "crossed cylinders: direction");
  check::is_close(at_60.ellipse->pressure(.5 * wanted.a * between),
                  std::sqrt(.75) * wanted.peak,
                  1e-12,
                  "crossed cylinders: pressure along the long axis");
  const auto at_90 = crossed(90);
  const auto round = ClosedForms::hertz_point(50, 10, 200 / .91);
  check::is_close(*at_90.contact_size, round.size, 1e-6, "cylinders at a right angle");
  check::is_close(*at_90.approach, round.approach, 1e-6, "cylinders at a right angle: approach");
  check::is_true(reference_solution_names().size() == 17, "names");
  const FieldData constant{"halfplane_elliptic", {{"P", 1}, {"a", 1}}, {}},
      normal{"halfplane_elliptic", {{"P", 1}, {"a", 1}, {"friction", .3}}, {}},
      to_and_fro{"halfplane_elliptic", {{"P", 1}, {"a", 1}, {"friction", .3}, {"shear_ratio", .5}}, {}};
  check::is_true(displacement_field_corners(constant, 5).empty(), "a constant field bends nowhere");
  check::is_true(displacement_field_corners(normal, 5) == std::vector<double>({1}), "one after the load");
  check::is_true(displacement_field_corners(to_and_fro, 4.5) == std::vector<double>({1, 2, 3, 4}),
                 "one at each reversal");
  return check::result();
}
} // namespace test_reference_solution

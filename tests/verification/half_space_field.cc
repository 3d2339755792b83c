// Half spaces in global axes satisfy equilibrium, the law and the boundary condition on both sides;
// references that are built on them, and elliptic ones.
#include <amontons/verification/half_space_field.h>
#include <amontons/verification/reference_solution.h>

#include <check.h>

namespace test_half_space_field
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

  // The tensors: law and equilibrium by finite differences off the axes, pressure on the surface, on both
  // sides.
  void
  space_field(const int side, const unsigned int axis)
  {
    HalfSpaceField f;
    f.material = {7., .27};
    f.force    = 1.7;
    f.size     = 1.1;
    f.centre   = Point<3>(.3, -.2, .4);
    f.axis     = axis;
    f.side     = side;

    const double h = 1e-4, G = 7. / 2 / 1.27, lame = 2 * G * .27 / (1 - 2 * .27);
    for (const double depth : {.1, .7, 2.})
      for (const double x : {-1.2, .01, .6})
        {
          Point<3> p = f.centre;
          p[axis] += side * depth;
          p[(axis + 1) % 3] += x;
          p[(axis + 2) % 3] += .5;
          Tensor<2, 3> gradient;
          Tensor<1, 3> divergence;
          for (unsigned int j = 0; j < 3; ++j)
            {
              const auto plus = moved(p, j, h), minus = moved(p, j, -h);
              const auto d = (f.displacement(plus) - f.displacement(minus)) / (2 * h);
              for (unsigned int i = 0; i < 3; ++i)
                {
                  gradient[i][j] = d[i];
                  divergence[i] += (f.stress(plus)[i][j] - f.stress(minus)[i][j]) / (2 * h);
                }
            }
          const SymmetricTensor<2, 3> strain = symmetrize(gradient);
          const auto law = 2 * G * strain + lame * trace(strain) * dealii::unit_symmetric_tensor<3>();
          check::is_close((f.stress(p) - law).norm(), 0, 1e-6, "sigma = C eps(u)", 1);
          check::is_close(divergence.norm(), 0, 1e-5, "div sigma", 1);
        }
    Point<3> surface = f.centre;
    surface[(axis + 1) % 3] += .66;
    Tensor<1, 3> outward;
    outward[axis]      = -side;
    const double p     = .8 * 3 * 1.7 / (2 * dealii::numbers::PI * 1.21);
    const auto   wrong = f.stress(surface) * outward + p * outward;
    check::is_close(wrong.norm(), 0, 1e-12, "the pressure, and nothing else", 1);
    check::is_close(f.displacement(f.centre).norm(), 0, 1e-14, "zero at the centre", 1);
    check::is_true(f.displacement(surface)[axis] * side < 0, "the body is pushed in most at the centre");
  }

  void
  space_box(const ProblemType kind)
  {
    const unsigned int axis = kind == ProblemType::axisymmetric ? 1 : 2;
    Scene              scene;
    scene.kind = kind;
    for (const char *const name : {"below", "above"})
      {
        BodyData body;
        body.name                                              = name;
        body.upper                                             = Point<3>(4, 4, 4);
        (body.name == "below" ? body.lower : body.upper)[axis] = body.name == "below" ? -4 : 4;
        if (body.name == "below")
          body.upper[axis] = 0;
        body.material = {1, .3};
        scene.bodies.push_back(body);
      }
    const FieldData data{
        "half_space_box", {{"a", 1}, {"R", 50}, {"E1", 1}, {"nu1", .3}, {"E2", 1}, {"nu2", .3}}, {}};
    const auto s = make_reference_solution(data, scene);
    check::is_close(*s.normal_force, .01465201465201465, 1e-12, "P");
    check::is_close(*s.peak_pressure, .006995821674369025, 1e-12, "p0");
    check::is_true(!s.approach, "the fields have no approach");
    for (const double y : {0., 1e-16, -1e-16}) // gap r^2/(2R) closes inside of the contact
      {
        Point<3> p(.5, 0, 0);
        p[axis] = y;
        check::is_close(s.displacement("above", p)[axis] - s.displacement("below", p)[axis] + .25 / 100,
                        0,
                        1e-15,
                        "closed",
                        1);
        check::is_close(s.stress("above", p)[axis][axis], -s.pressure(.5), 1e-12, "surface stress");
      }
    const FieldData boundary{"halfspace_hertz", {{"P", *s.normal_force}, {"a", 1}, {"side", 1}}, {}};
    Point<3>        p(4, 0, 0);
    p[axis] = 2;
    check::is_close(
        (make_displacement_field(boundary, {1, .3}, kind)(p, 0) - s.displacement("above", p)).norm(),
        0,
        1e-15,
        "field",
        1);
  }

  // Two half spaces without lateral contraction, sheared to and fro: they stick for r < c, the gap stays
  // closed, the tractions' work on the slip is the dissipation.
  void
  sheared_box()
  {
    Scene scene;
    scene.kind = ProblemType::three_dimensional;
    for (const char *const name : {"below", "above"})
      {
        BodyData body;
        body.name     = name;
        body.lower    = Point<3>(-4, -4, body.name == "below" ? -4 : 0);
        body.upper    = Point<3>(4, 4, body.name == "below" ? 0 : 4);
        body.material = {1, 0};
        scene.bodies.push_back(body);
      }
    const double mu        = .3;
    const auto   reference = [&](const double t) {
      scene.end_time = t;
      return make_reference_solution({"half_space_box",
                                      {{"a", 1},
                                       {"R", 50},
                                       {"E1", 1},
                                       {"nu1", 0},
                                       {"E2", 1},
                                       {"nu2", 0},
                                       {"friction", mu},
                                       {"shear_ratio", .5}},
                                      {}},
                                     scene);
    };
    const auto relative = [](const ReferenceSolution &s, const Point<3> &p) {
      return s.displacement("below", p) - s.displacement("above", p);
    };
    check::is_close(*reference(2).stick_size, std::cbrt(.5), 1e-12, "c");
    check::is_close(*reference(.3).contact_size, std::cbrt(.3), 1e-12, "a before the shear");
    check::is_true(!reference(2).stress && reference(1).stress, "no stresses under shear");
    const auto last_turn = [](const double t) { return t <= 2 ? std::min(t, 1.) : std::ceil(t) - 1; };
    for (const double t : {.3, 1., 1.6, 2., 2.4, 3., 3.7, 4.})
      {
        const auto s = reference(t), begin = reference(last_turn(t));
        for (const Point<3> &p :
             {Point<3>(.3, .1, 0), Point<3>(0, -.6, 0), Point<3>(-.5, .6, 0), Point<3>(.9, 0, 0)})
          {
            const double r = p.norm();
            const auto   u = relative(s, p), slip = u - relative(begin, p);
            if (r < *s.contact_size)
              check::is_close(u[2], r * r / 100, 1e-13, "closed", 1);
            check::is_close(slip[1], 0, 1e-14, "no slip across", 1);
            if (r < *s.stick_size)
              check::is_close(slip[0], 0, 1e-14, "stick", 1);
            else if (r < *s.contact_size)
              check::is_true(slip[0] * s.shear_traction(r) < 0, "slip against the traction");
          }
        const FieldData boundary{
            "halfspace_hertz",
            {{"P", *reference(1).normal_force}, {"a", 1}, {"side", 1}, {"friction", mu}, {"shear_ratio", .5}},
            {}};
        const Point<3> p(4, -1, 2);
        const auto     field = make_displacement_field(boundary, {1, 0});
        check::is_close((field(p, t) - s.displacement("above", p)).norm(), 0, 1e-15, "field", 1);
        check::is_close(field(p, 0).norm(), 0, 1e-15, "nothing at t = 0", 1);
      }
    const unsigned int n_r = 100, n_t = 60;
    const double       pi   = dealii::numbers::PI;
    double             work = 0;
    for (unsigned int i = n_t; i < 4 * n_t; ++i)
      {
        const auto before = reference(double(i) / n_t), after = reference((i + 1.) / n_t),
                   middle = reference((i + .5) / n_t);
        for (unsigned int k = 0; k < n_r; ++k)
          {
            const double   phi = pi / 2 * (k + .5) / n_r, r = std::sin(phi);
            const Point<3> p(r, 0, 0);
            work -= middle.shear_traction(r) * (relative(after, p)[0] - relative(before, p)[0]) * 2 * pi * r *
                    std::cos(phi) * pi / 2 / n_r;
          }
        if ((i + 1) % (n_t / 2) == 0 && i > n_t)
          check::is_close(work, *after.dissipation, 4e-3, "work of friction", 1e-8);
      }
  }

  // An ellipsoid of semi-axes 6 (x), 10 (y), 5 (z) on a plane, and cylinders along x and at 60 degrees;
  // digits of analytic.py.
  void
  ellipses()
  {
    Scene scene;
    scene.kind   = ProblemType::three_dimensional;
    const auto s = make_reference_solution(
        {"hertz_elliptic", {{"P", 1000}, {"R1x", 36. / 5}, {"R1y", 20}, {"E1", 200e3}, {"nu1", .3}}, {}},
        scene);
    check::is_close(*s.contact_size, .47699055528542394, 1e-9, "a");
    check::is_close(s.ellipse->second_size, .24214851409831633, 1e-9, "b");
    check::is_close(*s.peak_pressure, 4133.803209613567, 1e-9, "p0");
    check::is_close(std::abs(s.ellipse->axes[0][1]), 1, 1e-14, "the long axis is y");
    check::is_close(s.ellipse->pressure(Tensor<1, 3>({0., .6 * *s.contact_size, 0.})),
                    .8 * *s.peak_pressure,
                    1e-12,
                    "pressure along the long axis");
    check::is_close(s.ellipse->pressure(Tensor<1, 3>({.3, 0., 0.})), 0, 1e-12, "outside", 1);
    const auto skew = make_reference_solution({"hertz_elliptic",
                                               {{"P", 1000},
                                                {"R1y", 10},
                                                {"R2y", 15},
                                                {"angle", 60},
                                                {"E1", 210e3},
                                                {"nu1", .3},
                                                {"E2", 70e3},
                                                {"nu2", .33}},
                                               {}},
                                              scene);
    check::is_close(*skew.contact_size, .820287297455968, 1e-9, "skew cylinders");
    check::is_close(*skew.approach, .02220053124472088, 1e-9, "their approach");
    const auto &axis = skew.ellipse->axes[0];
    check::is_true(axis[0] > .5 && axis[1] > 0,
                   "their long axis lies between them, nearer to the thinner one");
    check::is_true(axis[1] / axis[0] < std::tan(dealii::numbers::PI / 6), "the thinner one is along x");
  }
} // namespace

int
main(int, char **)
{
  for (const int side : {-1, 1})
    for (const unsigned int axis : {1, 2})
      space_field(side, axis);
  space_box(ProblemType::three_dimensional);
  space_box(ProblemType::axisymmetric);
  sheared_box();
  ellipses();
  return check::result();
}
} // namespace test_half_space_field

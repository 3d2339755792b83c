#include <amontons/scene/reference_builders.h>
#include <amontons/scene/half_plane_field.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    // A point in the inside of a body of the built-in shapes, after placement; nothing for rings and files.
    std::optional<Point<3>>
    inner_point(const BodyData &body)
    {
      Point<3> p = body.centre;
      if (body.shape == "block")
        p = body.lower + (body.upper - body.lower) / 2;
      else if (body.shape == "half disk")
        p[1] -= body.radius / 2;
      else if (body.shape == "quarter disk")
        p += Tensor<1, 3>({body.radius / 2, -body.radius / 2, 0});
      else if (body.shape != "disk")
        return {};
      const double       angle  = body.rotation_angle * dealii::numbers::PI / 180;
      const Tensor<1, 3> axis   = body.rotation_axis / body.rotation_axis.norm(),
                         arm    = p - body.rotation_centre;
      const Tensor<1, 3> turned = std::cos(angle) * arm +
                                  std::sin(angle) * dealii::cross_product_3d(axis, arm) +
                                  (1 - std::cos(angle)) * (axis * arm) * axis;
      return body.rotation_centre + turned + body.shift;
    }

    // The side of y = y0 a body is on: by its shape where that says it, else by the point; on the surface by
    // the material.
    int
    side_of(const BodyData *const body,
            const Point<3>       &p,
            const HalfPlaneField &lower,
            const HalfPlaneField &upper)
    {
      const double y0     = lower.centre[1];
      const auto   inside = body != nullptr ? inner_point(*body) : std::nullopt;
      if (inside && (*inside)[1] != y0)
        return (*inside)[1] < y0 ? -1 : 1;
      if (std::abs(p[1] - y0) > 1e-9 * lower.size || body == nullptr)
        return p[1] < y0 ? -1 : 1;
      const auto distance = [&](const HalfPlaneField &field) {
        return std::abs(field.material.young - body->material.young) / body->material.young +
               std::abs(field.material.poisson - body->material.poisson);
      };
      return distance(lower) <= distance(upper) ? -1 : 1;
    }

  } // namespace

  ReferenceSolution
  ReferenceBuilders::half_plane_box(const ClosedFormArguments &get, const Scene &scene)
  {
    const auto        h = ClosedForms::hertz_line_of_size(get("a"), get("R"), contact_modulus(get, scene));
    ReferenceSolution s = hertz_solution(get, h);
    HalfPlaneField    lower;
    lower.material       = {get("E1"), get("nu1")};
    lower.force          = h.force;
    lower.size           = h.size;
    lower.centre         = s.centre;
    lower.plane_stress   = scene.kind == Kind::plane_stress;
    HalfPlaneField upper = lower;
    upper.side           = 1;
    const bool rigid     = !get.is_given("E2");
    if (!rigid)
      upper.material = {get("E2"), get("nu2")};

    const auto side = [lower, upper, bodies = scene.bodies](const std::string &name, const Point<3> &p) {
      for (const BodyData &body : bodies)
        if (body.name == name)
          return side_of(&body, p, lower, upper);
      return side_of(nullptr, p, lower, upper);
    };
    s.displacement = [=](const std::string &body, const Point<3> &p) {
      if (side(body, p) < 0)
        return lower.displacement(p);
      return rigid ? Tensor<1, 3>() : upper.displacement(p);
    };
    s.stress = [=](const std::string &body, const Point<3> &p) {
      return side(body, p) < 0 ? lower.stress(p) : upper.stress(p);
    };
    return s;
  }

} // namespace Amontons

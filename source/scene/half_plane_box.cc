#include <amontons/scene/half_body_side.h>
#include <amontons/scene/half_plane_field.h>
#include <amontons/scene/reference_builders.h>

namespace Amontons
{
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

    const TwoHalves halves(s.centre, h.size, 1, lower.material, upper.material, scene.bodies);
    s.displacement = [=](const std::string &body, const Point<3> &p) {
      if (halves.side(body, p) < 0)
        return lower.displacement(p);
      return rigid ? Tensor<1, 3>() : upper.displacement(p);
    };
    s.stress = [=](const std::string &body, const Point<3> &p) {
      return halves.side(body, p) < 0 ? lower.stress(p) : upper.stress(p);
    };
    return s;
  }

} // namespace Amontons

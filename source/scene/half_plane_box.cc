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
    lower.force        = h.force;
    lower.size         = h.size;
    lower.centre       = s.centre;
    lower.plane_stress = scene.kind == Kind::plane_stress;
    set_fields_of_halves(get, 1, scene.bodies, lower, s);
    return s;
  }
} // namespace Amontons

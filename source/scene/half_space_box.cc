#include <amontons/scene/half_body_side.h>
#include <amontons/scene/half_space_field.h>
#include <amontons/scene/reference_builders.h>

namespace Amontons
{
  ReferenceSolution
  ReferenceBuilders::half_space_box(const ClosedFormArguments &get, const Scene &scene)
  {
    if (scene.kind != Kind::three_dimensional && scene.kind != Kind::axisymmetric)
      get.fail("found a plane scene", "Kind = 3D (surface normal to z) or axisymmetric (normal to y)");
    const auto        h = ClosedForms::hertz_point_of_size(get("a"), get("R"), contact_modulus(get, scene));
    ReferenceSolution s = hertz_solution(get, h);
    s.approach.reset(); // the fields of both bodies are zero at the centre
    HalfSpaceField lower;
    lower.force  = h.force;
    lower.size   = h.size;
    lower.centre = s.centre;
    lower.axis   = normal_axis(scene.kind);
    set_fields_of_halves(get, lower.axis, scene.bodies, lower, s);
    return s;
  }
} // namespace Amontons

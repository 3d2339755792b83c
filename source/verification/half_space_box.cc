#include <amontons/verification/half_body_loading.h>
#include <amontons/verification/half_body_side.h>
#include <amontons/verification/half_space_field.h>
#include <amontons/verification/reference_builders.h>

namespace Amontons
{
  ReferenceSolution
  ReferenceBuilders::half_space_box(const ClosedFormArguments &get, const Scene &scene)
  {
    if (scene.kind != ProblemType::three_dimensional && scene.kind != ProblemType::axisymmetric)
      get.fail("found a plane scene", "Kind = 3D (surface normal to z) or axisymmetric (normal to y)");
    const double   modulus = contact_modulus(get, scene);
    const auto     full    = ClosedForms::hertz_point_of_size(get("a"), get("R"), modulus);
    HalfSpaceField lower;
    lower.force  = full.force;
    lower.size   = full.size;
    lower.centre = get.centre();
    lower.axis   = normal_axis(scene.kind);

    const auto loading = read_loading(get, lower);
    if (lower.axis != 2 && loading.shear_ratio != 0)
      get.fail("found a shear force", "shear_ratio = 0 in axisymmetric scenes");
    lower = loading.at(scene.end_time);
    ReferenceSolution s =
        hertz_solution(get, ClosedForms::hertz_point_of_size(lower.size, get("R"), modulus));
    s.approach.reset(); // the fields of both bodies are zero at the centre
    if (loading.friction > 0)
      set_shear_of_halves(get, scene, loading.load(scene.end_time).shear, lower, s, [&](const double Q) {
        return ClosedForms::mindlin_dissipation_per_cycle(
            Q, full.force, loading.friction, full.size, mindlin_compliance(get));
      });
    set_fields_of_halves(get, lower.axis, scene.bodies, lower, s);
    if (!lower.shear.empty())
      s.stress = {};
    return s;
  }
} // namespace Amontons

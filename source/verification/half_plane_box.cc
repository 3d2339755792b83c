#include <amontons/verification/half_body_loading.h>
#include <amontons/verification/half_body_side.h>
#include <amontons/verification/half_plane_field.h>
#include <amontons/verification/reference_builders.h>

namespace Amontons
{
  ReferenceSolution
  ReferenceBuilders::half_plane_box(const ClosedFormArguments &get, const Scene &scene)
  {
    const double   modulus = contact_modulus(get, scene);
    const auto     full    = ClosedForms::hertz_line_of_size(get("a"), get("R"), modulus);
    HalfPlaneField lower;
    lower.force        = full.force;
    lower.size         = full.size;
    lower.centre       = get.centre();
    lower.plane_stress = scene.kind == ProblemType::plane_stress;

    const auto loading  = read_loading(get, lower);
    lower               = loading.at(scene.end_time);
    ReferenceSolution s = hertz_solution(get, ClosedForms::hertz_line_of_size(lower.size, get("R"), modulus));
    if (loading.friction > 0)
      set_shear_of_halves(get, scene, loading.load(scene.end_time).shear, lower, s, [&](const double Q) {
        return ClosedForms::cattaneo_dissipation_per_cycle(
            full.force, Q, loading.friction, get("R"), modulus);
      });
    set_fields_of_halves(get, 1, scene.bodies, lower, s);
    return s;
  }
} // namespace Amontons

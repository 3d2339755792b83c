#include <amontons/base/closed_forms_friction.h>
#include <amontons/scene/half_body_side.h>
#include <amontons/scene/half_plane_field.h>
#include <amontons/scene/reference_builders.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    // Cattaneo's solution needs shear tractions that leave the gap as it is: (1-2 nu) (1+nu)/E, in plane
    // stress (1-nu)/E, are the same in both bodies.
    void
    check_similarity(const ClosedFormArguments &get, const Scene &scene)
    {
      const auto value = [&](const double E, const double nu) {
        return scene.kind == Kind::plane_stress ? (1 - nu) / E : (1 - 2 * nu) * (1 + nu) / E;
      };
      const double first  = value(get("E1"), get("nu1")),
                   second = get.is_given("E2") ? value(get("E2"), get("nu2")) : 0;
      if (std::abs(first - second) > 1e-9 * (first + second))
        get.fail("found friction between bodies that are not elastically similar", "E1 = E2 and nu1 = nu2");
    }

    // The shear force on the slave in +x has this sign if that on the lower body is positive.
    int
    sign_of_slave(const Scene &scene, const Point<3> &centre, const double size, const MaterialData &lower)
    {
      const std::string name = scene.reference ? scene.reference->pair : "";
      for (const PairData &pair : scene.pairs)
        if ((name.empty() || pair.name == name) && pair.slave != PairData::Slave::automatic)
          {
            const bool      first = pair.slave == PairData::Slave::first || !pair.second;
            const TwoHalves halves(centre, size, 1, lower, lower, scene.bodies);
            return -halves.side(first ? pair.first.body : pair.second->body, centre);
          }
        else if (name.empty())
          break;
      return 1;
    }
  } // namespace

  ReferenceSolution
  ReferenceBuilders::half_plane_box(const ClosedFormArguments &get, const Scene &scene)
  {
    using namespace ClosedForms;
    const double     modulus   = Amontons::contact_modulus(get, scene);
    const Hertz      full      = hertz_line_of_size(get("a"), get("R"), modulus);
    HalfPlaneLoading loading   = half_plane_loading(get);
    loading.full.force         = full.force;
    loading.full.size          = full.size;
    loading.full.centre        = get.centre();
    loading.full.plane_stress  = scene.kind == Kind::plane_stress;
    const HalfPlaneField lower = loading.at(scene.end_time);

    ReferenceSolution s = hertz_solution(get, hertz_line_of_size(lower.size, get("R"), modulus));
    if (loading.friction > 0)
      {
        check_similarity(get, scene);
        const double mu    = loading.friction;
        const auto   load  = normal_then_shear(scene.end_time, loading.shear_ratio * mu * full.force);
        ShearHistory shear = load.shear;
        const int    sign  = sign_of_slave(scene, s.centre, full.size, {get("E1"), get("nu1")});
        shear.Q *= sign;
        shear.Q_max *= sign;
        set_shear(shear, ContactShape::line, mu, s);
        s.dissipation = shear_dissipation(shear, [&](const double Q) {
          return cattaneo_dissipation_per_cycle(full.force, Q, mu, get("R"), modulus);
        });
      }
    set_fields_of_halves(get, 1, scene.bodies, lower, s);
    return s;
  }
} // namespace Amontons

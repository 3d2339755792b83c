// Half planes and half spaces with friction: their fields as functions of time.
#pragma once

#include <amontons/verification/closed_form_arguments.h>
#include <amontons/verification/closed_forms_friction.h>

#include <cmath>

namespace Amontons
{
  // A half body (HalfPlaneField or HalfSpaceField) under the load program ClosedForms::normal_then_shear: the
  // normal force P grows until t = 1; then the shear force Q = shear_ratio mu P (Cattaneo, Mindlin) comes and
  // goes. Q > 0 pushes the lower body in +x and the upper one in -x. In elastically similar bodies, the
  // relative displacement of the two surfaces along them is zero where they stick, as it is at the centre.
  // friction = 0: `full` at all times.
  template <typename Field>
  struct HalfBodyLoading
  {
    Field  full; // all of the normal force, no shear
    double friction = 0, shear_ratio = 0;

    // Force and history of the shear force on the lower body.
    ClosedForms::NormalThenShear
    load(const double t) const
    {
      return ClosedForms::normal_then_shear(t, shear_ratio * friction * full.force);
    }

    Field
    at(const double t) const
    {
      using namespace ClosedForms;
      if (!(friction > 0))
        return full;
      const NormalThenShear now   = load(t);
      const bool            line  = Field::shape == ContactShape::line;
      Field                 field = full;
      field.force                 = now.normal_fraction * full.force;
      field.size  = (line ? std::sqrt(now.normal_fraction) : std::cbrt(now.normal_fraction)) * full.size;
      field.shear = shear_state(Field::shape, now.shear, full.force, friction, full.size).tractions;
      for (EllipticTraction &traction : field.shear)
        traction.force *= -full.side;
      return field;
    }
  };

  // Reads `friction` and `shear_ratio`. Throws InputError.
  template <typename Field>
  HalfBodyLoading<Field>
  read_loading(const ClosedFormArguments &get, const Field &full)
  {
    const bool given = get.is_given("friction");
    if (!given && get("shear_ratio") != 0)
      get.fail("found shear_ratio without friction", "both, or none");
    if (!(std::abs(get("shear_ratio")) < 1))
      get.fail("found a shear force that friction cannot carry",
               "-1 < shear_ratio < 1 (shear_ratio = Q/(friction P))");
    return {full, given ? get("friction") : 0., get("shear_ratio")};
  }
} // namespace Amontons

// The exact field of a half plane under elliptic pressure and shear, in global axes.
#pragma once

#include <amontons/base/closed_forms.h>
#include <amontons/scene/closed_form_arguments.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // Lower body (side = -1): z = y0 - y into the body, u = (ux, -uz); upper body (side = +1): z = y - y0, u =
  // (ux, uz). The displacement is zero at the centre (x0, y0) of the contact. The surface is y = y0 and
  // points outside of the body are taken to it. The shear tractions push this body in +x; their centres are
  // relative to that of the contact.
  struct HalfPlaneField
  {
    MaterialData                               material;
    double                                     force = 0, size = 1;
    std::vector<ClosedForms::EllipticTraction> shear;
    Point<3>                                   centre;
    int                                        side         = -1;
    bool                                       plane_stress = false;

    dealii::Tensor<1, 3>
    displacement(const Point<3> &p) const;
    dealii::SymmetricTensor<2, 3>
    stress(const Point<3> &p) const;
    // The other body of the same material: the opposite tractions.
    HalfPlaneField
    opposite() const;

  private:
    ClosedForms::HalfPlaneState
    state(const double x, const double z) const;
  };

  // A half plane under the load program ClosedForms::normal_then_shear: P of half-width a grows until t = 1;
  // then the shear force Q = shear_ratio mu P (Cattaneo) comes and goes. Q > 0 pushes the lower body in +x
  // and the upper one in -x. In elastically similar bodies, the relative displacement of the two surfaces
  // along them is zero where they stick, as it is at the centre. friction = 0: `full` at all times.
  struct HalfPlaneLoading
  {
    HalfPlaneField full; // all of the normal force, no shear
    double         friction = 0, shear_ratio = 0;

    HalfPlaneField
    at(const double t) const;
  };

  // Reads `friction` and `shear_ratio`; the field is left as it is. Throws InputError.
  HalfPlaneLoading
  half_plane_loading(const ClosedFormArguments &get, const HalfPlaneField &full = {});
} // namespace Amontons

// The exact field of a half plane under elliptic pressure and shear, in global axes.
#pragma once

#include <amontons/scene/scene.h>
#include <amontons/verification/closed_forms_friction.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // Lower body (side = -1): z = y0 - y into the body, u = (ux, -uz); upper body (side = +1): z = y - y0, u =
  // (ux, uz). The displacement is zero at the centre (x0, y0) of the contact. The surface is y = y0 and
  // points outside of the body are taken to it. The shear tractions push this body in +x; their centres are
  // relative to that of the contact.
  struct HalfPlaneField
  {
    static constexpr auto shape = ClosedForms::ContactShape::line;

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
} // namespace Amontons

// The exact field of a half plane under elliptic pressure and Cattaneo's shear, in global axes.
#pragma once

#include <amontons/base/closed_forms.h>
#include <amontons/scene/scene.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // Lower body (side = -1): z = y0 - y into the body, u = (ux, -uz); upper body (side = +1): z = y - y0, u =
  // (ux, uz). The displacement is zero at the centre (x0, y0) of the contact. The surface is y = y0 and
  // points outside of the body are taken to it. The shear traction has the resultant `shear` on this body in
  // +x: ellipses of half-widths a and `stick` < a with the resultants Q/(1-(c/a)^2) and -Q
  // (c/a)^2/(1-(c/a)^2).
  struct HalfPlaneField
  {
    MaterialData material;
    double       force = 0, size = 1, shear = 0, stick = 0;
    Point<3>     centre;
    int          side         = -1;
    bool         plane_stress = false;

    dealii::Tensor<1, 3>
    displacement(const Point<3> &p) const;
    dealii::SymmetricTensor<2, 3>
    stress(const Point<3> &p) const;

  private:
    ClosedForms::HalfPlaneState
    state(const double x, const double z) const;
  };
} // namespace Amontons

// The exact field of a half space under Hertz's pressure and Mindlin's shear on a circle, in global axes.
#pragma once

#include <amontons/scene/scene.h>
#include <amontons/verification/closed_forms_friction.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Amontons
{
  // The surface is normal to the coordinate axis `axis` (2: z; 1: y, the axis of revolution of axisymmetric
  // scenes) and goes through the centre of the contact, where the displacement is zero. side = -1: the body
  // is below, 1: above. Points outside of the body are taken to the surface. The shear tractions push this
  // body in +x; only axis = 2 has them.
  struct HalfSpaceField
  {
    static constexpr auto shape = ClosedForms::ContactShape::sphere;

    MaterialData                               material;
    double                                     force = 0, size = 1;
    std::vector<ClosedForms::EllipticTraction> shear;
    Point<3>                                   centre;
    unsigned int                               axis = 2;
    int                                        side = -1;

    dealii::Tensor<1, 3>
    displacement(const Point<3> &p) const;
    dealii::SymmetricTensor<2, 3>
    stress(const Point<3> &p) const; // without shear only
    // The other body of the same material: the opposite tractions.
    HalfSpaceField
    opposite() const;
  };

  // The axis of the scenes' contact normal: z in three dimensions, else y.
  inline unsigned int
  normal_axis(const ProblemType kind)
  {
    return kind == ProblemType::three_dimensional ? 2 : 1;
  }
} // namespace Amontons

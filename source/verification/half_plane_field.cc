#include <amontons/verification/half_plane_field.h>

namespace Amontons
{
  // Plane stress is plane strain with nu/(1+nu) and E (1+2nu)/(1+nu)^2.
  ClosedForms::HalfPlaneState
  HalfPlaneField::state(const double x, const double z) const
  {
    double E = material.young, nu = material.poisson;
    if (plane_stress)
      {
        E *= (1 + 2 * nu) / ((1 + nu) * (1 + nu));
        nu /= 1 + nu;
      }
    ClosedForms::HalfPlaneState sum = {0, 0, {0, 0, 0}};
    if (force > 0)
      sum = ClosedForms::half_plane_pressure(x, z, E, nu, {force, size, 0});
    for (const ClosedForms::EllipticTraction &traction : shear)
      {
        const auto part = ClosedForms::half_plane_shear(x, z, E, nu, traction);
        sum.ux += part.ux;
        sum.uz += part.uz;
        sum.stress.xx += part.stress.xx;
        sum.stress.zz += part.stress.zz;
        sum.stress.xz += part.stress.xz;
      }
    return sum;
  }

  HalfPlaneField
  HalfPlaneField::opposite() const
  {
    HalfPlaneField other = *this;
    other.side           = -side;
    for (ClosedForms::EllipticTraction &traction : other.shear)
      traction.force *= -1;
    return other;
  }

  dealii::Tensor<1, 3>
  HalfPlaneField::displacement(const Point<3> &p) const
  {
    const auto here = state(p[0] - centre[0], side * (p[1] - centre[1])), origin = state(0, 0);
    return dealii::Tensor<1, 3>({here.ux - origin.ux, side * (here.uz - origin.uz), 0.});
  }

  dealii::SymmetricTensor<2, 3>
  HalfPlaneField::stress(const Point<3> &p) const
  {
    const auto                    s = state(p[0] - centre[0], side * (p[1] - centre[1])).stress;
    dealii::SymmetricTensor<2, 3> result;
    result[0][0] = s.xx;
    result[1][1] = s.zz;
    result[0][1] = side * s.xz;
    result[2][2] = plane_stress ? 0. : material.poisson * (s.xx + s.zz);
    return result;
  }
} // namespace Amontons

#include <amontons/verification/half_space_field.h>

namespace Amontons
{
  namespace
  {
    // Distance from the axis, direction away from it (zero on it), and depth below the surface.
    struct Cylindrical
    {
      double               r, depth;
      dealii::Tensor<1, 3> outward, inward; // unit vectors along r and depth
    };

    Cylindrical
    cylindrical(const HalfSpaceField &field, const Point<3> &p)
    {
      Cylindrical c;
      c.inward[field.axis]  = field.side;
      c.outward             = p - field.centre;
      c.depth               = c.inward * c.outward;
      c.outward[field.axis] = 0;
      c.r                   = c.outward.norm();
      if (c.r > 0)
        c.outward /= c.r;
      return c;
    }

    ClosedForms::HalfSpaceState
    state(const HalfSpaceField &field, const double r, const double depth)
    {
      if (field.force == 0)
        return {};
      return ClosedForms::half_space_hertz(
          r, depth, field.material.young, field.material.poisson, field.force, field.size);
    }
  } // namespace

  dealii::Tensor<1, 3>
  HalfSpaceField::displacement(const Point<3> &p) const
  {
    const auto c    = cylindrical(*this, p);
    const auto here = state(*this, c.r, c.depth);
    auto       u    = here.ur * c.outward + (here.uz - state(*this, 0, 0).uz) * c.inward;
    for (const auto &traction : shear)
      {
        const auto part = [&](const Tensor<1, 3> &x, const double depth) {
          return ClosedForms::half_space_shear(
              x[0], x[1], depth, material.young, material.poisson, traction.force, traction.size);
        };
        const auto at_p = part(p - centre, c.depth), origin = part(Tensor<1, 3>(), 0);
        u += Tensor<1, 3>({at_p.x - origin.x, at_p.y, side * at_p.z});
      }
    return u;
  }

  HalfSpaceField
  HalfSpaceField::opposite() const
  {
    HalfSpaceField other = *this;
    other.side           = -side;
    for (auto &traction : other.shear)
      traction.force *= -1;
    return other;
  }

  // tt (I - e_z e_z) + (rr-tt) e_r e_r + zz e_z e_z + 2 rz sym(e_r e_z); rr = tt on the axis
  dealii::SymmetricTensor<2, 3>
  HalfSpaceField::stress(const Point<3> &p) const
  {
    Assert(shear.empty(), dealii::ExcNotImplemented());
    const auto                    c = cylindrical(*this, p);
    const auto                    s = state(*this, c.r, c.depth);
    dealii::SymmetricTensor<2, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        result[i][j] = (i == j ? s.tt : 0.) + (s.rr - s.tt) * c.outward[i] * c.outward[j] +
                       (s.zz - s.tt) * c.inward[i] * c.inward[j] +
                       s.rz * (c.outward[i] * c.inward[j] + c.outward[j] * c.inward[i]);
    return result;
  }
} // namespace Amontons

#include <amontons/verification/half_body_side.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    // A point in the inside of a body of the built-in shapes, after placement; nothing for rings and files.
    std::optional<Point<3>>
    inner_point(const BodyData &body)
    {
      Point<3> p = body.centre;
      if (body.shape == "block")
        p = body.lower + (body.upper - body.lower) / 2;
      else if (body.shape == "half disk")
        p[1] -= body.radius / 2;
      else if (body.shape == "quarter disk")
        p += Tensor<1, 3>({body.radius / 2, -body.radius / 2, 0});
      else if (body.shape != "disk")
        return {};
      const double       angle  = body.rotation_angle * dealii::numbers::PI / 180;
      const Tensor<1, 3> axis   = body.rotation_axis / body.rotation_axis.norm(),
                         arm    = p - body.rotation_centre;
      const Tensor<1, 3> turned = std::cos(angle) * arm +
                                  std::sin(angle) * dealii::cross_product_3d(axis, arm) +
                                  (1 - std::cos(angle)) * (axis * arm) * axis;
      return body.rotation_centre + turned + body.shift;
    }
  } // namespace

  TwoHalves::TwoHalves(const Point<3>              &centre,
                       const double                 size,
                       const unsigned int           axis,
                       const MaterialData          &lower,
                       const MaterialData          &upper,
                       const std::vector<BodyData> &bodies)
      : surface(centre[axis]), tolerance(1e-9 * size), axis(axis)
  {
    for (const BodyData &body : bodies)
      {
        const auto distance = [&](const MaterialData &material) {
          return std::abs(material.young - body.material.young) / body.material.young +
                 std::abs(material.poisson - body.material.poisson);
        };
        const auto inside   = inner_point(body);
        const int  by_shape = !inside || (*inside)[axis] == surface ? 0 : (*inside)[axis] < surface ? -1 : 1;
        sides[body.name]    = {by_shape, distance(lower) <= distance(upper) ? -1 : 1};
      }
  }

  int
  TwoHalves::side(const std::string &name, const Point<3> &p) const
  {
    const auto body = sides.find(name);
    if (body != sides.end() && body->second.by_shape != 0)
      return body->second.by_shape;
    if (std::abs(p[axis] - surface) > tolerance || body == sides.end())
      return p[axis] < surface ? -1 : 1;
    return body->second.by_material;
  }
} // namespace Amontons

#include <amontons/geometry/placement.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // v turned by the body's rotation (Rodrigues' formula).
    Tensor<1, 3>
    rotate(const Tensor<1, 3> &v, const BodyData &body)
    {
      if (body.rotation_angle == 0)
        return v;
      const Tensor<1, 3> axis  = body.rotation_axis / body.rotation_axis.norm();
      const double       angle = body.rotation_angle * numbers::PI / 180;
      return std::cos(angle) * v + std::sin(angle) * cross_product_3d(axis, v) +
             (1 - std::cos(angle)) * (axis * v) * axis;
    }

    Point<3>
    place(const Point<3> &p, const BodyData &body)
    {
      return body.rotation_centre + rotate(p - body.rotation_centre, body) + body.shift;
    }

    TrueGeometry
    place(TrueGeometry shape, const BodyData &body)
    {
      shape.centre = place(shape.centre, body);
      shape.axis   = rotate(shape.axis, body);
      return shape;
    }

    template <int dim>
    void
    check_placement(const BodyData &body)
    {
      const Tensor<1, 3> &axis = body.rotation_axis;
      if (body.rotation_angle != 0 && !(axis.norm() > 0))
        throw InputError(body.where, "the rotation axis is zero", "a direction");
      if (body.rotation_angle != 0 && dim == 2 && (axis[0] != 0 || axis[1] != 0))
        throw InputError(body.where, "a rotation out of the plane", "the rotation axis 0, 0, 1");
    }
  } // namespace

  template <int dim>
  void
  place(const BodyData &body, const ProblemType kind, CoarseMesh<dim> &mesh)
  {
    check_placement<dim>(body);
    const auto move = [&](Point<dim> &p) {
      Point<3> q;
      for (unsigned int d = 0; d < dim; ++d)
        q[d] = p[d];
      q = place(q, body);
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = q[d];
    };
    for (auto &p : mesh.vertices)
      move(p);
    for (auto &[edge, p] : mesh.middle_nodes.of_edges)
      move(p);
    for (auto &[face, p] : mesh.middle_nodes.of_faces)
      move(p);

    const auto   box  = BoundingBox<dim>(mesh.vertices).get_boundary_points();
    const double size = box.first.distance(box.second);
    for (auto &p : mesh.vertices)
      if (kind == ProblemType::axisymmetric && p[0] < 1e-12 * size)
        {
          if (p[0] < -1e-12 * size)
            throw InputError(body.where,
                             "the body reaches to x = " + std::to_string(p[0]) + " in an axisymmetric scene",
                             "x >= 0: x is the radius, a ball is a 'quarter disk' about the axis");
          p[0] = 0;
        }

    for (auto &[name, shape] : mesh.geometry)
      shape = place(shape, body);
    if (mesh.polar)
      mesh.polar = place(*mesh.polar, body);
  }

  template void
  place<2>(const BodyData &, const ProblemType, CoarseMesh<2> &);
  template void
  place<3>(const BodyData &, const ProblemType, CoarseMesh<3> &);
} // namespace Amontons

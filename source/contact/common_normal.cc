#include <amontons/contact/common_normal.h>

namespace Amontons
{
  namespace
  {
    double
    compliance(const BodyData &body)
    {
      return body.rigid ? 0. : (1 - std::pow(body.material.poisson, 2)) / body.material.young;
    }

    // Continuous from face to face, unless an edge of the body is near (15 degrees): that has no normal, and
    // faces keep theirs.
    template <int dim>
    Tensor<1, dim>
    smooth_normal(const ContactSurface<dim> &surface, const unsigned int face, const Point<dim - 1> &xi)
    {
      const Tensor<1, dim> own       = surface.face_normal(face, xi);
      const auto          &nodes     = surface.faces[face].nodes;
      const bool           is_smooth = std::all_of(nodes.begin(), nodes.end(), [&](const unsigned int node) {
        return surface.nodes[node].normal * own > 0.966;
      });
      return is_smooth ? surface.nodal_normal(face, xi) : own;
    }
  } // namespace

  template <int dim>
  Tensor<1, dim>
  common_normal(const Scene &scene, const ContactInterface<dim> &interface, const OverlapPoint<dim> &point)
  {
    constexpr double           none = 0.7, whole = 0.9; // of the cosine
    const ContactSurface<dim> &master = *interface.master.surface;
    const double               C      = compliance(scene.bodies[interface.slave->body]),
                 D                    = compliance(scene.bodies[master.body]);
    if (D == 0)
      return point.normal;
    const Tensor<1, dim> other = -smooth_normal(master, point.master_face, point.xi_master);
    const double         near  = std::clamp((point.normal * other - none) / (whole - none), 0., 1.);
    const Tensor<1, dim> n     = point.normal + near * D / (C + D) * (other - point.normal);
    return n / n.norm();
  }

  template Tensor<1, 2>
  common_normal(const Scene &, const ContactInterface<2> &, const OverlapPoint<2> &);
  template Tensor<1, 3>
  common_normal(const Scene &, const ContactInterface<3> &, const OverlapPoint<3> &);
} // namespace Amontons

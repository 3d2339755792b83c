#include <amontons/contact/face_basis.h>
#include <amontons/contact/surface_approach.h>

namespace Amontons
{
  template <int dim>
  SurfaceApproach<dim>::SurfaceApproach(const ContactInterface<dim> &interface) : interface(interface)
  {
  }

  template <int dim>
  SurfaceApproach<dim>::SurfaceApproach(const Discretization<dim>   &discretization,
                                        const ContactInterface<dim> &interface,
                                        const LA::Vector            &u)
      : interface(interface), u(interface.slave->moved ? nullptr : &u)
  {
    if (interface.master.obstacle != nullptr)
      motion = carrier_motion(discretization, interface.master.carrier, u);
  }

  template <int dim>
  double
  SurfaceApproach<dim>::to_obstacle(const unsigned int    face,
                                    const Point<dim - 1> &xi,
                                    const Tensor<1, dim> &n,
                                    const Point<dim>     &y) const
  {
    return u == nullptr ? 0 : n * (displacement(*interface.slave, face, xi) - (motion(y) - y));
  }

  template <int dim>
  double
  SurfaceApproach<dim>::to_face(const unsigned int    face,
                                const Point<dim - 1> &xi,
                                const Tensor<1, dim> &n,
                                const unsigned int    other,
                                const Point<dim - 1> &eta) const
  {
    return u == nullptr ? 0
                        : n * (displacement(*interface.slave, face, xi) -
                               displacement(*interface.master_surface, other, eta));
  }

  template <int dim>
  double
  SurfaceApproach<dim>::to_node(const unsigned int    face,
                                const Point<dim - 1> &xi,
                                const Tensor<1, dim> &n,
                                const unsigned int    node) const
  {
    return u == nullptr ? 0
                        : n * (displacement(*interface.slave, face, xi) -
                               of_node(interface.master_surface->nodes[node]));
  }

  template <int dim>
  Tensor<1, dim>
  SurfaceApproach<dim>::displacement(const ContactSurface<dim> &surface,
                                     const unsigned int         face,
                                     const Point<dim - 1>      &xi) const
  {
    const auto     N     = lagrange_values<dim - 1>(surface.degree, xi);
    const auto    &nodes = surface.faces[face].nodes;
    Tensor<1, dim> result;
    for (unsigned int j = 0; j < nodes.size(); ++j)
      result += N[j] * of_node(surface.nodes[nodes[j]]);
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  SurfaceApproach<dim>::of_node(const SurfaceNode<dim> &node) const
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = (*u)(node.dofs[c]);
    return result;
  }

  template class SurfaceApproach<2>;
  template class SurfaceApproach<3>;
} // namespace Amontons

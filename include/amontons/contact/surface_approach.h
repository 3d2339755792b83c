// What displacements do to gaps between surfaces that stay where they were.
#pragma once

#include <amontons/contact/contact_interface.h>

namespace Amontons
{
  // By how much displacements u bring surfaces nearer that stay where they were (small strain):
  // n . (u_slave - u_master); 0 for surfaces that have moved with u.
  template <int dim>
  class SurfaceApproach
  {
  public:
    // None: u = 0.
    explicit SurfaceApproach(const ContactInterface<dim> &interface);
    // u readable at the DoFs of both surfaces and of the carriers.
    SurfaceApproach(const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const LA::Vector            &u);

    // n: unit normal of the slave, at xi of a face of it. Of a place of the obstacle; of a place of a master
    // face; of a node of the master.
    double
    to_obstacle(const unsigned int    face,
                const Point<dim - 1> &xi,
                const Tensor<1, dim> &n,
                const Point<dim>     &y) const;
    double
    to_face(const unsigned int    face,
            const Point<dim - 1> &xi,
            const Tensor<1, dim> &n,
            const unsigned int    other,
            const Point<dim - 1> &eta) const;
    double
    to_node(const unsigned int    face,
            const Point<dim - 1> &xi,
            const Tensor<1, dim> &n,
            const unsigned int    node) const;

  private:
    Tensor<1, dim>
    displacement(const ContactSurface<dim> &surface, const unsigned int face, const Point<dim - 1> &xi) const;
    Tensor<1, dim>
    of_node(const SurfaceNode<dim> &node) const;

    const ContactInterface<dim> &interface;
    const LA::Vector            *u = nullptr;
    AffineMap<dim>               motion; // of the obstacle
  };
} // namespace Amontons

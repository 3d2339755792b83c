/// Where on its faces the contact of a slave surface is.
#pragma once

#include <amontons/contact/contact_interface.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor_product_polynomials.h>

namespace Amontons
{
  /// Not an obstacle, nor a rigid body.
  template <int dim>
  bool
  master_deforms(const ContactInterface<dim> &interface, const Scene &scene)
  {
    return interface.master_surface && !scene.bodies[interface.master_surface->body].rigid;
  }

  /// A point of a face, with its area (axisymmetric: of the full turn) and what values at the points of a
  /// quadrature have to be multiplied by for the value of their interpolation here; its place in the points
  /// of the overlap, invalid if it is none of them.
  template <int dim>
  struct FacePoint
  {
    Point<dim - 1>      xi;
    double              weight;
    std::vector<double> interpolation;
    unsigned int        overlap = numbers::invalid_unsigned_int;
  };

  /// The points of a quadrature on faces that are opposite of the other side with all they have, or with
  /// nothing. Of others, which an edge cuts, those of the overlap, and in space, where the edge is that of a
  /// body that deforms, also of those beside them. What nodal values say of a pressure beyond the edge is a
  /// continuation, which may be anything.
  template <int dim>
  class FacePoints
  {
  public:
    FacePoints(const ContactInterface<dim> &interface, const QGauss<1> &along_lines, const Scene &scene);

    /// Whether anything is opposite.
    bool
    covers(const unsigned int face) const
    {
      return covered[face];
    }
    /// Whether points of the overlap are taken there.
    bool
    is_at_edge(const unsigned int face) const
    {
      return !of_overlap[face].empty();
    }
    /// In space, and the master deforms: its own stress says what the pressure is at its edge
    /// (master_traction.h), and beyond it there is none. (A rigid edge makes an infinite pressure, which is
    /// seen by what the stress of the slave says of it beyond; in the plane the faces there are few.)
    bool
    knows_master() const
    {
      return master_is_known;
    }

    std::vector<FacePoint<dim>>
    on(const unsigned int face) const;
    /// Of the quadrature, on any face.
    std::vector<FacePoint<dim>>
    on_whole(const unsigned int face) const;

  private:
    const ContactInterface<dim>            &interface;
    const Quadrature<dim - 1>               quadrature;
    const TensorProductPolynomials<dim - 1> polynomials; // of its points
    const ProblemType                       kind;
    std::vector<std::vector<unsigned int>>  of_overlap; // by face: places in its points
    std::vector<bool>                       covered;    // by face
    const bool                              master_is_known;
  };
} // namespace Amontons

/// Where on its faces the contact of a slave surface is.
#pragma once

#include <amontons/contact/contact_interface.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor_product_polynomials.h>

namespace Amontons
{
  /// A point of a face, with its area (axisymmetric: of the full turn) and what values at the points of a
  /// quadrature have to be multiplied by for the value of their interpolation here.
  template <int dim>
  struct FacePoint
  {
    Point<dim - 1>      xi;
    double              weight;
    std::vector<double> interpolation;
  };

  /// The points of a quadrature on faces that are opposite of the other side with all they have, or with
  /// nothing. Of others, which an edge cuts, those of the overlap. What nodal values say of a pressure beyond
  /// the edge is a continuation, which may be anything.
  template <int dim>
  class FacePoints
  {
  public:
    FacePoints(const ContactInterface<dim> &interface, const QGauss<1> &along_lines, const ProblemType kind);

    /// Whether anything is opposite.
    bool
    covers(const unsigned int face) const
    {
      return covered[face];
    }

    std::vector<FacePoint<dim>>
    on(const unsigned int face) const;

  private:
    const ContactInterface<dim>            &interface;
    const Quadrature<dim - 1>               quadrature;
    const TensorProductPolynomials<dim - 1> polynomials; // of its points
    const ProblemType                       kind;
    std::vector<std::vector<unsigned int>>  of_cut_faces; // places in the points of the overlap
    std::vector<bool>                       covered;      // by face
  };
} // namespace Amontons

// The common part of a slave face and a master face in 2D: a segment with a Gauss formula.
#pragma once

#include <amontons/contact/face_overlap.h>
#include <amontons/contact/face_ad.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim, typename Number>
  class Clipper;

  // Calls on_piece(n, slave_point) for the formula on [a, b] of the slave face; slave_point(q), q < n.
  template <typename Number, typename OnPiece>
  void
  integrate_segment(const FaceAD<2, Number> &slave, const Number &a, const Number &b, const OnPiece &on_piece)
  {
    // psi x N x geometry x r: degree 2p + 1 on straight faces; curved ones get two points more.
    const QGauss<1> gauss(slave.surface.degree + 3);
    on_piece(gauss.size(), [&](const unsigned int q) {
      Components<1, Number> xi;
      xi[0] = a + (b - a) * gauss.point(q)[0];
      return SlavePoint<2, Number>(slave, xi, gauss.weight(q) * (b - a));
    });
  }

  template <typename Number>
  class Clipper<2, Number>
  {
  public:
    explicit Clipper(const FaceAD<2, Number> &slave)
        : slave(slave), normal(slave.surface.face_normal(slave.face, Point<1>(0.5)))
    {
    }

    // The ends of the master face are projected on to the slave face along its continuous normal field.
    template <typename OnPiece>
    void
    for_each_piece(const FaceAD<2, Number> &master, const OnPiece &on_piece) const
    {
      Number a = projection(master, 0), b = projection(master, 1);
      if (a > b)
        std::swap(a, b);
      if (value_of(b) - value_of(a) >= 1e-12)
        integrate_segment(slave, a, b, on_piece);
    }

    const FaceAD<2, Number> slave;
    const Tensor<1, 2>      normal; // at the middle of the slave face

  private:
    // Ends of the slave face stay where they are.
    Number
    projection(const FaceAD<2, Number> &master, const double eta) const
    {
      const Point<2> y  = master.surface.position(master.face, Point<1>(eta));
      const double   xi = project_to_slave(slave.surface, slave.face, y);
      if constexpr (!std::is_same_v<Number, double>)
        if (xi > 1e-12 && xi < 1 - 1e-12)
          return vary_foot_on_slave<2, Number>(slave, Point<1>(xi), master.position(Point<1>(eta)))[0];
      return xi;
    }
  };
} // namespace Amontons

// The common part of a slave face and a master face in 3D: a polygon, cut into triangles with a formula each.
#pragma once

#include <amontons/contact/face_overlap.h>
#include <amontons/contact/polygon.h>
#include <amontons/contact/face_ad.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim, typename Number>
  class Clipper;

  // The degree that psi phi asks for with elements of degree p: 4p on parallelograms, else more (see
  // `variation`).
  double
  degree_on_piece(const unsigned int p, const double variation);

  const Quadrature<2> &
  triangle_formula(const double degree);

  // The vertex that is foremost along a direction, which none of the usual edges has. The first one depends
  // on rounding where vertices lie on the edges that they were cut with.
  template <typename Number>
  unsigned int
  foremost_vertex(const Polygon<Number> &polygon)
  {
    const auto along = [](const auto &p) { return 0.83 * value_of(p[0]) + 0.55774 * value_of(p[1]); };
    return std::max_element(polygon.begin(),
                            polygon.end(),
                            [&](const auto &p, const auto &q) { return along(p) < along(q); }) -
           polygon.begin();
  }

  // Calls on_piece(n, slave_point) for the formula on each triangle of a polygon; slave_point(q), q < n.
  // to_xi takes its points to (xi, area element dxi). On curved faces formulas are not exact: triangles must
  // be the same ones when the polygon moves a little.
  template <typename Number, typename ToXi, typename OnPiece>
  void
  integrate_polygon(const FaceAD<3, Number> &slave,
                    const Polygon<Number>   &polygon,
                    const Quadrature<2>     &formula,
                    const ToXi              &to_xi,
                    const OnPiece           &on_piece)
  {
    const unsigned int first  = polygon.empty() ? 0 : foremost_vertex(polygon);
    const auto         vertex = [&](const unsigned int i) -> const auto &
    {
      return polygon[(first + i) % polygon.size()];
    };
    for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
      {
        const auto   a = vertex(i) - vertex(0), b = vertex(i + 1) - vertex(0);
        const Number twice_area = cross(a, b);
        if (value_of(twice_area) != 0)
          on_piece(formula.size(), [&](const unsigned int q) {
            const auto [xi, element] =
                to_xi(vertex(0) + (scaled(formula.point(q)[0], a) + scaled(formula.point(q)[1], b)));
            return SlavePoint<3, Number>(slave, xi, Number(formula.weight(q) * twice_area * element));
          });
      }
  }

  // See overlap_faces.
  template <typename Number>
  class Clipper<3, Number>
  {
    using Vector = Components<3, Number>;

  public:
    explicit Clipper(const FaceAD<3, Number> &slave)
        : slave(slave), normal(slave.surface.face_normal(slave.face, Point<2>(0.5, 0.5)))
    {
      const auto   middle = slave.frame(Components<2, Number>(Point<2>(0.5, 0.5)));
      const Vector n      = area_vector(middle.tangents);
      origin              = middle.x;
      axes[0]             = scaled(Number(1. / norm(middle.tangents[0])), middle.tangents[0]);
      axes[1]             = cross(scaled(Number(slave.surface.faces[slave.face].sign / norm(n)), n), axes[0]);
      for (unsigned int v = 0; v < 4; ++v)
        corners[v] = project(corner(slave, v));
      window = around(corners);
      for (const unsigned int i : slave.surface.faces[slave.face].nodes)
        bend = std::max(bend, (slave.surface.nodes[i].normal - normal).norm());
      flat = slave.surface.faces[slave.face].straight && bend < 1e-12;
    }

    // Whether nothing of a face is opposite, told without projections along the normals: its corners in the
    // plane, whose feet lie elsewhere by no more than the normals' bend times the height.
    bool
    misses(const SurfaceFace<3> &master) const
    {
      if (bend > 0.4)
        return false;
      constexpr unsigned int g      = ContactSurface<3>::geometry_degree;
      double                 height = 0;

      const std::array<unsigned int, 4> corner_points = {{0, g, g * (g + 1), (g + 1) * (g + 1) - 1}};
      std::array<Point<2>, 4>           theirs, ours;
      for (unsigned int v = 0; v < 4; ++v)
        {
          const Tensor<1, 3> y = master.geometry[corner_points[v]] - value_of(origin);
          height               = std::max(height, std::abs(normal * y));
          theirs[v]            = Point<2>(value_of(axes[0]) * y, value_of(axes[1]) * y);
          ours[v]              = value_of(corners[v]);
        }
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto lower    = [d](const auto &p, const auto &q) { return p[d] < q[d]; };
          const auto a        = std::minmax_element(ours.begin(), ours.end(), lower),
                     b        = std::minmax_element(theirs.begin(), theirs.end(), lower);
          const double margin = 2 * bend * height + 0.3 * slave.surface.faces[slave.face].size;
          if ((*b.first)[d] > (*a.second)[d] + margin || (*b.second)[d] < (*a.first)[d] - margin)
            return true;
        }
      return false;
    }

    template <typename OnPiece>
    void
    for_each_piece(const FaceAD<3, Number> &master, const OnPiece &on_piece) const
    {
      Corners<Number> master_corners;
      for (unsigned int v = 0; v < 4; ++v)
        master_corners[v] = projection(corner(master, v));
      Polygon<Number> polygon = around(master_corners);
      hold_on_edges(polygon, window);
      for (unsigned int i = 0; i < 4 && polygon.size() > 2; ++i)
        polygon = cut(polygon, window[i], window[(i + 1) % 4]);
      if (polygon.size() < 3 || area(polygon) < 1e-24 * area(window))
        return;

      // On curved faces nothing is exact: no large formulas there. Derivatives of psi phi by displacements
      // have degree 6p - 1 on parallelograms.
      const unsigned int p = std::max(slave.surface.degree, master.surface.degree);
      const bool         straight =
          slave.surface.faces[slave.face].straight && master.surface.faces[master.face].straight;
      const double varies =
          straight ? std::min(0.9, std::max(variation(corners, polygon), variation(master_corners, polygon)))
                   : 0.;
      integrate_polygon(
          slave,
          polygon,
          triangle_formula(std::max(slave.surface.moved ? 6. * p - 1 : 0., degree_on_piece(p, varies))),
          [&](const Components<2, Number> &s) {
            const auto xi = pull_back(corners, s);
            return std::make_pair(xi, Number(1. / area_ratio(corners, xi)));
          },
          on_piece);
    }

    const FaceAD<3, Number> slave;
    const Tensor<1, 3>      normal; // at the middle of the slave face

  private:
    static Vector
    corner(const FaceAD<3, Number> &face, const unsigned int v)
    {
      return face.position(Point<2>(v % 2, v < 2 ? 0 : 1));
    }

    Components<2, Number>
    project(const Vector &y) const
    {
      Components<2, Number> s;
      for (unsigned int k = 0; k < 2; ++k)
        s[k] = dot(axes[k], y - origin);
      return s;
    }

    // Of a point opposite of the face. A flat one is a special case of values, not of derivatives.
    Components<2, Number>
    projection(const Vector &y) const
    {
      Components<2, Number> s = project(y);
      if (flat && std::is_same_v<Number, double>)
        return s;
      const auto xi = project_to_slave(slave.surface, slave.face, value_of(y));
      if (!xi)
        return s;
      auto result = bilinear(corners, vary_foot_on_slave<3, Number>(slave, *xi, y));
      if (flat)
        for (unsigned int k = 0; k < 2; ++k)
          result[k] += value_of(s[k]) - value_of(result[k]);
      return result;
    }

    Vector                origin;
    std::array<Vector, 2> axes;     // of the plane in which faces are clipped
    Corners<Number>       corners;  // of the slave face
    Polygon<Number>       window;   // the same
    double                bend = 0; // largest deviation of a nodal normal from `normal`
    bool                  flat;     // plane, with one normal
  };
} // namespace Amontons

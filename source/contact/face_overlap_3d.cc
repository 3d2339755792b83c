#include <amontons/contact/face_overlap.h>
#include <amontons/contact/overlap_piece.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    using Polygon = std::vector<Point<2>>; // counter-clockwise

    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    double
    area(const Polygon &polygon)
    {
      double twice = 0;
      for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
      return 0.5 * twice;
    }

    // The part to the left of the line from a to b (Sutherland and Hodgman 1974).
    Polygon
    cut(const Polygon &polygon, const Point<2> &a, const Point<2> &b)
    {
      Polygon      result;
      const auto   side = [&](const Point<2> &p) { return cross(b - a, p - a); };
      unsigned int n    = polygon.size();
      for (unsigned int i = 0; i < n; ++i)
        {
          const Point<2> &p = polygon[i], &q = polygon[(i + 1) % n];
          const double    s = side(p), t = side(q);
          if (s >= 0)
            result.push_back(p);
          if ((s > 0 && t < 0) || (s < 0 && t > 0))
            result.push_back(p + s / (s - t) * (q - p));
        }
      return result;
    }

    Point<2>
    bilinear(const std::array<Point<2>, 4> &corners, const Point<2> &xi)
    {
      Point<2> s;
      for (unsigned int v = 0; v < 4; ++v)
        s += (v % 2 == 1 ? xi[0] : 1 - xi[0]) * (v / 2 == 1 ? xi[1] : 1 - xi[1]) * corners[v];
      return s;
    }

    // Columns ds/dxi_k.
    std::array<Tensor<1, 2>, 2>
    bilinear_tangents(const std::array<Point<2>, 4> &corners, const Point<2> &xi)
    {
      return {{(1 - xi[1]) * (corners[1] - corners[0]) + xi[1] * (corners[3] - corners[2]),
               (1 - xi[0]) * (corners[2] - corners[0]) + xi[0] * (corners[3] - corners[1])}};
    }

    // xi with bilinear(corners, xi) = s
    Point<2>
    pull_back(const std::array<Point<2>, 4> &corners, const Point<2> &s)
    {
      Point<2> xi(0.5, 0.5);
      for (unsigned int iteration = 0; iteration < 20; ++iteration)
        {
          const auto         t    = bilinear_tangents(corners, xi);
          const Tensor<1, 2> rest = s - bilinear(corners, xi);
          const double       det  = cross(t[0], t[1]);
          const Tensor<1, 2> step({cross(rest, t[1]) / det, cross(t[0], rest) / det});
          xi += step;
          if (step.norm() < 1e-9) // quadratic: the next one would be 1e-18
            break;
        }
      return xi;
    }

    double
    area_ratio(const std::array<Point<2>, 4> &corners, const Point<2> &xi) // |ds/dxi|
    {
      const auto t = bilinear_tangents(corners, xi);
      return std::abs(cross(t[0], t[1]));
    }

    // Solves a x = b for the 3 x 3 matrix with columns a; false if it is singular.
    bool
    solve(const std::array<Tensor<1, 3>, 3> &a, const Tensor<1, 3> &b, Tensor<1, 3> &x)
    {
      const Tensor<1, 3> c   = cross_product_3d(a[1], a[2]);
      const double       det = a[0] * c;
      if (!(std::abs(det) > 1e-14 * a[0].norm() * a[1].norm() * a[2].norm()))
        return false;
      x[0] = (b * c) / det;
      x[1] = (a[0] * cross_product_3d(b, a[2])) / det;
      x[2] = (a[0] * cross_product_3d(a[1], b)) / det;
      return true;
    }

    bool
    within(const Point<2> &xi, const double margin)
    {
      return std::abs(xi[0] - 0.5) <= 0.5 + margin && std::abs(xi[1] - 0.5) <= 0.5 + margin;
    }

    // How much the squared area element |ds/dxi|^2 of a bilinear face varies over a piece of it: (max -
    // min)/(max + min), 0 on parallelograms. xi(s) holds its square root.
    double
    variation(const std::array<Point<2>, 4> &corners, const Polygon &piece)
    {
      double smallest = std::numeric_limits<double>::max(), largest = 0;
      for (const auto &s : piece)
        {
          const double square = std::pow(area_ratio(corners, pull_back(corners, s)), 2);
          smallest            = std::min(smallest, square);
          largest             = std::max(largest, square);
        }
      const double ratio = (largest - smallest) / (largest + smallest);
      return ratio >= 0 ? ratio : 1; // not a number where the face is turned inside out
    }

    // Degree 4p for psi phi on parallelograms. On others polynomials converge like rho^-degree, with rho of
    // the Bernstein ellipse that ends where the area element would vanish. Measured: 1e6 in rho^orders leaves
    // 5e-12 of the pressure in patch tests (1e5: 4e-10).
    const Quadrature<2> &
    triangle_formula(const unsigned int degree, const double variation)
    {
      constexpr unsigned int                  n_symmetric = 7, n_max = 20;
      static const std::vector<Quadrature<2>> formulas = [] {
        std::vector<Quadrature<2>> list;
        for (unsigned int n = 1; n <= n_symmetric; ++n)
          list.push_back(QWitherdenVincentSimplex<2>(n)); // degree 2n - 1
        for (unsigned int n = n_symmetric + 1; n <= n_max; ++n)
          list.push_back(QDuffy(n, 1.)); // collapsed squares: degree 2n - 2
        return list;
      }();
      const double       z      = 1 / std::max(variation, 1e-12);
      const double       orders = variation < 1e-12 ? 0 : std::log(1e6) / std::log(z + std::sqrt(z * z - 1));
      const double       wanted = 4 * degree + orders;
      const unsigned int n      = std::ceil(0.5 * (wanted <= 2 * n_symmetric - 1 ? wanted + 1 : wanted + 2));
      return formulas[std::min(n, n_max) - 1];
    }

    // The plane of a slave face in which faces are clipped.
    class Plane
    {
    public:
      Plane(const ContactSurface<3> &slave, const unsigned int face)
          : normal(slave.face_normal(face, Point<2>(0.5, 0.5))), slave(slave), face(face),
            origin(slave.faces[face].centre)
      {
        Tensor<1, 3> t = slave.frame(face, Point<2>(0.5, 0.5)).tangents[0];
        axes[0]        = t / t.norm();
        axes[1]        = cross_product_3d(normal, axes[0]);
        for (unsigned int v = 0; v < 4; ++v)
          corners[v] = project(slave.position(face, Point<2>(v % 2, v / 2)));
        window = {corners[0], corners[1], corners[3], corners[2]};
        if (area(window) < 0)
          std::reverse(window.begin(), window.end());
        flat = slave.faces[face].straight;
        for (const unsigned int i : slave.faces[face].nodes)
          flat = flat && (slave.nodes[i].normal - normal).norm() < 1e-12;
      }

      // Of a point opposite of the face.
      Point<2>
      foot(const Point<3> &y) const
      {
        if (!flat)
          if (const auto xi = project_to_slave(slave, face, y))
            return bilinear(corners, *xi);
        return project(y);
      }

      const Tensor<1, 3>      normal;
      Polygon                 window;  // the slave face
      std::array<Point<2>, 4> corners; // the same, lexicographic

    private:
      Point<2>
      project(const Point<3> &y) const
      {
        return {axes[0] * (y - origin), axes[1] * (y - origin)};
      }

      const ContactSurface<3>    &slave;
      const unsigned int          face;
      const Point<3>              origin;
      std::array<Tensor<1, 3>, 2> axes;
      bool                        flat; // plane, with one normal
    };

    // A point of the slave face with what the formula makes of the area element, opposite still unknown.
    OverlapPoint<3>
    slave_point(const ContactSurface<3> &slave,
                const unsigned int       face,
                const Point<2>          &xi,
                const double             weight)
    {
      OverlapPoint<3> p;
      const auto      frame = slave.frame(face, xi);
      p.slave_face          = face;
      p.master_face         = numbers::invalid_unsigned_int;
      p.xi_slave            = xi;
      p.x_slave             = frame.X;
      p.normal              = slave.nodal_normal(face, xi);
      p.weight              = weight * cross_product_3d(frame.tangents[0], frame.tangents[1]).norm();
      return p;
    }

    // Appends the formula on each triangle of a polygon; to_xi takes its points to (xi, area element dxi).
    template <typename ToXi, typename Opposite>
    void
    integrate_polygon(const ContactSurface<3>      &slave,
                      const unsigned int            slave_face,
                      const Polygon                &polygon,
                      const Quadrature<2>          &formula,
                      const double                  reach,
                      const ToXi                   &to_xi,
                      const Opposite               &opposite,
                      std::vector<OverlapPoint<3>> &points)
    {
      for (unsigned int i = 1; i + 1 < polygon.size(); ++i)
        {
          const Tensor<1, 2> a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
          const double       twice_area = cross(a, b);
          if (twice_area == 0)
            continue;
          append_piece<3>(
              formula.size(),
              [&](const unsigned int q) {
                const auto [xi, element] =
                    to_xi(polygon[0] + formula.point(q)[0] * a + formula.point(q)[1] * b);
                return slave_point(slave, slave_face, xi, formula.weight(q) * twice_area * element);
              },
              opposite,
              reach,
              points);
        }
    }
  } // namespace

  // Unknowns (xi, g): x(xi) + g n(xi) = y.
  std::optional<Point<2>>
  project_to_slave(const ContactSurface<3> &slave, const unsigned int face, const Point<3> &y)
  {
    Point<2>     xi(0.5, 0.5);
    double       g      = slave.face_normal(face, xi) * (y - slave.faces[face].centre);
    const double enough = 1e-13 * slave.faces[face].size;
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        std::array<Tensor<1, 3>, 2> dn;
        const auto                  frame = slave.frame(face, xi);
        const auto                  n     = slave.nodal_normal(face, xi, &dn);
        Tensor<1, 3>                step;
        if (!solve({{frame.tangents[0] + g * dn[0], frame.tangents[1] + g * dn[1], n}},
                   y - frame.X - g * n,
                   step))
          return {};
        xi[0] += step[0];
        xi[1] += step[1];
        g += step[2];
        if (!within(xi, 2.))
          return {};
        if (std::abs(step[0]) + std::abs(step[1]) < 1e-12 && std::abs(step[2]) < enough + 1e-12 * std::abs(g))
          return within(xi, 1.) ? std::optional<Point<2>>(xi) : std::nullopt;
      }
    return {};
  }

  // Unknowns (eta, g): y(eta) - g n = x.
  std::optional<Point<2>>
  project_to_master(const ContactSurface<3> &master,
                    const unsigned int       face,
                    const Point<3>          &x,
                    const Tensor<1, 3>      &n)
  {
    Point<2> eta(0.5, 0.5);
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        const auto   frame = master.frame(face, eta);
        Tensor<1, 3> step;
        // g enters linearly: it is found anew in each step
        if (!solve({{frame.tangents[0], frame.tangents[1], -n}}, x - frame.X, step))
          return {};
        eta[0] += step[0];
        eta[1] += step[1];
        if (!within(eta, 3.))
          return {};
        if (std::abs(step[0]) + std::abs(step[1]) < 1e-8) // quadratic: the next one would be 1e-16
          return within(eta, 0.5) ? std::optional<Point<2>>(eta) : std::nullopt;
      }
    return {};
  }

  void
  overlap_faces(const ContactSurface<3>         &slave,
                const unsigned int               slave_face,
                const ContactSurface<3>         &master,
                const std::vector<unsigned int> &master_faces,
                const double                     reach,
                std::vector<OverlapPoint<3>>    &points)
  {
    if (master_faces.empty())
      return;
    const Plane plane(slave, slave_face);
    for (const unsigned int m : master_faces)
      {
        if (plane.normal * master.face_normal(m, Point<2>(0.5, 0.5)) > -0.1)
          continue;
        std::array<Point<2>, 4> corners;
        for (unsigned int v = 0; v < 4; ++v)
          corners[v] = plane.foot(master.position(m, Point<2>(v % 2, v / 2)));
        Polygon polygon = {corners[0], corners[1], corners[3], corners[2]};
        if (area(polygon) < 0)
          std::reverse(polygon.begin(), polygon.end());
        for (unsigned int i = 0; i < 4 && polygon.size() > 2; ++i)
          polygon = cut(polygon, plane.window[i], plane.window[(i + 1) % 4]);
        if (polygon.size() < 3 || area(polygon) < 1e-24 * area(plane.window))
          continue;

        // on curved faces nothing is exact: no large formulas there
        const bool   straight = slave.faces[slave_face].straight && master.faces[m].straight;
        const double varies   = std::min(
            straight ? 0.9 : 0.1, std::max(variation(plane.corners, polygon), variation(corners, polygon)));
        integrate_polygon(
            slave,
            slave_face,
            polygon,
            triangle_formula(std::max(slave.degree, master.degree), varies),
            reach,
            [&](const Point<2> &s) {
              const auto xi = pull_back(plane.corners, s);
              return std::make_pair(xi, 1. / area_ratio(plane.corners, xi));
            },
            [&](OverlapPoint<3> &p) {
              const auto eta = project_to_master(master, m, p.x_slave, p.normal);
              if (!eta)
                return false;
              p.master_face = m;
              p.xi_master   = *eta;
              p.x_master    = master.position(m, *eta);
              return true;
            },
            points);
      }
  }

  void
  overlap_obstacle(const ContactSurface<3>      &slave,
                   const unsigned int            slave_face,
                   const ObstacleData           &obstacle,
                   const AffineMap<3>           &motion,
                   const double                  reach,
                   std::vector<OverlapPoint<3>> &points)
  {
    const auto project = [&](OverlapPoint<3> &p) {
      const auto x = project_to_obstacle(obstacle, motion, p.x_slave, p.normal);
      p.x_master   = x ? x->x : p.x_slave;
      return x.has_value();
    };
    const auto is_opposite = [&](const Point<2> &xi) {
      return project_to_obstacle(
                 obstacle, motion, slave.position(slave_face, xi), slave.nodal_normal(slave_face, xi))
          .has_value();
    };
    const auto as_it_is = [](const Point<2> &xi) { return std::make_pair(xi, 1.); };

    const unsigned int             n = 8;
    std::vector<std::vector<bool>> inside(n + 1, std::vector<bool>(n + 1));
    unsigned int                   n_inside = 0;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          inside[j][i] = is_opposite(Point<2>(double(i) / n, double(j) / n));
          n_inside += inside[j][i];
        }
    if (n_inside == 0)
      return;
    if (n_inside == (n + 1) * (n + 1))
      {
        // psi x N x geometry
        const QGauss<2> gauss(slave.degree + 2);
        append_piece<3>(
            gauss.size(),
            [&](const unsigned int q) {
              return slave_point(slave, slave_face, gauss.point(q), gauss.weight(q));
            },
            project,
            reach,
            points);
        return;
      }

    const auto end_between = [&](Point<2> in, Point<2> out) {
      for (unsigned int k = 0; k < 50; ++k)
        {
          const Point<2> middle            = 0.5 * (in + Tensor<1, 2>(out));
          (is_opposite(middle) ? in : out) = middle;
        }
      return in;
    };
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const std::array<unsigned int, 4> columns = {{i, i + 1, i + 1, i}}, rows = {{j, j, j + 1, j + 1}};
          Polygon                           polygon;
          for (unsigned int v = 0, w = 1; v < 4; ++v, w = (v + 1) % 4)
            {
              const bool     in = inside[rows[v]][columns[v]], next_in = inside[rows[w]][columns[w]];
              const Point<2> p(double(columns[v]) / n, double(rows[v]) / n),
                  q(double(columns[w]) / n, double(rows[w]) / n);
              if (in)
                polygon.push_back(p);
              if (in != next_in)
                polygon.push_back(in ? end_between(p, q) : end_between(q, p));
            }
          integrate_polygon(slave,
                            slave_face,
                            polygon,
                            triangle_formula(slave.degree, 0),
                            reach,
                            as_it_is,
                            project,
                            points);
        }
  }
} // namespace Amontons

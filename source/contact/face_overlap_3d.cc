#include <amontons/contact/face_overlap.h>
#include <amontons/contact/overlap_piece.h>
#include <amontons/contact/polygon_clipping.h>

namespace Amontons
{
  namespace
  {
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
  } // namespace

  // Polynomials on faces other than parallelograms converge like rho^-degree, with rho of the Bernstein
  // ellipse that ends where the area element would vanish. Measured: 1e6 in rho^orders leaves 5e-12 of the
  // pressure in patch tests (1e5: 4e-10).
  double
  degree_on_piece(const unsigned int p, const double variation)
  {
    const double z = 1 / std::max(variation, 1e-12);
    return 4 * p + (variation < 1e-12 ? 0 : std::log(1e6) / std::log(z + std::sqrt(z * z - 1)));
  }

  const Quadrature<2> &
  triangle_formula(const double degree)
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
    const unsigned int n = std::ceil(0.5 * (degree <= 2 * n_symmetric - 1 ? degree + 1 : degree + 2));
    return formulas[std::min(n, n_max) - 1];
  }

  Components<2, double>
  pull_back(const Corners<double> &corners, const Components<2, double> &s)
  {
    Components<2, double> xi(Point<2>(0.5, 0.5));
    for (unsigned int iteration = 0; iteration < 20; ++iteration)
      {
        const auto   t    = bilinear_tangents(corners, xi);
        const auto   rest = s - bilinear(corners, xi);
        const double det  = cross(t[0], t[1]);
        const double a = cross(rest, t[1]) / det, b = cross(t[0], rest) / det;
        xi[0] += a;
        xi[1] += b;
        if (std::hypot(a, b) < 1e-9) // quadratic: the next one would be 1e-18
          break;
      }
    return xi;
  }

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
                const double                     search_distance,
                const double                     least_opposed,
                std::vector<OverlapPoint<3>>    &points)
  {
    append_overlaps<3>(slave, slave_face, master, master_faces, search_distance, least_opposed, points);
  }

  void
  overlap_obstacle(const ContactSurface<3>      &slave,
                   const unsigned int            slave_face,
                   const ObstacleData           &obstacle,
                   const AffineMap<3>           &motion,
                   const double                  search_distance,
                   std::vector<OverlapPoint<3>> &points)
  {
    const FaceAD<3, double> face{slave, slave_face};
    const auto              append = [&](const unsigned int n, const auto &slave_point) {
      append_piece<3>(n, slave_face, slave_point, project_to(obstacle, motion), search_distance, points);
    };
    const auto is_opposite = [&](const Point<2> &xi) {
      return project_to_obstacle(
                 obstacle, motion, slave.position(slave_face, xi), slave.nodal_normal(slave_face, xi))
          .has_value();
    };
    const auto as_it_is = [](const Components<2, double> &xi) { return std::make_pair(xi, 1.); };

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
        append(gauss.size(), [&](const unsigned int q) {
          return SlavePoint<3, double>(face, Components<2, double>(gauss.point(q)), gauss.weight(q));
        });
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
          Polygon<double>                   polygon;
          for (unsigned int v = 0, w = 1; v < 4; ++v, w = (v + 1) % 4)
            {
              const bool     in = inside[rows[v]][columns[v]], next_in = inside[rows[w]][columns[w]];
              const Point<2> p(double(columns[v]) / n, double(rows[v]) / n),
                  q(double(columns[w]) / n, double(rows[w]) / n);
              if (in)
                polygon.emplace_back(p);
              if (in != next_in)
                polygon.emplace_back(in ? end_between(p, q) : end_between(q, p));
            }
          integrate_polygon(face, polygon, triangle_formula(4 * slave.degree), as_it_is, append);
        }
  }
} // namespace Amontons

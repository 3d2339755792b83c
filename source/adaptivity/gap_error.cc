#include <amontons/adaptivity/gap_error.h>
#include <amontons/base/points.h>
#include <amontons/contact/declared_gap.h>
#include <amontons/contact/surface_samples.h>
#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <limits>

namespace Amontons
{
  namespace
  {
    template <int dim>
    class GapSampler
    {
    public:
      explicit GapSampler(const unsigned int n_faces)
          : nodes(QGaussLobatto<1>(5)), line(samples_along<dim>(n_faces)), points(line),
            interpolation(points.size(), nodes.size())
      {
        const TensorProductPolynomials<dim - 1> polynomials(
            Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(5).get_points()));
        for (unsigned int q = 0; q < points.size(); ++q)
          for (unsigned int k = 0; k < nodes.size(); ++k)
            interpolation(q, k) = polynomials.compute_value(k, points.point(q));
      }

      struct Unseen
      {
        double slope_square = 0;    // integral over the face
        double least = 0, most = 0; // declared gap
      };

      // Gaps beyond most_of_interest are taken for it.
      Unseen
      operator()(const ContactSurface<dim> &slave,
                 const DeclaredGap<dim>    &declared,
                 const unsigned int         face,
                 const ProblemType          kind,
                 const double               most_of_interest) const
      {
        const auto gap = [&](const Point<dim - 1> &xi) {
          return std::min(declared.at(slave.reference_position(face, xi)), most_of_interest);
        };
        std::vector<double> nodal;
        for (const auto &xi : nodes.get_points())
          nodal.push_back(gap(xi));
        std::vector<double>     all, unseen;
        std::vector<Point<dim>> X;
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            all.push_back(gap(points.point(q)));
            unseen.push_back(all.back());
            for (unsigned int k = 0; k < nodal.size(); ++k)
              unseen.back() -= nodal[k] * interpolation(q, k);
            X.push_back(slave.position(face, points.point(q)));
          }
        Unseen result;
        const auto [least, most] = std::minmax_element(all.begin(), all.end());
        result.least             = *least;
        result.most              = *most;
        for (unsigned int q = 0; q < X.size(); ++q)
          {
            double jacobian;
            slave.face_normal(face, points.point(q), &jacobian);
            const double area = measure<dim>(kind, X[q]) * jacobian;
            for (unsigned int d = 0, stride = 1; d < dim - 1; ++d, stride *= line.size())
              if (const unsigned int place = q / stride % line.size(); place + 1 < line.size())
                {
                  const unsigned int next   = q + stride;
                  const double       across = dim == 3 ? points.weight(q) / line.weight(place) : 1;
                  result.slope_square += area * across * (points.point(next)[d] - points.point(q)[d]) *
                                         std::pow((unseen[next] - unseen[q]) / X[next].distance(X[q]), 2);
                }
          }
        return result;
      }

    private:
      const Quadrature<dim - 1> nodes;
      const QGauss<1>           line;
      const Quadrature<dim - 1> points;
      FullMatrix<double>        interpolation; // at the points, of values at the nodes
    };

    // By slave face: what is open now, without the declared gap; infinite where nothing is opposite. At small
    // strain by how much nodes have come nearer, at finite strain the mean gap of the bodies where they are.
    template <int dim>
    std::vector<double>
    gaps_beside_declared(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields)
    {
      const auto         &slave = *interface.slave;
      std::vector<double> sum(slave.faces.size(), 0.), weights(sum), result;
      for (const auto &point : interface.coupling.points)
        {
          const auto X = slave.reference_position(point.slave_face, point.xi_slave);
          sum[point.slave_face] +=
              point.weight * (point.gap - interface.pair->initial_gap->value(as_3d(X), interface.t));
          weights[point.slave_face] += point.weight;
        }
      constexpr double    unknown = std::numeric_limits<double>::lowest();
      std::vector<double> approach(slave.nodes.size(), unknown);
      for (const auto &row : interface.coupling.rows)
        if (std::isfinite(fields.gap[row.node]))
          approach[row.node] = slave.moved ? 0 : row.gap - fields.gap[row.node];
      for (unsigned int f = 0; f < sum.size(); ++f)
        {
          double nearer = unknown;
          for (const unsigned int i : slave.faces[f].nodes)
            nearer = std::max(nearer, approach[i]);
          result.push_back(weights[f] > 0 ? sum[f] / weights[f] - nearer
                                          : std::numeric_limits<double>::infinity());
        }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<double>
  gap_errors(const ContactInterface<dim> &interface,
             const SurfaceFields<dim>    &fields,
             const double                 modulus,
             const ProblemType            kind,
             const std::vector<bool>     &near)
  {
    const auto         &slave = *interface.slave;
    std::vector<double> result(slave.faces.size(), 0.);
    if (interface.pair->tied || !interface.pair->initial_gap ||
        !interface.pair->initial_gap->depends_on_place())
      return result;
    const auto             gaps_beside = gaps_beside_declared(interface, fields);
    const DeclaredGap<dim> declared(*interface.pair, slave, interface.t);
    const GapSampler<dim>  sampler(slave.faces.size());
    for (unsigned int f = 0; f < result.size(); ++f)
      {
        // An edge between nodes is seen, as far as the mesh allows: its pressure tells. Of a tip or a notch
        // between them counts whether it is open, not by how much.
        auto unseen = sampler(slave, declared, f, kind, std::numeric_limits<double>::infinity());
        if (declared.jumps(f))
          {
            if (declared.is_within_unknowns(f, unseen.least, unseen.most))
              continue;
            if (std::isfinite(gaps_beside[f]))
              unseen = sampler(
                  slave, declared, f, kind, std::max(unseen.least, -2 * gaps_beside[f] - unseen.least));
          }
        if (near[f] || unseen.least + gaps_beside[f] < -1e-6 * (unseen.most - unseen.least)) // not rounding
          result[f] = modulus * modulus / 4 * unseen.slope_square;
      }
    return result;
  }

  template <int dim>
  double
  sum_of_smooth_gap(const ContactInterface<dim> &interface,
                    const std::vector<double>   &by_face,
                    const unsigned int           rank)
  {
    const auto &gap = interface.pair->initial_gap;
    double      sum = 0;
    for (unsigned int f = 0; gap && !gap->may_jump() && f < by_face.size(); ++f)
      sum += interface.slave->faces[f].rank == rank ? by_face[f] : 0;
    return sum;
  }

  template double
  sum_of_smooth_gap(const ContactInterface<2> &, const std::vector<double> &, const unsigned int);
  template double
  sum_of_smooth_gap(const ContactInterface<3> &, const std::vector<double> &, const unsigned int);
  template std::vector<double>
  gap_errors(const ContactInterface<2> &,
             const SurfaceFields<2> &,
             const double,
             const ProblemType,
             const std::vector<bool> &);
  template std::vector<double>
  gap_errors(const ContactInterface<3> &,
             const SurfaceFields<3> &,
             const double,
             const ProblemType,
             const std::vector<bool> &);
} // namespace Amontons

#include <amontons/adaptivity/gap_error.h>
#include <amontons/base/points.h>
#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/tensor_product_polynomials.h>

namespace Amontons
{
  namespace
  {
    // Gauss points, whose distances differ, so that no wave fits all of them.
    template <int dim>
    class GapSampler
    {
    public:
      GapSampler()
          : nodes(QGaussLobatto<1>(5)), line(dim == 2 ? 24 : 8), points(line),
            polynomials(Polynomials::generate_complete_Lagrange_basis(QGaussLobatto<1>(5).get_points()))
      {
      }

      struct Unseen
      {
        double slope_square = 0, lowest = 0; // integral over the face; value
      };

      Unseen
      operator()(const ContactInterface<dim> &interface,
                 const unsigned int           face,
                 const ProblemType            kind) const
      {
        const auto &slave = *interface.slave;
        const auto  gap   = [&](const Point<dim - 1> &xi) {
          return interface.pair->initial_gap->value(as_3d(slave.reference_position(face, xi)), interface.t);
        };
        std::vector<double> nodal;
        for (const auto &xi : nodes.get_points())
          nodal.push_back(gap(xi));
        std::vector<double>     unseen;
        std::vector<Point<dim>> X;
        for (const auto &xi : points.get_points())
          {
            unseen.push_back(gap(xi));
            for (unsigned int k = 0; k < nodal.size(); ++k)
              unseen.back() -= nodal[k] * polynomials.compute_value(k, xi);
            X.push_back(slave.position(face, xi));
          }
        Unseen result;
        result.lowest = *std::min_element(unseen.begin(), unseen.end());
        for (unsigned int q = 0; q < X.size(); ++q)
          for (unsigned int d = 0, stride = 1; d < dim - 1; ++d, stride *= line.size())
            if (q / stride % line.size() + 1 < line.size())
              {
                const unsigned int next = q + stride;
                double             jacobian, across = 1; // the weight along the other direction
                slave.face_normal(face, points.point(q), &jacobian);
                if (dim == 3)
                  across = points.weight(q) / line.weight(q / stride % line.size());
                result.slope_square += measure<dim>(kind, X[q]) * jacobian * across *
                                       (points.point(next)[d] - points.point(q)[d]) *
                                       std::pow((unseen[next] - unseen[q]) / X[next].distance(X[q]), 2);
              }
        return result;
      }

    private:
      const Quadrature<dim - 1>               nodes;
      const QGauss<1>                         line;
      const Quadrature<dim - 1>               points;
      const TensorProductPolynomials<dim - 1> polynomials;
    };
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
    const GapSampler<dim> sampler;
    for (unsigned int f = 0; f < result.size(); ++f)
      {
        const auto unseen   = sampler(interface, f, kind);
        double     smallest = std::numeric_limits<double>::max(); // nan: nothing is opposite
        for (const unsigned int i : slave.faces[f].nodes)
          smallest = std::min(smallest, std::isnan(fields.gap[i]) ? smallest : fields.gap[i]);
        if (near[f] || smallest + unseen.lowest < 0)
          result[f] = modulus * modulus / 4 * unseen.slope_square;
      }
    return result;
  }

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

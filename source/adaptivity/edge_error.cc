#include <amontons/adaptivity/edge_error.h>
#include <amontons/adaptivity/face_points.h>
#include <amontons/contact/contact_edge.h>
#include <amontons/contact/face_basis.h>
#include <amontons/elasticity/kinematics.h>

namespace Amontons
{
  namespace
  {
    // In space, of a function on a face by its nodal values: cos(2 a)^4, where the line along which it is
    // constant makes the angle a with the nearest side of the unit face.
    double
    alignment(const std::vector<double>       &values,
              const std::vector<unsigned int> &nodes,
              const unsigned int               degree,
              const Quadrature<2>             &quadrature)
    {
      Tensor<1, 2> gradient;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const auto dN = lagrange_gradients(degree, quadrature.point(q));
          for (unsigned int i = 0; i < dN.size(); ++i)
            gradient += quadrature.weight(q) * values[nodes[i]] * dN[i];
        }
      const double square = gradient.norm_square();
      return square > 0 ? std::pow((gradient[0] * gradient[0] - gradient[1] * gradient[1]) / square, 4) : 0.;
    }
    double
    alignment(const std::vector<double> &,
              const std::vector<unsigned int> &,
              const unsigned int,
              const Quadrature<1> &)
    {
      return 1;
    }

    // By slave node: of a face in which the contact ends. What has nothing opposite is not open: at the edge
    // of a body that deforms no pressure falls to zero.
    template <int dim>
    std::vector<bool>
    nodes_at_end(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields, const bool deforms)
    {
      const auto presses = [&](const unsigned int i) { return fields.pressure[i] > 0; };
      const auto is_open = [&](const unsigned int i) {
        return deforms ? fields.state[i] == ContactStatus::open && !std::isnan(fields.gap[i]) : !presses(i);
      };
      std::vector<bool> result(interface.slave->nodes.size(), false);
      for (const auto &face : interface.slave->faces)
        if (std::any_of(face.nodes.begin(), face.nodes.end(), presses) &&
            std::any_of(face.nodes.begin(), face.nodes.end(), is_open))
          for (const unsigned int i : face.nodes)
            result[i] = true;
      return result;
    }

    // Points and their areas, by slave face, on the overlap if an edge of a master that deforms cuts the
    // face.
    template <int dim>
    using Points = std::vector<std::pair<Point<dim - 1>, double>>;
    template <int dim>
    std::vector<Points<dim>>
    points_of_cut_faces(const ContactInterface<dim> &interface, const bool deforms)
    {
      const auto              &coupling = interface.coupling;
      std::vector<Points<dim>> result(interface.slave->faces.size());
      for (const auto &point : coupling.points)
        if (deforms && coupling.whole_faces.count(point.slave_face) == 0)
          result[point.slave_face].emplace_back(point.xi_slave, point.weight);
      return result;
    }

    template <int dim>
    Points<dim>
    points_of_whole_face(const ContactSurface<dim> &slave,
                         const unsigned int         face,
                         const ProblemType          kind,
                         const Quadrature<dim - 1> &quadrature)
    {
      Points<dim> result;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const auto &xi = quadrature.point(q);
          double      jacobian;
          slave.face_normal(face, xi, &jacobian);
          result.emplace_back(xi,
                              quadrature.weight(q) * jacobian * measure<dim>(kind, slave.position(face, xi)));
        }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<double>
  edge_errors(const ContactInterface<dim> &interface,
              const SurfaceFields<dim>    &fields,
              const Scene                 &scene,
              const Quadrature<dim - 1>   &quadrature)
  {
    const auto         &slave = *interface.slave;
    std::vector<double> result(slave.faces.size(), 0.);
    if (interface.pair->tied)
      return result;
    const bool deforms = master_deforms(interface, scene);
    const auto at_end  = nodes_at_end(interface, fields, deforms);
    if (std::none_of(at_end.begin(), at_end.end(), [](const bool is) { return is; }))
      return result;
    auto points = points_of_cut_faces(interface, deforms);
    auto square = signed_pressure_square(interface, fields);
    for (unsigned int i = 0; i < square.size(); ++i)
      if (deforms && std::isnan(fields.gap[i]))
        square[i] = fields.pressure[i] * fields.pressure[i];
    for (unsigned int f = 0; f < result.size(); ++f)
      {
        const auto &nodes = slave.faces[f].nodes;
        if (std::none_of(nodes.begin(), nodes.end(), [&](const unsigned int i) { return at_end[i]; }))
          continue;
        const double part = alignment(square, nodes, slave.degree, quadrature);
        if (!deforms || interface.coupling.whole_faces.count(f) > 0)
          points[f] = points_of_whole_face(slave, f, scene.kind, quadrature);
        for (const auto &[xi, area] : points[f])
          {
            const auto N = lagrange_values<dim - 1>(slave.degree, xi);
            double     p = 0, s = 0;
            for (unsigned int i = 0; i < N.size(); ++i)
              {
                p += N[i] * fields.pressure[nodes[i]];
                s += N[i] * square[nodes[i]];
              }
            result[f] += part * area * std::pow(std::sqrt(std::max(0., s)) - p, 2);
          }
      }
    return result;
  }

  template std::vector<double>
  edge_errors(const ContactInterface<2> &, const SurfaceFields<2> &, const Scene &, const Quadrature<1> &);
  template std::vector<double>
  edge_errors(const ContactInterface<3> &, const SurfaceFields<3> &, const Scene &, const Quadrature<2> &);
} // namespace Amontons

#include <amontons/adaptivity/edge_error.h>
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
  } // namespace

  template <int dim>
  std::vector<double>
  edge_errors(const ContactInterface<dim> &interface,
              const SurfaceFields<dim>    &fields,
              const ProblemType            kind,
              const Quadrature<dim - 1>   &quadrature)
  {
    const auto         &slave = *interface.slave;
    std::vector<double> result(slave.faces.size(), 0.);
    if (interface.pair->tied)
      return result;
    // What has nothing opposite is not open: at an edge of the other side no pressure falls to zero.
    const auto presses = [&](const unsigned int i) { return fields.pressure[i] > 0; };
    const auto is_open = [&](const unsigned int i) { return !presses(i) && !std::isnan(fields.gap[i]); };
    std::vector<bool> of_edge(slave.nodes.size(), false);
    for (const auto &face : slave.faces)
      if (std::any_of(face.nodes.begin(), face.nodes.end(), presses) &&
          std::any_of(face.nodes.begin(), face.nodes.end(), is_open))
        for (const unsigned int i : face.nodes)
          of_edge[i] = true;
    if (std::none_of(of_edge.begin(), of_edge.end(), [](const bool is) { return is; }))
      return result;
    auto square = signed_pressure_square(interface, fields);
    for (unsigned int i = 0; i < square.size(); ++i)
      if (std::isnan(fields.gap[i]))
        square[i] = fields.pressure[i] * fields.pressure[i];
    for (unsigned int f = 0; f < result.size(); ++f)
      {
        const auto &nodes = slave.faces[f].nodes;
        if (std::none_of(nodes.begin(), nodes.end(), [&](const unsigned int i) { return of_edge[i]; }))
          continue;
        const double part = alignment(square, nodes, slave.degree, quadrature);
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const auto &xi = quadrature.point(q);
            const auto  N  = lagrange_values<dim - 1>(slave.degree, xi);
            double      p = 0, s = 0, jacobian;
            for (unsigned int i = 0; i < N.size(); ++i)
              {
                p += N[i] * fields.pressure[nodes[i]];
                s += N[i] * square[nodes[i]];
              }
            slave.face_normal(f, xi, &jacobian);
            result[f] += part * quadrature.weight(q) * jacobian * measure<dim>(kind, slave.position(f, xi)) *
                         std::pow(std::sqrt(std::max(0., s)) - p, 2);
          }
      }
    return result;
  }

  template std::vector<double>
  edge_errors(const ContactInterface<2> &,
              const SurfaceFields<2> &,
              const ProblemType,
              const Quadrature<1> &);
  template std::vector<double>
  edge_errors(const ContactInterface<3> &,
              const SurfaceFields<3> &,
              const ProblemType,
              const Quadrature<2> &);
} // namespace Amontons

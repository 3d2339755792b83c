#include <amontons/contact/contact_edge.h>

#include <set>

namespace Amontons
{
  namespace
  {
    // Value at X of the linear function that fits `values` at the nodes best, with weights 1/distance^2; the
    // coordinates are those in the surface, around X. Too few nodes for a slope: their mean.
    template <int dim>
    double
    extrapolate(const ContactSurface<dim>    &surface,
                const unsigned int            node,
                const std::set<unsigned int> &others,
                const std::vector<double>    &values)
    {
      constexpr unsigned int n      = dim; // 1, and the dim - 1 coordinates in the surface
      const Point<dim>      &X      = surface.nodes[node].X;
      const Tensor<1, dim>  &normal = surface.nodes[node].normal;

      std::array<Tensor<1, dim>, dim - 1> axes;
      unsigned int                        smallest = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (std::abs(normal[d]) < std::abs(normal[smallest]))
          smallest = d;
      Tensor<1, dim> first;
      first[smallest] = 1;
      first -= (first * normal) * normal;
      axes[0] = first / first.norm();
      if constexpr (dim == 3)
        axes[1] = cross_product_3d(normal, axes[0]);

      double size = 0;
      for (const unsigned int i : others)
        size = std::max(size, surface.nodes[i].X.distance(X));
      FullMatrix<double> A(n, n), inverse(n, n);
      Vector<double>     b(n), x(n);
      double             sum = 0;
      for (const unsigned int i : others)
        {
          const Tensor<1, dim>  r = (surface.nodes[i].X - X) / size;
          std::array<double, n> row;
          row[0] = 1;
          for (unsigned int d = 0; d < dim - 1; ++d)
            row[d + 1] = r * axes[d];
          const double weight = 1 / r.norm_square();
          for (unsigned int k = 0; k < n; ++k)
            {
              for (unsigned int l = 0; l < n; ++l)
                A(k, l) += weight * row[k] * row[l];
              b[k] += weight * row[k] * values[i];
            }
          sum += values[i];
        }
      if (others.size() < n || !(std::abs(A.determinant()) > 1e-6 * std::pow(A(0, 0), n)))
        return sum / others.size();
      inverse.invert(A);
      inverse.vmult(x, b);
      return x[0];
    }
  } // namespace

  template <int dim>
  std::vector<double>
  signed_pressure_square(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields)
  {
    const auto         &slave = *interface.slave;
    std::vector<double> result(slave.nodes.size());
    double              largest = 0;
    const auto          presses = [&](const unsigned int i) {
      return fields.state[i] != ContactStatus::open && fields.pressure[i] > 0;
    };
    for (unsigned int i = 0; i < result.size(); ++i)
      if (presses(i))
        {
          result[i] = fields.pressure[i] * fields.pressure[i];
          largest   = std::max(largest, result[i]);
        }
    // Nodes under pressure in the faces at each node.
    std::vector<std::set<unsigned int>> beside(result.size());
    for (const auto &face : slave.faces)
      for (const unsigned int i : face.nodes)
        for (const unsigned int j : face.nodes)
          if (presses(j))
            beside[i].insert(j);
    for (unsigned int i = 0; i < result.size(); ++i)
      if (!presses(i))
        {
          std::set<unsigned int> around = beside[i];
          for (const unsigned int j : beside[i])
            around.insert(beside[j].begin(), beside[j].end());
          result[i] = around.empty() ? -largest : std::min(0., extrapolate(slave, i, around, result));
        }
    for (unsigned int i = 0; i < result.size(); ++i)
      if (!slave.nodes[i].parents.empty())
        {
          result[i] = 0;
          for (const auto &[parent, weight] : slave.nodes[i].parents)
            result[i] += weight * result[parent];
        }
    return result;
  }

  template std::vector<double>
  signed_pressure_square(const ContactInterface<2> &, const SurfaceFields<2> &);
  template std::vector<double>
  signed_pressure_square(const ContactInterface<3> &, const SurfaceFields<3> &);
} // namespace Amontons

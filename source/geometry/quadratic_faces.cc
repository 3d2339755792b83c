#include <amontons/geometry/quadratic_faces.h>

#include <deal.II/grid/manifold.h>

#include <sstream>
#include <stdexcept>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // The quadratic polynomials of the nodes 0, 1/2, 1 and their derivatives.
    std::array<double, 3>
    values(const double s)
    {
      return {{(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)}};
    }

    std::array<double, 3>
    slopes(const double s)
    {
      return {{4 * s - 3, 4 - 8 * s, 4 * s - 1}};
    }

    // x(s) = sum over the nodes, s in [0, 1]^chartdim; nodes lexicographic.
    template <int dim, int chartdim>
    class QuadraticManifold : public ChartManifold<dim, dim, chartdim>
    {
    public:
      static constexpr unsigned int n_nodes = chartdim == 1 ? 3 : 9;

      explicit QuadraticManifold(const std::array<Point<dim>, n_nodes> &nodes) : nodes(nodes) {}

      std::unique_ptr<Manifold<dim, dim>>
      clone() const override
      {
        return std::make_unique<QuadraticManifold<dim, chartdim>>(nodes);
      }

      Point<dim>
      push_forward(const Point<chartdim> &s) const override
      {
        Point<dim> x;
        for (unsigned int i = 0; i < n_nodes; ++i)
          x += shape(i, s) * nodes[i];
        return x;
      }

      DerivativeForm<1, chartdim, dim>
      push_forward_gradient(const Point<chartdim> &s) const override
      {
        DerivativeForm<1, chartdim, dim> gradient;
        for (unsigned int d = 0; d < chartdim; ++d)
          {
            const Tensor<1, dim> t = tangent(s, d);
            for (unsigned int c = 0; c < dim; ++c)
              gradient[c][d] = t[c];
          }
        return gradient;
      }

      // The points lie on the surface, so that Gauss and Newton's method converges quadratically.
      Point<chartdim>
      pull_back(const Point<dim> &p) const override
      {
        Point<chartdim> s;
        for (unsigned int d = 0; d < chartdim; ++d)
          s[d] = 0.5;
        for (unsigned int iteration = 0; iteration < 30; ++iteration)
          {
            const Tensor<1, dim> rest = p - push_forward(s);
            Tensor<2, chartdim>  metric;
            Tensor<1, chartdim>  along;
            for (unsigned int d = 0; d < chartdim; ++d)
              {
                along[d] = tangent(s, d) * rest;
                for (unsigned int e = 0; e < chartdim; ++e)
                  metric[d][e] = tangent(s, d) * tangent(s, e);
              }
            const Tensor<1, chartdim> step = invert(metric) * along;
            s += step;
            if (step.norm() < 1e-15)
              break;
          }
        return s;
      }

    private:
      double
      shape(const unsigned int i, const Point<chartdim> &s) const
      {
        double value = values(s[0])[i % 3];
        if (chartdim == 2)
          value *= values(s[chartdim - 1])[i / 3];
        return value;
      }

      Tensor<1, dim>
      tangent(const Point<chartdim> &s, const unsigned int direction) const
      {
        Tensor<1, dim> t;
        for (unsigned int i = 0; i < n_nodes; ++i)
          {
            double slope = direction == 0 ? slopes(s[0])[i % 3] : values(s[0])[i % 3];
            if (chartdim == 2)
              slope *= direction == 1 ? slopes(s[chartdim - 1])[i / 3] : values(s[chartdim - 1])[i / 3];
            t += slope * nodes[i];
          }
        return t;
      }

      const std::array<Point<dim>, n_nodes> nodes;
    };

    // Flatter ones are straight but for the digits of the file.
    constexpr double flat = 1e-6;

    template <int dim>
    class Attachment
    {
    public:
      Attachment(const MiddleNodes<dim>  &middle,
                 const types::manifold_id first_id,
                 Triangulation<dim>      &triangulation)
          : next_id(first_id), middle(middle), triangulation(triangulation)
      {
      }

      void
      run()
      {
        for (const auto &cell : triangulation.cell_iterators_on_level(0))
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->manifold_id() == numbers::flat_manifold_id)
              attach(face);
      }

      types::manifold_id next_id;

    private:
      template <int structdim>
      using Object = TriaIterator<TriaAccessor<structdim, dim, dim>>;

      void
      attach(const Object<1> &line)
      {
        const auto nodes = nodes_of(line->vertex_index(0), line->vertex_index(1));
        if (line->manifold_id() != numbers::flat_manifold_id || !is_curved(nodes))
          return;
        check(nodes);
        line->set_manifold_id(next_id);
        triangulation.set_manifold(next_id++, QuadraticManifold<dim, 1>(nodes));
      }

      // Its edges have manifolds of their own, since two faces share each of them.
      void
      attach(const Object<2> &quad)
      {
        std::array<unsigned int, 4> v, sorted;
        for (unsigned int k = 0; k < 4; ++k)
          v[k] = sorted[k] = quad->vertex_index(k);
        std::sort(sorted.begin(), sorted.end());
        std::array<Point<dim>, 9> nodes;
        bool                      curved = false;
        // first and last node of each edge, with the one between them
        for (const auto &[k, l] :
             std::vector<std::pair<unsigned int, unsigned int>>{{0, 1}, {0, 2}, {1, 3}, {2, 3}})
          {
            const auto         edge = nodes_of(v[k], v[l]);
            const unsigned int i = 6 * (k / 2) + 2 * (k % 2), j = 6 * (l / 2) + 2 * (l % 2);
            nodes[i]           = edge[0];
            nodes[(i + j) / 2] = edge[1];
            nodes[j]           = edge[2];
            curved             = curved || is_curved(edge);
          }
        // that of the eight-node face
        for (const unsigned int k : {1, 3, 5, 7})
          nodes[4] += 0.5 * nodes[k];
        for (const unsigned int k : {0, 2, 6, 8})
          nodes[4] -= 0.25 * Tensor<1, dim>(nodes[k]);
        if (const auto centre = middle.of_faces.find(sorted); centre != middle.of_faces.end())
          {
            curved   = curved || centre->second.distance(nodes[4]) > flat * quad->diameter();
            nodes[4] = centre->second;
          }
        if (!curved)
          return;
        quad->set_manifold_id(next_id);
        triangulation.set_manifold(next_id++, QuadraticManifold<dim, 2>(nodes));
        for (unsigned int l = 0; l < 4; ++l)
          attach(quad->line(l));
      }

      // From vertex to vertex, with the node between them (or the middle).
      std::array<Point<dim>, 3>
      nodes_of(const unsigned int first, const unsigned int last) const
      {
        const auto &vertices = triangulation.get_vertices();
        const auto  node     = middle.of_edges.find({{std::min(first, last), std::max(first, last)}});
        return {{vertices[first],
                 node != middle.of_edges.end() ? node->second
                                               : vertices[first] + 0.5 * (vertices[last] - vertices[first]),
                 vertices[last]}};
      }

      static bool
      is_curved(const std::array<Point<dim>, 3> &nodes)
      {
        const Tensor<1, dim> chord = nodes[2] - nodes[0];
        Tensor<1, dim>       off   = nodes[1] - nodes[0];
        off -= (off * chord) / chord.norm_square() * chord;
        return off.norm() > flat * chord.norm();
      }

      static void
      check(const std::array<Point<dim>, 3> &nodes)
      {
        const Tensor<1, dim> chord = nodes[2] - nodes[0];
        for (const double s : {0., 1.})
          {
            Tensor<1, dim> tangent;
            for (unsigned int i = 0; i < 3; ++i)
              tangent += slopes(s)[i] * nodes[i];
            if (!(tangent * chord > 0))
              {
                std::ostringstream text;
                text << "the node at (" << nodes[1]
                     << ") is so far from the middle of its edge that the edge turns back";
                throw std::invalid_argument(text.str());
              }
          }
      }

      const MiddleNodes<dim> &middle;
      Triangulation<dim>     &triangulation;
    };
  } // namespace

  template <int dim>
  types::manifold_id
  attach_quadratic_faces(const MiddleNodes<dim>  &nodes,
                         const types::manifold_id first_id,
                         Triangulation<dim>      &triangulation)
  {
    Attachment<dim> attachment(nodes, first_id, triangulation);
    if (!nodes.of_edges.empty())
      attachment.run();
    return attachment.next_id;
  }

  template types::manifold_id
  attach_quadratic_faces(const MiddleNodes<2> &, const types::manifold_id, Triangulation<2> &);
  template types::manifold_id
  attach_quadratic_faces(const MiddleNodes<3> &, const types::manifold_id, Triangulation<3> &);
} // namespace Amontons

#include <amontons/base/directions.h>
#include <amontons/contact/contact_surface.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/face_lattice.h>

namespace Amontons
{
  namespace
  {
    // An orthonormal basis of what the planes' normals span; a plane that leaves no direction for n is left
    // out.
    template <int dim>
    std::vector<Tensor<1, dim>>
    directions_to_remove(const std::vector<Tensor<1, dim>> &planes, Tensor<1, dim> n)
    {
      std::vector<Tensor<1, dim>> removed;
      for (Tensor<1, dim> m : planes)
        {
          m = without(m, removed);
          if (m.norm() < 1e-6)
            continue;
          m /= m.norm();
          const auto projected = n - (n * m) * m;
          if (projected.norm() <= 1e-6)
            continue;
          n = projected / projected.norm();
          removed.push_back(m);
        }
      return removed;
    }
  } // namespace

  namespace
  {
    // Columns: tangents at the centre of the finite elements' face, and the unit normal there.
    template <int dim>
    Tensor<2, dim>
    centre_frame(const std::array<Tensor<1, dim>, dim - 1> &tangents)
    {
      const Tensor<1, dim> c      = area_vector(tangents);
      const Tensor<1, dim> normal = c / c.norm();
      Tensor<2, dim>       result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          for (unsigned int k = 0; k < dim - 1; ++k)
            result[d][k] = tangents[k][d];
          result[d][dim - 1] = normal[d];
        }
      return result;
    }

    // d(c/|c|), c = area vector, by [component][direction] of a point whose motion changes the tangents so:
    //   dn = (1 - n n^T) dc/|c|.
    template <int dim>
    Tensor<2, dim>
    unit_normal_gradient(const std::array<Tensor<1, dim>, dim - 1> &tangents,
                         const std::array<Tensor<2, dim>, dim - 1> &of_tangents)
    {
      const Tensor<1, dim> c      = area_vector(tangents);
      const double         length = c.norm();
      const Tensor<1, dim> n      = c / length;
      Tensor<2, dim>       result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          Tensor<1, dim> dc;
          for (unsigned int e = 0; e < dim - 1; ++e)
            {
              auto changed = tangents;
              for (unsigned int i = 0; i < dim; ++i)
                changed[e][i] = of_tangents[e][i][d];
              dc += area_vector(changed);
            }
          for (unsigned int i = 0; i < dim; ++i)
            result[i][d] = (dc[i] - (n * dc) * n[i]) / length;
        }
      return result;
    }

    // Where the nodes of the face are, as x(node).
    template <int dim, typename Position>
    std::array<Tensor<1, dim>, dim - 1>
    centre_tangents(const SurfaceFace<dim> &face, const unsigned int degree, const Position &x)
    {
      const auto slopes = lagrange_gradients<dim - 1>(degree, face_centre<dim - 1>());
      std::array<Tensor<1, dim>, dim - 1> tangents;
      for (unsigned int j = 0; j < slopes.size(); ++j)
        for (unsigned int k = 0; k < dim - 1; ++k)
          tangents[k] += slopes[j][k] * x(face.nodes[j]);
      return tangents;
    }
  } // namespace

  template <int dim>
  void
  ContactSurface<dim>::find_deviation(SurfaceFace<dim> &face) const
  {
    const auto           X        = [this](const unsigned int node) { return nodes[node].X; };
    const Tensor<2, dim> to_frame = invert(centre_frame<dim>(centre_tangents<dim>(face, degree, X)));
    const auto           points   = lattice<dim - 1>(geometry_degree);
    double               largest  = 0;
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const auto     N = lagrange_values<dim - 1>(degree, points[k]);
        Tensor<1, dim> d = face.geometry[k];
        for (unsigned int j = 0; j < N.size(); ++j)
          d -= N[j] * X(face.nodes[j]);
        largest = std::max(largest, d.norm() / (face.size + face.geometry[k].norm()));
        face.deviation.emplace_back(to_frame * d);
      }
    if (largest < 1e-14)
      face.deviation.clear();
  }

  template <int dim>
  bool
  ContactSurface<dim>::move(const LA::Vector &u)
  {
    bool changed = !moved;
    moved        = true;
    for (auto &node : nodes)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double x = node.X[c] + u(node.dofs[c]);
          changed        = changed || x != node.x[c];
          node.x[c]      = x;
        }
    if (!changed)
      return false;
    std::vector<std::vector<double>> values; // of the nodes' shape functions at the lattice points
    for (const auto &xi : lattice<dim - 1>(geometry_degree))
      values.push_back(lagrange_values<dim - 1>(degree, xi));
    const auto slopes_at_centre = lagrange_gradients<dim - 1>(degree, face_centre<dim - 1>());
    for (auto &face : faces)
      {
        for (unsigned int k = 0; k < face.geometry.size(); ++k)
          {
            face.geometry[k] = Point<dim>();
            for (unsigned int j = 0; j < face.nodes.size(); ++j)
              face.geometry[k] += values[k][j] * nodes[face.nodes[j]].x;
          }
        if (!face.deviation.empty())
          {
            const auto tangents =
                centre_tangents<dim>(face, degree, [this](const unsigned int node) { return nodes[node].x; });
            const auto frame = centre_frame<dim>(tangents);
            for (unsigned int k = 0; k < face.geometry.size(); ++k)
              face.geometry[k] += frame * face.deviation[k];
            face.centre_normal_gradient.clear();
            for (const auto &slopes : slopes_at_centre)
              {
                std::array<Tensor<2, dim>, dim - 1> of_tangents;
                for (unsigned int k = 0; k < dim - 1; ++k)
                  of_tangents[k] = slopes[k] * unit_symmetric_tensor<dim>();
                face.centre_normal_gradient.push_back(unit_normal_gradient<dim>(tangents, of_tangents));
              }
          }
        measure(face);
      }
    make_normals();
    return true;
  }

  template <int dim>
  Tensor<1, dim>
  ContactSurface<dim>::sum_of_normals(const unsigned int                 node,
                                      const std::vector<Point<dim - 1>> &points) const
  {
    Tensor<1, dim> sum;
    for (const auto &[f, k] : faces_at[node])
      sum += face_normal(f, points[k]);
    return sum;
  }

  // A surface and its mirror image make a kink where it leans to the plane by more than its facets do: those
  // of a smooth one turn by twice as much from one to the next. On the axis of revolution a kink has no area.
  template <int dim>
  void
  ContactSurface<dim>::find_crossed_planes(const bool axisymmetric)
  {
    const auto points  = lattice<dim - 1>(degree);
    const auto mean_at = [&](const unsigned int node) {
      const auto sum = sum_of_normals(node, points);
      return sum / sum.norm();
    };
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        auto &walls = nodes[i].walls;
        if ((nodes[i].symmetry_planes.empty() && walls.empty()) || faces_at[i].empty())
          continue;
        double half_turn = 0; // from face to face beside
        for (const auto &[f, k] : faces_at[i])
          for (unsigned int j = 0; j < points.size(); ++j)
            half_turn = std::max(half_turn, (face_normal(f, points[j]) - mean_at(faces[f].nodes[j])).norm());
        const auto is_crossed = [&](const auto &plane) {
          return axisymmetric || std::abs(plane * mean_at(i)) <= 1e-3 + 2 * half_turn;
        };
        std::copy_if(nodes[i].symmetry_planes.begin(),
                     nodes[i].symmetry_planes.end(),
                     std::back_inserter(nodes[i].crossed_planes),
                     is_crossed);
        walls.erase(std::remove_if(walls.begin(), walls.end(), is_crossed), walls.end());
      }
  }

  // Mean of the face normals at the node, weighted by nothing; then made to lie in the symmetry planes (and
  // on the axis of revolution) that the surface crosses there.
  template <int dim>
  void
  ContactSurface<dim>::make_normals()
  {
    const auto points = lattice<dim - 1>(degree);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      nodes[i].normal = sum_of_normals(i, points);
    for (const auto &node : nodes)
      for (const auto &[parent, weight] : node.parents) // on no face
        if (nodes[parent].normal.norm() == 0)
          nodes[parent].normal += weight * node.normal;
    for (auto &node : nodes)
      {
        node.normal /= node.normal.norm();
        if (node.crossed_planes.empty())
          continue;
        node.normal = without(node.normal, directions_to_remove(node.crossed_planes, node.normal));
        node.normal /= node.normal.norm();
      }
  }

  // With the face normals n_f, the directions q that are removed and s = sum_f n_f:
  //   n = P s / |P s|,   P = 1 - sum q q^T,   dn = (1 - n n^T) P ds / |P s|,
  // and dn_f by dt_k = sum_j dN_j/dxi_k du_j and what the deviation adds.
  template <int dim>
  std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>
  ContactSurface<dim>::normal_gradient(const unsigned int node) const
  {
    if (nodes[node].holds_normal) // (the obstacle's curvature is little over the steps of an iteration)
      return {};
    const auto                                        points = lattice<dim - 1>(degree);
    Tensor<1, dim>                                    sum;
    std::map<types::global_dof_index, Tensor<1, dim>> gradient;
    for (const auto &[f, k] : faces_at[node])
      {
        const auto tangents = frame(f, points[k]).tangents;
        sum += face_normal(f, points[k]);
        const auto slopes  = lagrange_gradients<dim - 1>(degree, points[k]);
        const bool follows = !faces[f].deviation.empty();
        const auto further = follows ? deviation_gradient(f, points[k]) : std::vector<DeviationGradient>();
        for (unsigned int j = 0; j < slopes.size(); ++j)
          {
            if (!follows && slopes[j].norm() == 0)
              continue;
            std::array<Tensor<2, dim>, dim - 1> of_tangents;
            for (unsigned int e = 0; e < dim - 1; ++e)
              {
                of_tangents[e] = slopes[j][e] * unit_symmetric_tensor<dim>();
                if (follows)
                  of_tangents[e] += further[j].slopes[e];
              }
            const auto dn = faces[f].sign * unit_normal_gradient<dim>(tangents, of_tangents);
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int c = 0; c < dim; ++c)
                gradient[nodes[faces[f].nodes[j]].dofs[d]][c] += dn[c][d];
          }
      }
    const auto          &planes  = nodes[node].crossed_planes;
    const auto           removed = directions_to_remove(planes, sum / sum.norm());
    const Tensor<1, dim> kept    = without(sum, removed);
    const Tensor<1, dim> n       = kept / kept.norm();
    for (auto &entry : gradient)
      {
        const Tensor<1, dim> ds = without(entry.second, removed) / kept.norm();
        entry.second            = ds - (n * ds) * n;
      }
    return {gradient.begin(), gradient.end()};
  }

  template <int dim>
  void
  ContactSurface<dim>::find_sharpest_edge()
  {
    const auto points = lattice<dim - 1>(degree);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        const Tensor<1, dim> mean = sum_of_normals(i, points);
        for (const auto &[f, k] : faces_at[i])
          {
            // The mean normal of two faces halves the angle between them.
            const double angle = 2 * std::acos(std::min(1., face_normal(f, points[k]) * mean / mean.norm())) *
                                 180 / numbers::PI;
            if (angle > sharpest_edge)
              {
                sharpest_edge = angle;
                sharpest_at   = nodes[i].X;
              }
          }
      }
  }

#define INSTANTIATE(dim)                                                                                     \
  template bool ContactSurface<dim>::move(const LA::Vector &);                                               \
  template void ContactSurface<dim>::find_deviation(SurfaceFace<dim> &) const;                               \
  template void ContactSurface<dim>::find_crossed_planes(const bool);                                        \
  template void ContactSurface<dim>::make_normals();                                                         \
  template void ContactSurface<dim>::find_sharpest_edge();                                                   \
  template std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>                                   \
  ContactSurface<dim>::normal_gradient(const unsigned int) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Amontons

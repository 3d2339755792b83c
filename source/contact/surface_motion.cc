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
          for (const auto &q : removed)
            m -= (m * q) * q;
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

    template <int dim>
    Tensor<1, dim>
    without(Tensor<1, dim> v, const std::vector<Tensor<1, dim>> &directions)
    {
      for (const auto &q : directions)
        v -= (v * q) * q;
      return v;
    }
  } // namespace

  template <int dim>
  bool
  ContactSurface<dim>::move(const LA::Vector &u)
  {
    bool changed = !moved || turned;
    moved        = true;
    turned       = false;
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
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        auto &face = faces[f];
        for (unsigned int k = 0; k < face.geometry.size(); ++k)
          {
            face.geometry[k] = Point<dim>(deviations[f][k]);
            for (unsigned int j = 0; j < face.nodes.size(); ++j)
              face.geometry[k] += values[k][j] * nodes[face.nodes[j]].x;
          }
        measure(face);
      }
    make_normals();
    return true;
  }

  // With the tangents T_k of the finite elements' face and normals N interpolated between its nodes, d =
  // sum_k rho_k T_k + beta N becomes sum_k rho_k t_k + beta n.
  template <int dim>
  void
  ContactSurface<dim>::turn(const LA::Vector &u)
  {
    std::vector<Point<dim>> X, x;
    for (const auto &node : nodes)
      {
        X.push_back(node.X);
        x.push_back(node.X);
        for (unsigned int c = 0; c < dim; ++c)
          x.back()[c] += u(node.dofs[c]);
      }
    if (x == (turned_to.empty() ? X : turned_to))
      return;
    turned                    = true;
    turned_to                 = x;
    const auto normals_before = element_normals(X), normals_after = element_normals(x);
    const auto points = lattice<dim - 1>(geometry_degree);
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int k = 0; k < points.size(); ++k)
        {
          const auto     N      = lagrange_values<dim - 1>(degree, points[k]);
          const auto     slopes = lagrange_gradients<dim - 1>(degree, points[k]);
          Tensor<1, dim> d      = reference_geometry[f][k];
          // columns: tangents, normal
          Tensor<2, dim> before, after;
          for (unsigned int j = 0; j < N.size(); ++j)
            {
              const unsigned int node = faces[f].nodes[j];
              d -= N[j] * X[node];
              for (unsigned int c = 0; c < dim; ++c)
                {
                  for (unsigned int e = 0; e < dim - 1; ++e)
                    {
                      before[c][e] += slopes[j][e] * X[node][c];
                      after[c][e] += slopes[j][e] * x[node][c];
                    }
                  before[c][dim - 1] += N[j] * normals_before[node][c];
                  after[c][dim - 1] += N[j] * normals_after[node][c];
                }
            }
          deviations[f][k] = after * (invert(before) * d);
        }
  }

  // Mean normals of the finite elements' faces at the nodes at x; 0 for nodes on no face.
  template <int dim>
  std::vector<Tensor<1, dim>>
  ContactSurface<dim>::element_normals(const std::vector<Point<dim>> &x) const
  {
    const auto                  points = lattice<dim - 1>(degree);
    std::vector<Tensor<1, dim>> normals(nodes.size());
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        for (const auto &[f, k] : faces_at[i])
          {
            const auto                          slopes = lagrange_gradients<dim - 1>(degree, points[k]);
            std::array<Tensor<1, dim>, dim - 1> tangents;
            for (unsigned int j = 0; j < slopes.size(); ++j)
              for (unsigned int e = 0; e < dim - 1; ++e)
                tangents[e] += slopes[j][e] * x[faces[f].nodes[j]];
            const Tensor<1, dim> c = faces[f].sign * area_vector(tangents);
            normals[i] += c / c.norm();
          }
        if (!faces_at[i].empty())
          {
            normals[i] = without(
                normals[i], directions_to_remove(nodes[i].symmetry_planes, normals[i] / normals[i].norm()));
            normals[i] /= normals[i].norm();
          }
      }
    return normals;
  }

  // Mean of the face normals at the node, weighted by nothing; then made to lie in the symmetry planes (and
  // on the axis of revolution) that the node belongs to.
  template <int dim>
  void
  ContactSurface<dim>::make_normals()
  {
    const auto points = lattice<dim - 1>(degree);
    for (unsigned int i = 0; i < nodes.size(); ++i)
      {
        nodes[i].normal = 0;
        for (const auto &[f, k] : faces_at[i])
          nodes[i].normal += face_normal(f, points[k]);
      }
    for (const auto &node : nodes)
      for (const auto &[parent, weight] : node.parents) // on no face
        if (nodes[parent].normal.norm() == 0)
          nodes[parent].normal += weight * node.normal;
    for (auto &node : nodes)
      {
        node.normal /= node.normal.norm();
        if (node.symmetry_planes.empty())
          continue;
        node.normal = without(node.normal, directions_to_remove(node.symmetry_planes, node.normal));
        node.normal /= node.normal.norm();
      }
  }

  // With the face normals n_f = c/|c|, c = area vector, the directions q that are removed and s = sum_f n_f:
  //   n = P s / |P s|,   P = 1 - sum q q^T,   dn = (1 - n n^T) P ds / |P s|,   dn_f = (1 - n_f n_f^T) dc/|c|,
  // and dc by dt_k = sum_j dN_j/dxi_k du_j.
  template <int dim>
  std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>
  ContactSurface<dim>::normal_gradient(const unsigned int node) const
  {
    const auto                                        points = lattice<dim - 1>(degree);
    Tensor<1, dim>                                    sum;
    std::map<types::global_dof_index, Tensor<1, dim>> gradient;
    for (const auto &[f, k] : faces_at[node])
      {
        const auto           tangents = frame(f, points[k]).tangents;
        const Tensor<1, dim> c        = faces[f].sign * area_vector(tangents);
        const double         length   = c.norm();
        const Tensor<1, dim> n        = c / length;
        sum += n;
        const auto slopes = lagrange_gradients<dim - 1>(degree, points[k]);
        for (unsigned int j = 0; j < slopes.size(); ++j)
          for (unsigned int d = 0; d < dim && slopes[j].norm() > 0; ++d)
            {
              Tensor<1, dim> dc;
              for (unsigned int e = 0; e < dim - 1; ++e)
                {
                  auto changed  = tangents;
                  changed[e]    = 0;
                  changed[e][d] = slopes[j][e];
                  dc += faces[f].sign * area_vector(changed);
                }
              gradient[nodes[faces[f].nodes[j]].dofs[d]] += (dc - (n * dc) * n) / length;
            }
      }
    const auto          &planes  = nodes[node].symmetry_planes;
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
        Tensor<1, dim> mean;
        for (const auto &[f, k] : faces_at[i])
          mean += face_normal(f, points[k]);
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
  template void ContactSurface<dim>::turn(const LA::Vector &);                                               \
  template void ContactSurface<dim>::make_normals();                                                         \
  template void ContactSurface<dim>::find_sharpest_edge();                                                   \
  template std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>                                   \
  ContactSurface<dim>::normal_gradient(const unsigned int) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Amontons

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
  void
  ContactSurface<dim>::move(const LA::Vector &u)
  {
    moved = true;
    std::vector<Tensor<1, dim>> displacements;
    for (auto &node : nodes)
      {
        displacements.emplace_back();
        for (unsigned int c = 0; c < dim; ++c)
          displacements.back()[c] = u(node.dofs[c]);
        node.x = node.X + displacements.back();
      }
    std::vector<std::vector<double>> values; // of the nodes' shape functions at the lattice points
    for (const auto &xi : lattice<dim - 1>(geometry_degree))
      values.push_back(lagrange_values<dim - 1>(degree, xi));
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        auto &face    = faces[f];
        face.geometry = reference_geometry[f];
        for (unsigned int k = 0; k < face.geometry.size(); ++k)
          for (unsigned int j = 0; j < face.nodes.size(); ++j)
            face.geometry[k] += values[k][j] * displacements[face.nodes[j]];
        measure(face);
      }
    make_normals();
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
  template void ContactSurface<dim>::move(const LA::Vector &);                                               \
  template void ContactSurface<dim>::make_normals();                                                         \
  template void ContactSurface<dim>::find_sharpest_edge();                                                   \
  template std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>                                   \
  ContactSurface<dim>::normal_gradient(const unsigned int) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Amontons

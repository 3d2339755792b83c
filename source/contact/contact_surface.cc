#include <amontons/base/gather.h>
#include <amontons/base/points.h>
#include <amontons/contact/contact_surface.h>
#include <amontons/discretization/mirror_faces.h>
#include <amontons/geometry/boundary_ids.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/face_lattice.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>

#include <set>

namespace Amontons
{
  namespace
  {
    // The degree + 1 Lagrange polynomials of equidistant nodes and their derivatives.
    template <unsigned int degree>
    struct Lagrange
    {
      explicit Lagrange(const double x) { lagrange_1d(degree, x, values, derivatives); }

      std::array<double, degree + 1> values, derivatives;
    };

    // Position and tangents of the face through points[stride_d i_d], i_d <= degree.
    template <unsigned int degree, int dim>
    typename ContactSurface<dim>::Frame
    interpolate(const std::vector<Point<dim>> &points, const Point<dim - 1> &xi)
    {
      constexpr unsigned int              g = ContactSurface<dim>::geometry_degree, step = g / degree;
      typename ContactSurface<dim>::Frame frame;
      const Lagrange<degree>              a(xi[0]);
      if constexpr (dim == 2)
        for (unsigned int i = 0; i <= degree; ++i)
          {
            const Point<dim> &p = points[step * i];
            frame.X += a.values[i] * p;
            frame.tangents[0] += a.derivatives[i] * p;
          }
      else
        {
          const Lagrange<degree> b(xi[1]);
          for (unsigned int j = 0; j <= degree; ++j)
            {
              Point<dim>     row;
              Tensor<1, dim> slope;
              for (unsigned int i = 0; i <= degree; ++i)
                {
                  const Point<dim> &p = points[step * (i + (g + 1) * j)];
                  row += a.values[i] * p;
                  slope += a.derivatives[i] * p;
                }
              frame.X += b.values[j] * row;
              frame.tangents[0] += b.values[j] * slope;
              frame.tangents[1] += b.derivatives[j] * row;
            }
        }
      return frame;
    }

    template <int dim>
    void
    append(std::vector<double> &list, const Point<dim> &p)
    {
      for (unsigned int d = 0; d < dim; ++d)
        list.push_back(p[d]);
    }

    template <int dim>
    Point<dim>
    take(const std::vector<double> &list, std::size_t &position)
    {
      Point<dim> p;
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = list[position++];
      return p;
    }

    // Sign of (cross product of the face tangents, in the order of the remaining coordinates) . outward
    // normal; in 2D the "cross product" of t is (t_y, -t_x).
    template <int dim>
    double
    orientation(const unsigned int f)
    {
      const double side = f % 2 == 1 ? 1 : -1;
      if (dim == 2)
        return f / 2 == 0 ? side : -side;
      return f / 2 == 1 ? -side : side;
    }
    // Of the faces of cells: nodes, then the lattice of their true geometry.
    template <int dim>
    class FacePlaces
    {
    public:
      explicit FacePlaces(const Discretization<dim> &discretization)
          : discretization(discretization), true_geometry(ContactSurface<dim>::geometry_degree)
      {
        for (unsigned int f = 0; f < 2 * dim; ++f)
          nodes_of[f] = nodes_on_face(discretization.fe.base_element(0), f);
      }

      const std::vector<unsigned int> &
      nodes(const unsigned int f) const
      {
        return nodes_of[f];
      }

      std::vector<Point<dim>>
      operator()(const typename DoFHandler<dim>::active_cell_iterator &cell, const unsigned int f)
      {
        if (points_of[f] == nullptr)
          points_of[f] = values_at_places(f);
        points_of[f]->reinit(typename Triangulation<dim>::cell_iterator(cell)); // without its element
        auto places = points_of[f]->get_quadrature_points();
        if (discretization.fe.degree == 1) // hanging vertices where the elements have them
          {
            const auto vertices = discretization.mapping().get_vertices(cell);
            for (unsigned int k = 0; k < nodes_of[f].size(); ++k)
              places[k] = vertices[nodes_of[f][k]];
          }
        return places;
      }

    private:
      std::unique_ptr<FEValues<dim>>
      values_at_places(const unsigned int f) const
      {
        std::vector<Point<dim>> points;
        for (const unsigned int i : nodes_of[f])
          points.push_back(discretization.fe.base_element(0).unit_support_point(i));
        for (const auto &xi : lattice<dim - 1>(ContactSurface<dim>::geometry_degree))
          points.push_back(on_unit_cell<dim>(f, xi));
        return std::make_unique<FEValues<dim>>(
            true_geometry, nothing, Quadrature<dim>(points), update_quadrature_points);
      }

      const Discretization<dim>                          &discretization;
      const MappingQ<dim>                                 true_geometry;
      const FE_Nothing<dim>                               nothing;
      std::array<std::vector<unsigned int>, 2 * dim>      nodes_of;
      std::array<std::unique_ptr<FEValues<dim>>, 2 * dim> points_of;
    };
  } // namespace

  template <int dim>
  OwnedFaces<dim>::OwnedFaces(const Discretization<dim> &discretization, const BoundaryName &name)
  {
    const auto  boundaries = boundary_ids(discretization.geometry, discretization.scene, name);
    const auto &fe         = discretization.fe;
    std::vector<types::global_dof_index> cell_dofs(fe.n_dofs_per_cell());
    FacePlaces<dim>                      places(discretization);

    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && boundaries.count(cell->face(f)->boundary_id()) > 0)
            {
              for (const auto &p : places(cell, f))
                append(numbers.positions, p);
              cell->get_dof_indices(cell_dofs);
              for (const unsigned int i : places.nodes(f))
                for (unsigned int c = 0; c < dim; ++c)
                  numbers.dofs.push_back(cell_dofs[fe.component_to_system_index(c, i)]);
              numbers.signs.push_back(orientation<dim>(f));
              cells.emplace_back(cell, f);
            }
  }

  template <int dim>
  ContactSurface<dim>::ContactSurface(const Discretization<dim> &discretization, const BoundaryName &name)
      : ContactSurface(discretization, name, OwnedFaces<dim>(discretization, name))
  {
  }

  template <int dim>
  ContactSurface<dim>::ContactSurface(const Discretization<dim> &discretization,
                                      const BoundaryName        &name,
                                      OwnedFaces<dim>            own)
      : body(discretization.geometry.boundary(name, discretization.scene).body),
        degree(discretization.fe.degree), owned(std::move(own.cells)),
        n_dofs(discretization.dof_handler.n_dofs())
  {
    collect_faces(gather_on_all(discretization.geometry.communicator, std::move(own.numbers)));
    find_parents(discretization);
    make_controls();
    find_symmetry_planes(discretization);
    find_crossed_planes(discretization.scene.kind == ProblemType::axisymmetric);
    make_normals();
    find_sharpest_edge();
    facets = find_facets<dim>(discretization.geometry.triangulation,
                              boundary_ids(discretization.geometry, discretization.scene, name),
                              planes_of_symmetry(discretization));
  }

  template <int dim>
  void
  ContactSurface<dim>::collect_faces(const std::vector<FaceNumbers> &parts)
  {
    const unsigned int                              n_nodes = Utilities::fixed_power<dim - 1>(degree + 1);
    std::map<types::global_dof_index, unsigned int> node_of_dof;

    const auto n_fine = Utilities::fixed_power<dim - 1>(geometry_degree + 1);
    for (unsigned int rank = 0; rank < parts.size(); ++rank)
      {
        const auto &part     = parts[rank];
        std::size_t position = 0, dof = 0;
        for (unsigned int i = 0; i < part.signs.size(); ++i)
          {
            SurfaceFace<dim> face;
            for (unsigned int k = 0; k < n_nodes; ++k)
              {
                SurfaceNode<dim> node;
                node.X = node.x = take<dim>(part.positions, position);
                for (unsigned int c = 0; c < dim; ++c)
                  node.dofs[c] = part.dofs[dof++];
                const auto found = node_of_dof.emplace(node.dofs[0], nodes.size());
                if (found.second)
                  nodes.push_back(node);
                face.nodes.push_back(found.first->second);
              }
            for (unsigned int k = 0; k < n_fine; ++k)
              face.geometry.push_back(take<dim>(part.positions, position));
            face.sign        = part.signs[i];
            face.rank        = rank;
            face.owned_index = i;
            measure(face);
            mean_size += face.size;
            reference_geometry.push_back(face.geometry);
            find_deviation(face);
            faces.push_back(std::move(face));
          }
      }
    mean_size /= std::max<std::size_t>(1, faces.size());
    faces_at.resize(nodes.size());
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int k = 0; k < n_nodes; ++k)
        faces_at[faces[f].nodes[k]].emplace_back(f, k);
  }

  template <int dim>
  void
  ContactSurface<dim>::measure(SurfaceFace<dim> &face) const
  {
    const auto fine = lattice<dim - 1>(geometry_degree);
    face.size       = face.geometry.front().distance(face.geometry.back());
    face.straight   = true;
    for (unsigned int k = 0; k < fine.size() && face.straight; ++k)
      face.straight = interpolate<1, dim>(face.geometry, fine[k]).X.distance(face.geometry[k]) <=
                      1e-14 * (face.size + face.geometry[k].norm());
    face.centre = face.geometry[face.geometry.size() / 2];
  }

  namespace
  {
    // The component that a condition keeps at zero, if it is one only.
    std::optional<unsigned int>
    held_component(const ConditionData &condition, const unsigned int dim)
    {
      std::optional<unsigned int> result;
      for (unsigned int c = 0; c < dim; ++c)
        if (const auto &u = condition.displacement[c])
          {
            if (result || !u->is_zero())
              return {};
            result = c;
          }
      return result;
    }

    // By boundary: of symmetry (no component), or held along an axis.
    template <int dim>
    std::map<types::boundary_id, std::optional<unsigned int>>
    plane_boundaries(const Discretization<dim> &discretization)
    {
      std::map<types::boundary_id, std::optional<unsigned int>> result;
      for (const auto &condition : discretization.scene.conditions)
        for (const auto &name : condition.boundaries)
          {
            const auto id = discretization.geometry.boundary(name, discretization.scene).id;
            if (condition.type == ConditionData::Type::symmetry)
              result[id].reset();
            else if (const auto c = held_component(condition, dim);
                     c && condition.type == ConditionData::Type::displacement)
              result.emplace(id, c);
          }
      return result;
    }

    template <int dim>
    void
    add_direction(const Tensor<1, dim> &normal, std::vector<Tensor<1, dim>> &known)
    {
      if (std::none_of(
              known.begin(), known.end(), [&](const auto &m) { return std::abs(m * normal) > 1 - 1e-6; }))
        known.push_back(normal);
    }
  } // namespace

  template <int dim>
  void
  ContactSurface<dim>::find_symmetry_planes(const Discretization<dim> &discretization)
  {
    const auto planes       = plane_boundaries(discretization);
    const bool axisymmetric = discretization.scene.kind == ProblemType::axisymmetric;
    if (planes.empty() && !axisymmetric)
      return;

    using Normals = std::vector<Tensor<1, dim>>;
    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      node_of_dof[nodes[i].dofs[0]] = i;
    const auto                                         &fe   = discretization.fe;
    const auto                                         &base = fe.base_element(0);
    std::vector<types::global_dof_index>                dofs(fe.n_dofs_per_cell());
    std::map<unsigned int, std::pair<Normals, Normals>> found; // by node: planes, walls
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          if (!cell->is_locally_owned() || !cell->face(f)->at_boundary())
            continue;
          const auto known = planes.find(cell->face(f)->boundary_id());
          const bool at_axis =
              axisymmetric && std::abs(cell->face(f)->center()[0]) < 1e-10 * cell->diameter();
          if (known == planes.end() && !at_axis)
            continue;
          std::array<Tensor<1, dim>, dim - 1> t;
          for (unsigned int k = 0; k < dim - 1; ++k)
            t[k] = cell->face(f)->vertex(1 << k) - cell->face(f)->vertex(0);
          const Tensor<1, dim> area = area_vector(t), normal = area / area.norm();
          const bool           is_wall = !at_axis && known->second;
          if (is_wall && std::abs(normal[*known->second]) < 1 - 1e-6)
            continue;
          cell->get_dof_indices(dofs);
          for (const unsigned int i : nodes_on_face(base, f))
            if (const auto node = node_of_dof.find(dofs[fe.component_to_system_index(0, i)]);
                node != node_of_dof.end())
              (is_wall ? found[node->second].second : found[node->second].first).push_back(normal);
        }
    for (const auto &part : gather_on_all(discretization.geometry.communicator, found))
      for (const auto &[i, normals] : part)
        {
          nodes[i].is_on_plane = true;
          for (const auto &normal : normals.first)
            add_direction(normal, nodes[i].symmetry_planes);
          for (const auto &normal : normals.second)
            add_direction(normal, nodes[i].walls);
        }
  }

  template <int dim>
  typename ContactSurface<dim>::Frame
  ContactSurface<dim>::frame(const unsigned int face, const Point<dim - 1> &xi) const
  {
    return faces[face].straight ? interpolate<1, dim>(faces[face].geometry, xi)
                                : interpolate<geometry_degree, dim>(faces[face].geometry, xi);
  }

  // d = sum_k a_k t_k + b n:  dd/dx_j = sum_k a_k dN_j/dxi_k 1 + b dn/dx_j (all of the frame at the centre);
  // slopes with da_k/dxi_l and db/dxi_l instead.
  template <int dim>
  std::vector<typename ContactSurface<dim>::DeviationGradient>
  ContactSurface<dim>::deviation_gradient(const unsigned int f, const Point<dim - 1> &xi) const
  {
    const auto                    &face   = faces[f];
    const auto                     slopes = lagrange_gradients<dim - 1>(degree, face_centre<dim - 1>());
    const Frame                    at     = interpolate<geometry_degree, dim>(face.deviation, xi);
    std::vector<DeviationGradient> result(slopes.size());
    for (unsigned int j = 0; j < slopes.size(); ++j)
      {
        const auto by = [&](const Tensor<1, dim> &coefficients) {
          double along = 0;
          for (unsigned int k = 0; k < dim - 1; ++k)
            along += coefficients[k] * slopes[j][k];
          return along * Tensor<2, dim>(unit_symmetric_tensor<dim>()) +
                 coefficients[dim - 1] * face.centre_normal_gradient[j];
        };
        result[j].value = by(at.X);
        for (unsigned int k = 0; k < dim - 1; ++k)
          result[j].slopes[k] = by(at.tangents[k]);
      }
    return result;
  }

  template <int dim>
  Point<dim>
  ContactSurface<dim>::reference_position(const unsigned int face, const Point<dim - 1> &xi) const
  {
    return interpolate<geometry_degree, dim>(reference_geometry[face], xi).X;
  }

  template <int dim>
  Point<dim>
  ContactSurface<dim>::position(const unsigned int face, const Point<dim - 1> &xi) const
  {
    return frame(face, xi).X;
  }

  template <int dim>
  Tensor<1, dim>
  ContactSurface<dim>::face_normal(const unsigned int face, const Point<dim - 1> &xi, double *jacobian) const
  {
    const Tensor<1, dim> n    = area_vector(frame(face, xi).tangents);
    const double         area = n.norm();
    if (jacobian != nullptr)
      *jacobian = area;
    return faces[face].sign / area * n;
  }

  template <int dim>
  Tensor<1, dim>
  ContactSurface<dim>::nodal_normal(const unsigned int                   face,
                                    const Point<dim - 1>                &xi,
                                    std::array<Tensor<1, dim>, dim - 1> *derivatives) const
  {
    std::array<std::array<double, 3>, dim - 1> values, slopes;
    const auto                                 fill = [&](const auto &polynomials, const unsigned int d) {
      std::copy(polynomials.values.begin(), polynomials.values.end(), values[d].begin());
      std::copy(polynomials.derivatives.begin(), polynomials.derivatives.end(), slopes[d].begin());
    };
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (degree == 1)
        fill(Lagrange<1>(xi[d]), d);
      else
        fill(Lagrange<2>(xi[d]), d);
    const auto                         &face_nodes = faces[face].nodes;
    const unsigned int                  n_1d       = degree + 1;
    Tensor<1, dim>                      n;
    std::array<Tensor<1, dim>, dim - 1> dn;
    for (unsigned int k = 0; k < face_nodes.size(); ++k)
      {
        const Tensor<1, dim> &normal = nodes[face_nodes[k]].normal;
        double                value  = 1;
        for (unsigned int d = 0, rest = k; d < dim - 1; ++d, rest /= n_1d)
          value *= values[d][rest % n_1d];
        n += value * normal;
        for (unsigned int e = 0; derivatives != nullptr && e < dim - 1; ++e)
          {
            double slope = 1;
            for (unsigned int d = 0, rest = k; d < dim - 1; ++d, rest /= n_1d)
              slope *= (d == e ? slopes : values)[d][rest % n_1d];
            dn[e] += slope * normal;
          }
      }
    const double length = n.norm();
    n /= length;
    for (unsigned int e = 0; derivatives != nullptr && e < dim - 1; ++e)
      (*derivatives)[e] = (dn[e] - (dn[e] * n) * n) / length;
    return n;
  }

  template <int dim>
  IndexSet
  ContactSurface<dim>::dofs() const
  {
    std::vector<types::global_dof_index> list;
    for (const auto &node : nodes)
      list.insert(list.end(), node.dofs.begin(), node.dofs.end());
    std::sort(list.begin(), list.end());
    IndexSet set(n_dofs);
    set.add_indices(list.begin(), list.end());
    return set;
  }

  template struct OwnedFaces<2>;
  template struct OwnedFaces<3>;
  template class ContactSurface<2>;
  template class ContactSurface<3>;
} // namespace Amontons

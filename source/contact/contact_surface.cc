#include <amontons/base/points.h>
#include <amontons/contact/contact_surface.h>
#include <amontons/contact/face_basis.h>

#include <deal.II/base/mpi.templates.h>

namespace Amontons
{
  namespace
  {
    // What a rank tells the others about its faces: all numbers of all faces, one after another.
    struct FacePackage
    {
      std::vector<types::global_dof_index> dofs;
      std::vector<double>                  positions; // nodes, then the lattice
      std::vector<double>                  signs;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &dofs &positions &signs;
      }
    };

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

    template <int fdim>
    std::vector<Point<fdim>>
    lattice(const unsigned int degree)
    {
      std::vector<Point<fdim>> points;
      const unsigned int       n = degree + 1;
      for (unsigned int i = 0; i < Utilities::fixed_power<fdim>(n); ++i)
        {
          Point<fdim>  p;
          unsigned int rest = i;
          for (unsigned int d = 0; d < fdim; ++d, rest /= n)
            p[d] = double(rest % n) / degree;
          points.push_back(p);
        }
      return points;
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

    Tensor<1, 2>
    cross(const std::array<Tensor<1, 2>, 1> &t)
    {
      return Tensor<1, 2>({t[0][1], -t[0][0]});
    }

    Tensor<1, 3>
    cross(const std::array<Tensor<1, 3>, 2> &t)
    {
      return cross_product_3d(t[0], t[1]);
    }
  } // namespace

  template <int dim>
  ContactSurface<dim>::ContactSurface(const Discretization<dim> &discretization, const BoundaryName &name)
      : body(discretization.geometry.boundary(name, discretization.scene).body),
        degree(discretization.fe.degree), n_dofs(discretization.dof_handler.n_dofs())
  {
    collect_faces(discretization, name);
    make_normals(discretization);
  }

  template <int dim>
  void
  ContactSurface<dim>::collect_faces(const Discretization<dim> &discretization, const BoundaryName &name)
  {
    std::set<types::boundary_id> boundaries = {
        discretization.geometry.boundary(name, discretization.scene).id};
    for (const auto &further : name.more)
      boundaries.insert(
          discretization.geometry.boundary({name.body, further, name.where}, discretization.scene).id);
    const auto                          &fe   = discretization.fe;
    const auto                          &base = fe.base_element(0);
    const MappingQ<dim>                  true_geometry(geometry_degree);
    const auto                           fine = lattice<dim - 1>(geometry_degree);
    std::vector<types::global_dof_index> cell_dofs(fe.n_dofs_per_cell());

    FacePackage package;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && boundaries.count(cell->face(f)->boundary_id()) > 0)
            {
              cell->get_dof_indices(cell_dofs);
              for (const unsigned int i : nodes_on_face(base, f))
                {
                  append(package.positions,
                         true_geometry.transform_unit_to_real_cell(cell, base.unit_support_point(i)));
                  for (unsigned int c = 0; c < dim; ++c)
                    package.dofs.push_back(cell_dofs[fe.component_to_system_index(c, i)]);
                }
              for (const auto &xi : fine)
                append(package.positions,
                       true_geometry.transform_unit_to_real_cell(cell, on_unit_cell<dim>(f, xi)));
              package.signs.push_back(orientation<dim>(f));
              owned.emplace_back(cell, f);
            }

    Point<dim - 1> middle;
    for (unsigned int d = 0; d < dim - 1; ++d)
      middle[d] = 0.5;
    const unsigned int                              n_nodes = Utilities::fixed_power<dim - 1>(degree + 1);
    const auto                                      T       = control_matrix(degree, dim - 1);
    std::map<types::global_dof_index, unsigned int> node_of_dof;

    const auto packages = Utilities::MPI::all_gather(discretization.geometry.communicator, package);
    for (unsigned int rank = 0; rank < packages.size(); ++rank)
      {
        const auto &part     = packages[rank];
        std::size_t position = 0, dof = 0;
        for (unsigned int i = 0; i < part.signs.size(); ++i)
          {
            SurfaceFace<dim> face;
            for (unsigned int k = 0; k < n_nodes; ++k)
              {
                SurfaceNode<dim> node;
                node.X = take<dim>(part.positions, position);
                for (unsigned int c = 0; c < dim; ++c)
                  node.dofs[c] = part.dofs[dof++];
                const auto found = node_of_dof.emplace(node.dofs[0], nodes.size());
                if (found.second)
                  nodes.push_back(node);
                face.nodes.push_back(found.first->second);
              }
            for (unsigned int k = 0; k < fine.size(); ++k)
              face.geometry.push_back(take<dim>(part.positions, position));
            for (unsigned int k = 0; k < n_nodes; ++k)
              if (nodes[face.nodes[k]].control.empty())
                for (unsigned int l = 0; l < n_nodes; ++l)
                  if (T[k][l] != 0)
                    nodes[face.nodes[k]].control.emplace_back(face.nodes[l], T[k][l]);
            face.sign        = part.signs[i];
            face.rank        = rank;
            face.owned_index = i;
            face.size        = face.geometry.front().distance(face.geometry.back());
            faces.push_back(face);
            faces.back().centre = this->position(faces.size() - 1, middle);
            mean_size += face.size;
          }
      }
    mean_size /= std::max<std::size_t>(1, faces.size());
  }

  // Mean of the face normals at the node, weighted by nothing (2D: two faces); then made to lie in the
  // symmetry planes (and on the axis of revolution) that the node belongs to.
  template <int dim>
  void
  ContactSurface<dim>::make_normals(const Discretization<dim> &discretization)
  {
    const auto points = lattice<dim - 1>(degree);
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int k = 0; k < faces[f].nodes.size(); ++k)
        nodes[faces[f].nodes[k]].normal += face_normal(f, points[k]);
    for (auto &node : nodes)
      node.normal /= node.normal.norm();

    std::set<types::boundary_id> planes;
    for (const auto &condition : discretization.scene.conditions)
      if (condition.type == ConditionData::Type::symmetry)
        for (const auto &name : condition.boundaries)
          planes.insert(discretization.geometry.boundary(name, discretization.scene).id);
    const bool axisymmetric = discretization.scene.kind == Kind::axisymmetric;
    if (planes.empty() && !axisymmetric)
      return;

    std::map<types::global_dof_index, unsigned int> node_of_dof;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      node_of_dof[nodes[i].dofs[0]] = i;
    const auto                                         &fe   = discretization.fe;
    const auto                                         &base = fe.base_element(0);
    std::vector<types::global_dof_index>                dofs(fe.n_dofs_per_cell());
    std::map<unsigned int, std::vector<Tensor<1, dim>>> plane_normals;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              (planes.count(cell->face(f)->boundary_id()) > 0 ||
               (axisymmetric && std::abs(cell->face(f)->center()[0]) < 1e-10 * cell->diameter())))
            {
              std::array<Tensor<1, dim>, dim - 1> t;
              for (unsigned int k = 0; k < dim - 1; ++k)
                t[k] = cell->face(f)->vertex(1 << k) - cell->face(f)->vertex(0);
              const Tensor<1, dim> normal = cross(t);
              cell->get_dof_indices(dofs);
              for (const unsigned int i : nodes_on_face(base, f))
                if (const auto node = node_of_dof.find(dofs[fe.component_to_system_index(0, i)]);
                    node != node_of_dof.end())
                  plane_normals[node->second].push_back(normal / normal.norm());
            }
    for (const auto &part : Utilities::MPI::all_gather(discretization.geometry.communicator, plane_normals))
      for (const auto &[i, normals] : part)
        for (const auto &normal : normals)
          {
            auto &known = nodes[i].symmetry_planes;
            if (std::none_of(known.begin(), known.end(), [&](const auto &m) {
                  return std::abs(m * normal) > 1 - 1e-6;
                }))
              known.push_back(normal);
            Tensor<1, dim> &n         = nodes[i].normal;
            const auto      projected = n - (n * normal) * normal;
            if (projected.norm() > 1e-6)
              n = projected / projected.norm();
          }
  }

  template <int dim>
  Point<dim>
  ContactSurface<dim>::position(const unsigned int face, const Point<dim - 1> &xi) const
  {
    const auto values = lagrange_values<dim - 1>(geometry_degree, xi);
    Point<dim> p;
    for (unsigned int i = 0; i < values.size(); ++i)
      p += values[i] * faces[face].geometry[i];
    return p;
  }

  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  ContactSurface<dim>::tangents(const unsigned int face, const Point<dim - 1> &xi) const
  {
    const auto                          gradients = lagrange_gradients<dim - 1>(geometry_degree, xi);
    std::array<Tensor<1, dim>, dim - 1> t;
    for (unsigned int i = 0; i < gradients.size(); ++i)
      for (unsigned int k = 0; k < dim - 1; ++k)
        t[k] += gradients[i][k] * faces[face].geometry[i];
    return t;
  }

  template <int dim>
  Tensor<1, dim>
  ContactSurface<dim>::face_normal(const unsigned int face, const Point<dim - 1> &xi, double *jacobian) const
  {
    const Tensor<1, dim> n    = cross(tangents(face, xi));
    const double         area = n.norm();
    if (jacobian != nullptr)
      *jacobian = area;
    return faces[face].sign / area * n;
  }

  template <int dim>
  Tensor<1, dim>
  ContactSurface<dim>::nodal_normal(const unsigned int face, const Point<dim - 1> &xi) const
  {
    const auto     values = lagrange_values<dim - 1>(degree, xi);
    Tensor<1, dim> n;
    for (unsigned int i = 0; i < values.size(); ++i)
      n += values[i] * nodes[faces[face].nodes[i]].normal;
    return n / n.norm();
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

  template class ContactSurface<2>;
  template class ContactSurface<3>;
} // namespace Amontons

#include <amontons/discretization/discretization.h>

#include <deal.II/base/mpi.templates.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1_eulerian.h>

namespace Amontons
{
  template <int dim>
  Discretization<dim>::Discretization(const Scene         &scene,
                                      const Geometry<dim> &geometry,
                                      const unsigned int   degree)
      : scene(scene), geometry(geometry), finite_strain(scene.kinematics == Kinematics::finite_strain),
        fe(FE_Q<dim>(degree), dim), load_mapping(std::max(2u, degree)), dof_handler(geometry.triangulation)
  {
    for (const auto &body : scene.bodies)
      carrier_of_body.push_back(body.rigid ? geometry.carrier(body.rigid->name)
                                           : numbers::invalid_unsigned_int);
  }

  template <int dim>
  bool
  Discretization<dim>::is_deformable(const types::material_id id) const
  {
    return id < carrier_of_body.size() && carrier_of_body[id] == numbers::invalid_unsigned_int;
  }

  template <int dim>
  void
  Discretization<dim>::distribute_dofs()
  {
    dof_handler.distribute_dofs(fe);
    locally_owned = dof_handler.locally_owned_dofs();
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    hanging_nodes.reinit(relevant);
    DoFTools::make_hanging_node_constraints(dof_handler, hanging_nodes);
    hanging_nodes.close();
    place_hanging_vertices();
    find_carrier_dofs();
    find_free_turns();
    find_free_slides();
  }

  // A vertex of a round body that hangs lies on its surface, and its displacement is the mean of its
  // parents': with facets the rotation x -> R x would not be among the displacements, whose moments are then
  // in no balance and which no rigid motion leaves without strain. So elements take it for the mean of its
  // parents, as they do everywhere on straight edges.
  template <int dim>
  void
  Discretization<dim>::place_hanging_vertices()
  {
    elements = std::make_unique<MappingQ<dim>>(fe.degree);
    if (fe.degree > 1)
      return; // their edges have a node there
    LA::Vector place(locally_owned, geometry.communicator);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int c = 0; c < dim; ++c)
            if (const auto i = cell->vertex_dof_index(v, c); locally_owned.is_element(i))
              place(i) = cell->vertex(v)[c];
    place.compress(VectorOperation::insert);
    LA::Vector mean = place;
    hanging_nodes.distribute(mean);
    mean -= place;
    if (mean.linfty_norm() <= 1e-14 * place.linfty_norm())
      return;
    to_parents.reinit(locally_owned, relevant, geometry.communicator);
    to_parents = mean;
    elements   = std::make_unique<MappingQ1Eulerian<dim, LA::Vector>>(dof_handler, to_parents);
  }

  template <int dim>
  void
  Discretization<dim>::add_relevant(const IndexSet &dofs)
  {
    relevant.add_indices(dofs);
    relevant.compress();
  }

  template <int dim>
  void
  Discretization<dim>::find_carrier_dofs()
  {
    const unsigned int                                           n_bodies = scene.bodies.size();
    std::map<unsigned int, std::vector<types::global_dof_index>> mine;
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && geometry.is_carrier(cell->material_id()))
        {
          auto &dofs = mine[cell->material_id() - n_bodies];
          for (unsigned int k = 0; k <= dim; ++k) // corner A is vertex 0, B is 1, C is 2, D is 4
            for (unsigned int c = 0; c < dim; ++c)
              dofs.push_back(cell->vertex_dof_index(k == 0 ? 0 : (1 << (k - 1)), c));
        }
    carrier_dofs.resize(geometry.carriers.size());
    IndexSet indices(dof_handler.n_dofs());
    for (const auto &part : Utilities::MPI::all_gather(geometry.communicator, mine))
      for (const auto &[m, dofs] : part)
        for (unsigned int k = 0; k <= dim; ++k)
          for (unsigned int c = 0; c < dim; ++c)
            {
              carrier_dofs[m][k][c] = dofs[k * dim + c];
              indices.add_index(dofs[k * dim + c]);
            }
    add_relevant(indices);
  }

  template <int dim>
  std::array<double, dim + 1>
  Discretization<dim>::carrier_weights(const unsigned int m, const Point<dim> &X) const
  {
    const CarrierCell          &carrier = geometry.carriers[m];
    std::array<double, dim + 1> weights;
    weights[0] = 1;
    for (unsigned int k = 0; k < dim; ++k)
      {
        weights[k + 1] = (X[k] - carrier.motion.reference[k]) / carrier.size;
        weights[0] -= weights[k + 1];
      }
    return weights;
  }

  template <int dim>
  LA::Vector
  Discretization<dim>::make_owned_vector() const
  {
    LA::Vector vector;
    vector.reinit(locally_owned, relevant, geometry.communicator, true);
    return vector;
  }

  template <int dim>
  LA::Vector
  Discretization<dim>::make_relevant_vector() const
  {
    return LA::Vector(locally_owned, relevant, geometry.communicator);
  }

  template <int dim>
  std::vector<unsigned int>
  nodes_on_face(const FiniteElement<dim> &base_element, const unsigned int f)
  {
    const unsigned int direction = f / 2;
    const double       position  = f % 2;
    const auto        &points    = base_element.get_unit_support_points();

    std::vector<unsigned int> nodes;
    for (unsigned int i = 0; i < points.size(); ++i)
      if (std::abs(points[i][direction] - position) < 1e-12)
        nodes.push_back(i);
    std::sort(nodes.begin(), nodes.end(), [&](const unsigned int a, const unsigned int b) {
      for (int d = dim - 1; d >= 0; --d)
        if (std::abs(points[a][d] - points[b][d]) > 1e-12)
          return points[a][d] < points[b][d];
      return false;
    });
    return nodes;
  }

  template class Discretization<2>;
  template class Discretization<3>;
  template std::vector<unsigned int>
  nodes_on_face(const FiniteElement<2> &, const unsigned int);
  template std::vector<unsigned int>
  nodes_on_face(const FiniteElement<3> &, const unsigned int);
} // namespace Amontons

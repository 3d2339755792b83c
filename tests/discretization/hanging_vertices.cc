// Where linear elements of round bodies have their hanging vertices: linear functions of the place are among
// the displacements, also on the surfaces that touch, on meshes that were refined at random.
#include "check.h"

#include <amontons/contact/contact_surface.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <random>

namespace test_hanging_vertices
{
using namespace Amontons;

// y - 2x + 3 of the place, or what hanging nodes make of that: by how much they differ.
template <int dim>
double
change_of_a_linear_function(const Discretization<dim> &discretization, const Mapping<dim> &mapping)
{
  std::map<types::global_dof_index, Point<dim>> places;
  DoFTools::map_dofs_to_support_points(mapping, discretization.dof_handler, places);
  LA::Vector values = discretization.make_owned_vector();
  for (const auto &[dof, X] : places)
    values(dof) = X[1] - 2 * X[0] + 3;
  values.compress(VectorOperation::insert);
  LA::Vector hanging = values;
  discretization.hanging_nodes.distribute(hanging);
  hanging -= values;
  return hanging.linfty_norm();
}

template <int dim>
void
check_body(const std::string &shape, const std::string &boundary)
{
  Scene scene;
  scene.kind = dim == 2 ? ProblemType::plane_strain : ProblemType::three_dimensional;
  BodyData body;
  body.name   = "it";
  body.shape  = shape;
  body.radius = 2;
  body.length = 2;
  scene.bodies.push_back(body);
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random;
  for (unsigned int refinement = 0; refinement < 3; ++refinement)
    {
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (random(generator) < 0.2)
          cell->set_refine_flag();
      geometry.triangulation.execute_coarsening_and_refinement();
    }
  for (const unsigned int degree : {1, 2})
    {
      const auto          what = shape + ", degree " + std::to_string(degree);
      Discretization<dim> discretization(scene, geometry, degree);
      discretization.distribute_dofs();
      check::is_true(change_of_a_linear_function(discretization, MappingQ<dim>(1)) > 1e-2,
                     what + ": round faces have hanging nodes");
      if (degree == 1)
        check::is_close(
            change_of_a_linear_function(discretization, discretization.mapping()), 0, 1e-14, what, 1);
      const ContactSurface<dim> surface(discretization, {"it", boundary, {}});
      for (const auto &node : surface.nodes)
        {
          Tensor<1, dim> mean;
          for (const auto &[parent, weight] : node.parents)
            mean += weight * surface.nodes[parent].X;
          if (!node.parents.empty() && degree == 1)
            check::is_close((node.X - mean).norm(), 0, 1e-14, what + ": nodes of a surface", 1);
        }
      for (const auto &face : surface.faces)
        for (const auto &X : face.geometry)
          check::is_close(std::hypot(X[0], X[1]), 2, 2e-4, what + ": the surface itself is round");
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_body<2>("ring", "outer");
  check_body<3>("cylinder", "surface");
  return check::result();
}
} // namespace test_hanging_vertices

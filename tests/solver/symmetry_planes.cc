// A body that moves through its own plane of symmetry is found, with the place; one that stays before it, or
// that the mesh has on both sides of it, is none.
#include "check.h"

#include <amontons/solver/symmetry_planes.h>

#include <deal.II/base/mpi.h>

namespace test_symmetry_planes
{
using namespace Amontons;

// Places beyond the plane of the left side if points X move by u(X).
template <int dim>
std::vector<Point<dim>>
beyond(const Scene &scene, const std::function<double(const Point<dim> &)> &u_x)
{
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  Discretization<dim> discretization(scene, geometry, 2);
  discretization.distribute_dofs();
  LA::Vector u = discretization.make_owned_vector(), readable = discretization.make_relevant_vector();
  for (const auto &cell : discretization.dof_handler.active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      if (const auto dof = cell->vertex_dof_index(v, 0); discretization.locally_owned.is_element(dof))
        u(dof) = u_x(cell->vertex(v));
  u.compress(VectorOperation::insert);
  readable = u;
  return beyond_symmetry_planes(discretization, readable);
}

template <int dim>
void
check_block()
{
  Scene scene;
  scene.kind = dim == 2 ? ProblemType::plane_strain : ProblemType::three_dimensional;
  BodyData body;
  body.name   = "it";
  body.lower  = {1, 0, 0};
  body.upper  = {3, 2, 1};
  body.cells  = {{2, 2, 1}};
  auto beside = body;
  beside.name = "beside";
  beside.lower[0] -= 2; // on the other side of the plane from the beginning
  beside.upper[0] -= 2;
  scene.bodies = {body, beside};
  ConditionData symmetry;
  symmetry.type       = ConditionData::Type::symmetry;
  symmetry.boundaries = {{"it", "left", {}}};
  scene.conditions    = {symmetry};

  const std::string name = std::to_string(dim) + "D: ";
  check::is_true(beyond<dim>(scene, [](const auto &) { return 0.; }).empty(), name + "at rest");
  check::is_true(beyond<dim>(scene, [](const auto &X) { return X[0] > 2.5 ? -1.9 : 0.; }).empty(),
                 name + "the far side comes near to the plane");
  // The section in which a bolt is tightened: it is taken beyond the plane, and its image likewise.
  auto          with_bolt = scene;
  ConditionData section;
  section.type       = ConditionData::Type::displacement;
  section.boundaries = {{"it", "left", {}}};
  with_bolt.conditions.push_back(section);
  check::is_true(beyond<dim>(with_bolt, [](const auto &X) { return X[0] < 1.01 ? -0.5 : 0.; }).empty(),
                 name + "a section that is driven beyond the plane");
  check::is_true(beyond<dim>(with_bolt, [](const auto &X) { return X[0] > 2.5 ? -2.5 : 0.; }).size() == 1,
                 name + "the far side beyond the plane, of such a body, too");
  const auto turned = beyond<dim>(scene, [](const auto &X) { return X[0] > 2.5 && X[1] > 1.5 ? -2.5 : 0.; });
  check::is_true(turned.size() == 1, name + "a corner beyond the plane");
  if (!turned.empty())
    {
      check::is_close(turned[0][0], 3, 1e-12, name + "x of the corner");
      check::is_close(turned[0][1], 2, 1e-12, name + "y of the corner");
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_block<2>();
  check_block<3>();
  return check::result();
}
} // namespace test_symmetry_planes

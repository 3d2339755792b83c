// With twice the exact displacement all errors of the field are 1, up to what the mesh cannot show.
#include "contact/contact_scene.h"

#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/scene/scene_reader.h>
#include <amontons/verification/comparison.h>
#include <amontons/verification/reference_solution.h>

namespace test_comparison
{
int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  RefinementParameters                   refinement;
  const Scene                            scene =
      read_scene(std::string(std::getenv("AMONTONS_SOURCE_DIR")) + "/parameters/half_plane_box.prm",
                 {},
                 {&refinement},
                 {make_displacement_field, displacement_field_corners});
  Problem<2> problem(scene, 2);
  for (unsigned int i = 0; i < 2; ++i)
    {
      problem.geometry.triangulation.refine_global(1);
      problem.discretization->distribute_dofs();
    }
  problem.interfaces = make_interfaces(*problem.discretization, choose_slaves(*problem.discretization));
  for (const auto *surface : {problem.interfaces[0].slave.get(), problem.interfaces[0].master_surface.get()})
    problem.discretization->add_relevant(surface->dofs());
  const auto supports = problem.discretization->make_supports(0);
  integrate_couplings(*problem.discretization, supports, problem.interfaces);
  const auto reference = make_reference_solution(scene.reference->solution, scene);

  auto                                 u  = problem.discretization->make_owned_vector();
  const auto                          &fe = problem.discretization->fe;
  std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
  FEValues<2>                          values(problem.discretization->mapping(),
                     fe,
                     Quadrature<2>(fe.base_element(0).get_unit_support_points()),
                     update_quadrature_points);
  for (const auto &cell : problem.discretization->dof_handler.active_cell_iterators())
    if (problem.discretization->is_deformable(cell->material_id()))
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const auto [c, node] = fe.system_to_component_index(i);
            u(dofs[i])           = 2 * reference.displacement(scene.bodies[cell->material_id()].name,
                                                    as_3d(values.quadrature_point(node)))[c];
          }
      }
  u.compress(VectorOperation::insert);
  SolutionState<2> state;
  state.displacement = problem.discretization->make_relevant_vector();
  state.displacement = u;
  ElasticityOperator<2> elasticity(*problem.discretization);
  elasticity.assemble(state.displacement);
  const auto                          fields = make_surface_fields(*problem.discretization,
                                          problem.interfaces[0],
                                          NodalContacts<2>(problem.slave().nodes.size()),
                                          std::vector<double>(problem.coupling().rows.size(), 0.),
                                          state.displacement);
  const auto                          loads  = problem.discretization->make_owned_vector();
  const std::vector<SurfaceFields<2>> all    = {fields};
  const Answer<2>                     answer{
      *problem.discretization, elasticity, problem.interfaces, all, supports, loads, state};
  const auto summary = make_reference<2>(scene)->compare(answer);
  for (const char *const name : {"displacement_l2", "displacement_h1", "energy"})
    check::is_close(summary.errors.at(name), 1, 0.05, std::string("twice the displacement: ") + name);
  return check::result();
}
} // namespace test_comparison

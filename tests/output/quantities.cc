// The checks of the physics measure what they say on states that violate it.
#include "contact/contact_scene.h"

#include <amontons/contact/surface_fields.h>
#include <amontons/output/nodal_forces.h>
#include <amontons/output/physics_checks.h>

namespace test_quantities
{
// Two unit blocks of two columns each, one on the other; the lower one is held at its bottom. Nothing moves.
struct TwoBlocks
{
  TwoBlocks() : problem(scene(), 1)
  {
    elasticity = std::make_unique<ElasticityOperator<2>>(*problem.discretization);
    for (const auto *surface :
         {problem.interfaces[0].slave.get(), problem.interfaces[0].master_surface.get()})
      problem.discretization->add_relevant(surface->dofs());
    supports           = problem.discretization->make_supports(0);
    state.displacement = problem.discretization->make_relevant_vector();
    loads              = problem.discretization->make_owned_vector();
    elasticity->assemble(state.displacement);
    state.contact = {NodalContacts<2>(problem.slave().nodes.size())};
  }

  static Scene
  scene()
  {
    Scene scene;
    scene.bodies            = {block("lower", {0, 0, 0}, {1, 1, 0}, {{2, 1, 1}}),
                               block("upper", {0, 1, 0}, {1, 2, 0}, {{2, 1, 1}})};
    scene.pairs             = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
    scene.pairs[0].friction = Expression(0.5);
    ConditionData held;
    held.boundaries   = {{"lower", "bottom", {}}};
    held.displacement = {{Expression(0.), Expression(0.), {}}};
    scene.conditions  = {held};
    return scene;
  }

  void
  set(const double        x,
      const ContactStatus s,
      const double        p,
      const double        g,
      const Tensor<1, 2> &q,
      const Tensor<1, 2> &v)
  {
    for (unsigned int n = 0; n < problem.slave().nodes.size(); ++n)
      if (std::abs(problem.slave().nodes[n].X[0] - x) < 1e-10)
        state.contact[0][n] = {true, s, p, g, q, v, Tensor<1, 2>()};
  }

  Answer<2>
  answer() const
  {
    return {*problem.discretization, *elasticity, problem.interfaces, fields, supports, loads, state};
  }

  Problem<2>                             problem;
  std::unique_ptr<ElasticityOperator<2>> elasticity;
  Constraints                            supports;
  LA::Vector                             loads;
  SolutionState<2>                       state;
  std::vector<SurfaceFields<2>>          fields;
};

void
check_checks()
{
  TwoBlocks blocks;
  // Pressure 10 with an overlap of 0.02; a shear of 4.4 at a bound of 4, and not along the slip; tension of 2
  // at an open node.
  blocks.set(0, ContactStatus::stick, 10, -0.02, Tensor<1, 2>({-3, 0}), Tensor<1, 2>());
  blocks.set(0.5, ContactStatus::slip, 8, 0, Tensor<1, 2>({4.4, 0}), Tensor<1, 2>({0.03, 0.04}));
  blocks.set(1, ContactStatus::open, -2, 0.3, Tensor<1, 2>(), Tensor<1, 2>());
  auto checks = check_physics(blocks.answer());
  check::is_close(checks["penetration"], 0.02 / 0.5, 1e-12, "penetration, of a face");
  check::is_close(checks["tension"], 2. / 10, 1e-12, "tension, of the peak");
  check::is_close(checks["complementarity"], 2 * 0.3 / (10 * 0.5), 1e-12, "complementarity");
  check::is_close(checks["coulomb_cone"], 0.4 / 5, 1e-12, "beyond the cone, of the largest bound");
  check::is_close(checks["slip_direction"], std::hypot(0.4, 0.8), 1e-12, "angle between shear and slip");

  // Beside pressures that were, these are rounding.
  checks = check_physics(blocks.answer(), 4e7);
  check::is_close(checks["tension"], 2. / 40, 1e-12, "tension, of what is left of larger pressures");
  check::is_close(checks["coulomb_cone"], 0.4 / 40, 1e-12, "beyond the cone, of what is left of them");

  // Nothing balances the contact forces F = area (-q_x, p - q_y) on the upper block and -F on the lower one:
  // all of them are missing, and with them a moment about each body.
  const auto &geometry  = blocks.problem.geometry;
  double      moments[] = {0, 0}, absolute = 0;
  for (const auto &[x, area, force] : {std::make_tuple(0., 0.25, Tensor<1, 2>({3., 10.})),
                                       std::make_tuple(0.5, 0.5, Tensor<1, 2>({-4.4, 8.})),
                                       std::make_tuple(1., 0.25, Tensor<1, 2>({0., -2.}))})
    {
      for (unsigned int body = 0; body < 2; ++body)
        {
          const auto &centre = geometry.body_centres[body];
          moments[body] += area * ((x - centre[0]) * force[1] - (1 - centre[1]) * force[0]);
        }
      absolute += area * (std::abs(force[0]) + std::abs(force[1]));
    }
  const double size = geometry.body_sizes[0], moment = std::max(std::abs(moments[0]), std::abs(moments[1]));
  check::is_close(checks["moment_balance"], moment / (absolute * size), 1e-10, "moment that is missing");
  check::is_close(checks["force_balance"], std::sqrt(0.5), 1e-10, "forces that are missing");
  Tensor<1, 2> on_slave, on_master;
  const auto   forces = contact_forces(blocks.answer());
  for (const auto &node : blocks.problem.slave().nodes)
    for (unsigned int c = 0; c < 2; ++c)
      on_slave[c] += forces.at(node.dofs[c]);
  for (const auto &node : blocks.problem.interfaces[0].master_surface->nodes)
    for (unsigned int c = 0; c < 2; ++c)
      on_master[c] += forces.at(node.dofs[c]);
  check::is_close(on_slave[0], 0.75 - 2.2, 1e-10, "force on the slave along x");
  check::is_close(on_slave[1], 2.5 + 4 - 0.5, 1e-10, "force on the slave along y");
  check::is_close((on_slave + on_master).norm(), 0, 1e-10, "the opposite one on the master", 1);

  // Where all is well, all is zero.
  blocks.set(0, ContactStatus::stick, 10, 0, Tensor<1, 2>({-3, 0}), Tensor<1, 2>());
  blocks.set(0.5, ContactStatus::slip, 8, 0, Tensor<1, 2>({4, 0}), Tensor<1, 2>({0.03, 0}));
  blocks.set(1, ContactStatus::open, 0, 0.3, Tensor<1, 2>(), Tensor<1, 2>());
  checks = check_physics(blocks.answer());
  for (const char *const name :
       {"penetration", "tension", "complementarity", "coulomb_cone", "slip_direction"})
    check::is_close(checks[name], 0, 1e-12, std::string(name) + " of a good state", 1);
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_checks();
  return check::result();
}
} // namespace test_quantities

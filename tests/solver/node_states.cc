// What is known of a node stays with it where rows come and go.
#include "contact/contact_scene.h"

#include <amontons/solver/node_states.h>

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Scene                                    scene;
  scene.bodies            = {block("lower", {0, 0, 0}, {1, 1, 0}, {{4, 1, 1}}),
                             block("upper", {0, 1, 0}, {1, 2, 0}, {{4, 1, 1}})};
  scene.pairs             = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  scene.pairs[0].friction = Expression(0.5);
  ConditionData held;
  held.boundaries   = {{"lower", "bottom", {}}, {"upper", "top", {}}};
  held.displacement = {{Expression(0.), Expression(0.), {}}};
  scene.conditions  = {held};
  Problem<2> problem(scene, 1);
  auto      &interface = problem.interfaces[0];
  const auto rows      = interface.coupling.rows;
  check::is_true(rows.size() == 5, "a row for each node");

  // Nodes 1, 2 and 4 had rows; 2, 3 and 4 have some now.
  SolutionState<2> state;
  state.contact = {NodalContacts<2>(5)};
  for (const unsigned int n : {1, 2, 4})
    {
      auto &known          = state.contact[0][n];
      known.has_multiplier = true;
      known.state          = n == 2 ? ContactStatus::stick : ContactStatus::slip;
      known.pressure       = n;
      known.trial[0]       = 2;
    }
  interface.coupling.rows          = {rows[2], rows[3], rows[4]};
  const auto              supports = problem.discretization->make_supports(0);
  const auto              nodes    = collect_contact_nodes(*problem.discretization, problem.interfaces, 1);
  const FloatingBodies<2> floating(*problem.discretization, supports, problem.interfaces);
  NodeStates<2>           states(nodes, problem.interfaces, floating, 0);
  states.start(state, {true, true, true});
  check::is_true(states.all() == std::vector<ContactStatus>{ContactStatus::stick,
                                                            ContactStatus::open,
                                                            ContactStatus::slip},
                 "states at the start: of the node, open where it had no row");
  check::is_close(states.law(2).direction[0], 1, 1e-14, "direction of slip");

  NodalContacts<2> answers(3);
  for (unsigned int k = 0; k < 3; ++k)
    {
      answers[k].pressure = 10 * (k + 1);
      answers[k].gap      = 0.1 * (k + 1);
      answers[k].shear[0] = 3;
      answers[k].slip[0]  = 0.25;
    }
  const auto stored = states.by_slave_node(answers)[0];
  check::is_true(stored.size() == 5, "an entry for each node");
  for (unsigned int n = 0; n < 5; ++n)
    {
      const std::string node = "node " + std::to_string(n);
      check::is_true(stored[n].has_multiplier == (n > 1), node + ": multiplier");
      check::is_close(stored[n].pressure, n > 1 ? 10. * (n - 1) : 0., 1e-14, node + ": pressure");
      check::is_close(stored[n].gap, n > 1 ? 0.1 * (n - 1) : 0., 1e-14, node + ": gap");
      check::is_close(stored[n].shear[0], n > 1 ? 3 : 0, 1e-14, node + ": shear");
      check::is_close(stored[n].slip[0], n > 1 ? 0.25 : 0, 1e-14, node + ": slip");
      // (shear + c slip)/(0.5 p), at most 3
      const double trial = (3 + nodes[0].c * 0.25) / (5. * (n - 1));
      check::is_close(
          stored[n].trial[0], n == 2 || n == 4 ? std::min(3., trial) : 0, 1e-12, node + ": trial");
    }
  check::is_true(stored[2].state == ContactStatus::stick && stored[3].state == ContactStatus::open &&
                     stored[4].state == ContactStatus::slip,
                 "states");
  return check::result();
}

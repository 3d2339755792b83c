// What is known of a node stays with it where rows come and go; which nodes have one way left.
#include "contact/contact_scene.h"

#include <amontons/solver/node_states.h>

namespace test_node_states
{
// DoFs 0, 1: own; 2, 3: opposite. given: those that supports prescribe.
bool
is_wedged_with(const std::vector<types::global_dof_index> &given, const double angle)
{
  SlaveNode<2> node{};
  node.normal[0] = 2 * std::sin(angle);
  node.normal[1] = 2 * std::cos(angle);
  for (unsigned int c = 0; c < 2; ++c)
    {
      node.components[c].candidates            = {c};
      node.components[c].equation.coefficients = {{c, 1.}, {2 + c, -1.}};
    }
  Constraints supports;
  for (const auto dof : given)
    supports.add_line(dof);
  supports.close();
  return is_wedged(node, supports);
}

void
check_wedged()
{
  const double oblique = 0.3;
  check::is_true(is_wedged_with({0, 2, 3}, oblique) && is_wedged_with({1, 2, 3}, oblique),
                 "one axis left, oblique to the surface");
  check::is_true(!is_wedged_with({2, 3}, oblique), "all axes left");
  check::is_true(!is_wedged_with({0, 1, 2, 3}, oblique), "none left");
  check::is_true(!is_wedged_with({0, 2}, oblique), "what is opposite may give way");
  check::is_true(!is_wedged_with({0, 2, 3}, 0), "across the surface");
  check::is_true(!is_wedged_with({1, 2, 3}, 0), "along the surface");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_wedged();
  Scene scene;
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

  // In equilibrium, a tension or an overlap that is none leaves a node as it is; of each pair, a large one
  // changes it.
  const ContactStatus before[3] = {states[0], states[1], states[2]}; // closed, open, closed
  answers                       = NodalContacts<2>(3);
  answers[0].pressure           = -1e-3;
  answers[1].gap                = -1e-6;
  answers[2].pressure           = 100;
  answers[2].shear[0]           = 50; // at its bound
  answers[2].slip[0]            = 0.25;
  NodeStates<2> same(states), pulls(states), overlaps(states);
  const double  force = 2e-3 * nodes[0].area;
  check::is_true(same.update(answers, 0, {force, 2e-6}) == 0 && same[0] == before[0] && same[1] == before[1],
                 "neutral nodes stay as they are");
  check::is_true(pulls.update(answers, 0, {force / 4, 2e-6}) == 1 && pulls[0] == ContactStatus::open,
                 "a tension opens");
  check::is_true(overlaps.update(answers, 0, {force, 5e-7}) == 1 && overlaps[1] != ContactStatus::open,
                 "an overlap closes");
  answers[0].pressure = -1; // a hundredth of the largest
  check::is_true(states.update(answers, 0, {1e4 * force, 2e-6}) == 1, "whatever the forces elsewhere");

  // A force that is none is a large traction at the edge of the contact, where areas are small.
  auto edge_nodes = nodes;
  edge_nodes[0].area *= 1e-3;
  answers = NodalContacts<2>(3);
  for (const double excess : {0.05, 0.002}) // over the bound 0.5; the largest one is 50
    {
      NodeStates<2> edge(edge_nodes, problem.interfaces, floating, 0);
      for (unsigned int k = 0; k < 3; ++k)
        {
          edge.impose(k, ContactStatus::stick);
          answers[k].pressure = k == 0 ? 1 : 100;
          answers[k].shear[0] = k == 0 ? 0.5 + excess : 0;
        }
      edge.update(answers, 0, {1e4 * force, 2e-6});
      check::is_true(edge[0] == (excess > 0.005 ? ContactStatus::slip : ContactStatus::stick),
                     "shears over the bound at an edge");
    }

  // Given bounds stand instead of those that pressures make, and shears at them obey the law.
  answers = NodalContacts<2>(3);
  SlipLaw<2> law;
  law.direction[0] = 1;
  for (unsigned int k = 0; k < 3; ++k)
    {
      states.impose(k, ContactStatus::slip, law);
      answers[k].pressure = 10;
      answers[k].shear[0] = k + 2.;
      answers[k].slip[0]  = 0.25;
    }
  check::is_true(states[1] == ContactStatus::slip && states.law(1).direction[0] == 1, "imposed state");
  check::is_true(states.law_error(answers) > nodes[0].area, "shears that are not those of the pressures");
  states.give_bounds({2, 3, 4});
  check::is_close(states.bound(2, 10).value, 4, 1e-14, "given bound");
  check::is_close(states.bound(2, 10).slope, 0, 1e-14, "slope of a given bound", 1);
  check::is_close(states.law_error(answers), 0, 1e-14, "shears at given bounds", 1);
  answers[2].shear[0] = 3.5;
  check::is_close(states.law_error(answers), 0.5 * nodes[2].area, 1e-12, "a shear below the bound of slip");
  check::is_true(states.update(answers, 0) == 0, "slip goes on at given bounds");
  answers[2].slip[0] = 0;
  check::is_true(states.update(answers, 0) == 1 && states[2] == ContactStatus::stick,
                 "a shear below a given bound sticks");

  // Slip that turns round sticks first, but where no bound could hold it: there it would change for ever.
  for (const unsigned int k : {0, 1})
    {
      states.impose(k, ContactStatus::slip, law);
      answers[k].shear[0] = 0;
      answers[k].slip[0]  = -0.25;
    }
  states.give_bounds({0, 3, 4});
  states.update(answers, 0);
  check::is_true(states[0] == ContactStatus::slip, "no bound: slip turns round");
  check::is_true(states[1] == ContactStatus::stick, "a bound: what turns round sticks first");
  states.give_bounds({0, 3, 4});
  answers[0].slip[0]  = 0;
  answers[0].shear[0] = 1e-9;
  states.update(answers, 1e-6);
  check::is_true(states[0] == ContactStatus::slip, "no bound: nor does what rests stick again");
  return check::result();
}
} // namespace test_node_states

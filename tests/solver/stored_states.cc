// What is known by row stays with its node where rows come and go.
#include "contact/contact_scene.h"

#include <amontons/solver/stored_states.h>

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Scene                                    scene;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 0}, {{4, 1, 1}}),
                  block("upper", {0, 1, 0}, {1, 2, 0}, {{4, 1, 1}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  Problem<2> problem(scene, 1);

  // Nodes 1, 2 and 4 had rows; 2, 3 and 4 have some now.
  const std::vector<bool> before = {false, true, true, false, true}, now = {false, false, true, true, true};
  auto                   &interface = problem.interfaces[0];
  const auto              rows      = interface.coupling.rows;
  check::is_true(rows.size() == 5, "a row for each node");
  interface.coupling.rows = {rows[2], rows[3], rows[4]};
  interface.carried       = now;

  SolutionState state;
  state.carried   = {before};
  state.states    = {{ContactState::slip, ContactState::stick, ContactState::slip}};
  state.pressures = {{1, 2, 4}};
  state.gaps      = {{10, 20, 40}};
  const auto list = [](const double a, const double b, const double c) {
    return std::vector<Tensor<1, 3>>{
        Tensor<1, 3>({a, 0, 0}), Tensor<1, 3>({b, 0, 0}), Tensor<1, 3>({c, 0, 0})};
  };
  state.shears = {list(1, 2, 4)};
  state.trials = {list(10, 20, 40)};
  state.slips  = {list(100, 200, 400)};
  fit_states(problem.interfaces, state);

  check::is_true(state.states[0] ==
                     std::vector<ContactState>{ContactState::stick, ContactState::open, ContactState::slip},
                 "states");
  check::is_true(state.pressures[0] == std::vector<double>{2, 0, 4}, "pressures");
  check::is_true(state.gaps[0] == std::vector<double>{20, 0, 40}, "gaps");
  check::is_true(state.shears[0] == list(2, 0, 4), "shears");
  check::is_true(state.trials[0] == list(20, 0, 40), "trials");
  check::is_true(state.slips[0] == list(200, 0, 400), "slips");
  check::is_true(state.carried[0] == now, "nodes with a row");
  return check::result();
}

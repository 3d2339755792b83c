// Nodes move on along a straight line in gap and slip until they touch.
#include "check.h"

#include <amontons/solver/before_touch.h>

#include <deal.II/base/mpi.h>

using namespace Amontons;

namespace test_before_touch
{
NodalContact<2>
node(const ContactStatus state, const double gap, const double slip = 0)
{
  NodalContact<2> result;
  result.has_multiplier = true;
  result.state          = state;
  result.gap            = gap;
  result.slip[0]        = slip;
  return result;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  constexpr auto                         open = ContactStatus::open;
  SolutionState<2>                       state;
  state.committed_contact = {{node(open, 3),
                              node(open, 3),
                              node(open, 3),
                              node(open, 3),
                              node(ContactStatus::slip, 0),
                              node(open, 1),
                              NodalContact<2>()}};
  state.contact           = {{node(open, 1, 0.5),
                              node(open, 1.6, 0.5),
                              node(open, 2.5, 0.5),
                              node(ContactStatus::stick, 0, 0.5),
                              node(open, 1, 0.5),
                              node(open, 2, 0.5),
                              node(open, 1, 0.5)}};
  auto       result       = motion_before_touch(state);
  const auto is           = [&](const unsigned int n, const double expected, const std::string &what) {
    check::is_close(result[0][n][0], expected, 1e-15, what, 1);
  };
  is(0, 0.25, "half of the way of the increment before is left");
  is(1, 0.5, "no more than in the increment before");
  is(2, 0, "too far away to touch");
  is(3, 0, "closed");
  is(4, 0, "just opened");
  is(5, 0, "moves away");
  is(6, 0, "nothing was opposite before");

  // Slip counted from where the node would touch; but it did not.
  Tensor<1, 2> expected_before;
  expected_before[0] = 0.3;
  state.before_touch.assign(1, std::vector<Tensor<1, 2>>(7, expected_before));
  result = motion_before_touch(state);
  is(0, 0.4, "with the motion that was not counted");
  return check::result();
}
} // namespace test_before_touch

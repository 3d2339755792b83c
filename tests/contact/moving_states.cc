// Ends of contact and of stick go on along a line as they moved before.
#include "contact/contact_scene.h"

#include <amontons/contact/moving_states.h>

namespace test_moving_states
{
// Sticks for |x| < c, slips up to a (outwards).
NodalContacts<2>
states(const ContactSurface<2> &slave, const double c, const double a)
{
  NodalContacts<2> result(slave.nodes.size());
  for (unsigned int i = 0; i < result.size(); ++i)
    {
      const double x  = slave.nodes[i].X[0];
      result[i].state = std::abs(x) < c   ? ContactStatus::stick
                        : std::abs(x) < a ? ContactStatus::slip
                                          : ContactStatus::open;
      if (result[i].state == ContactStatus::slip)
        result[i].trial[0] = x > 0 ? 2 : -2;
    }
  return result;
}

unsigned int
count(const NodalContacts<2> &contact, const ContactStatus state)
{
  return std::count_if(contact.begin(), contact.end(), [&](const auto &node) { return node.state == state; });
}

void
test_line(const unsigned int degree)
{
  ObstacleData plane;
  plane.normal = Tensor<1, 3>({0, -1, 0});
  plane.motion = MotionData();
  const Problem<2> problem(
      scene_with_obstacle(block("block", {-1, -1, 0}, {1, 0, 0}, {{100, 2, 1}}), "top", plane), degree);
  const auto &interface = problem.interfaces[0];
  const auto &slave     = *interface.slave;
  const auto  earlier = states(slave, 0.2, 0.4), now = states(slave, 0.3, 0.6);
  const auto  moved = move_states_on(interface, earlier, 1., now, 2., 2.5);
  check::is_true(moved.has_value(), "ends move on");
  if (!moved)
    return;
  const auto expected = states(slave, 0.35, 0.7);
  for (const auto state : {ContactStatus::open, ContactStatus::slip, ContactStatus::stick})
    check::is_true(std::abs(int(count(*moved, state)) - int(count(expected, state))) <= 4,
                   "as many nodes as expected, but for halves of faces at the ends");
  for (unsigned int i = 0; i < slave.nodes.size(); ++i)
    {
      const double x = std::abs(slave.nodes[i].X[0]);
      if (std::min(std::abs(x - 0.35), std::abs(x - 0.7)) > 0.04)
        check::is_true((*moved)[i].state == expected[i].state, "state off the ends");
      if (std::abs(x - 0.63) < 0.02)
        check::is_true((*moved)[i].trial * expected[i].trial > 0, "slips as its neighbours do");
    }
  check::is_true(!move_states_on(interface, now, 1., earlier, 2., 4.5), "a part would vanish");
  check::is_true(!move_states_on(interface, states(slave, 0, 0.4), 1., now, 2., 3.), "other parts");
  check::is_true(!move_states_on(interface, now, 1., now, 2., 3.), "nothing moves");
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_line(1);
  test_line(2);
  return check::result();
}
} // namespace test_moving_states

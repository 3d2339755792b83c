// Two closed nodes see no contact, unless they are in a corner of a body: at the end of a line, wherever that
// has been moved to; not where it is cut by a plane of symmetry, nor where displacements hold it as one
// would.
#include "contact/contact_scene.h"

#include <amontons/adaptivity/unseen_contact.h>

namespace test_unseen_contact
{
// A block of 16 faces on a longer one, held at its left end so; closed around x.
bool
is_resolved(const double x, const std::optional<ConditionData::Type> held, const double moved)
{
  Scene scene;
  scene.bodies = {block("lower", {-4, -1, 0}, {5, 0, 0}, {{9, 1, 1}}),
                  block("upper", {0, 0, 0}, {1, 1, 0}, {{16, 1, 1}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  if (held)
    {
      ConditionData condition;
      condition.type       = *held;
      condition.boundaries = {{"upper", "left", {}}};
      if (*held == ConditionData::Type::displacement)
        condition.displacement[0] = Expression(0.);
      scene.conditions = {condition};
    }
  Problem<2> problem(scene, 1);
  auto       u = problem.discretization->make_owned_vector();
  for (const auto &node : problem.slave().nodes)
    if (problem.discretization->locally_owned.is_element(node.dofs[1]))
      u(node.dofs[1]) = moved;
  u.compress(dealii::VectorOperation::insert);
  auto readable = problem.discretization->make_relevant_vector();
  readable      = u;
  problem.interfaces[0].slave->move(readable);
  SurfaceFields<2> fields;
  for (const auto &node : problem.slave().nodes)
    fields.state.push_back(std::abs(node.X[0] - x) < 0.05 ? ContactStatus::slip : ContactStatus::open);
  return contact_is_resolved(problem.interfaces[0], fields);
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Type = ConditionData::Type;
  check::is_true(!is_resolved(0.5, {}, 0), "in the middle");
  for (const double moved : {0., 3.})
    for (const double x : {0., 1.})
      check::is_true(is_resolved(x, {}, moved), "in a corner, moved by " + std::to_string(moved));
  check::is_true(!is_resolved(0, Type::symmetry, 0), "at a plane of symmetry");
  check::is_true(!is_resolved(0, Type::displacement, 0), "where displacements hold such a plane");
  check::is_true(is_resolved(1, Type::displacement, 0), "at the other end");
  return check::result();
}
} // namespace test_unseen_contact

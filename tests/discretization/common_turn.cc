// A scene that turns as a whole: the motion is found from what is prescribed, also on one plane, and moves
// the rest; not where something is prescribed otherwise.
#include "check.h"

#include <amontons/discretization/common_turn.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

namespace test_common_turn
{
using namespace Amontons;

BodyData
block(const std::string &name, const double at)
{
  BodyData body;
  body.name  = name;
  body.lower = {at, 0, 0};
  body.upper = {at + 1, 2, 1};
  body.cells = {{2, 3, 1}};
  return body;
}

ConditionData
displaced(const std::string &body, const std::array<std::optional<Expression>, 3> &displacement)
{
  ConditionData result;
  result.type         = ConditionData::Type::displacement;
  result.boundaries   = {{body, "bottom", {}}};
  result.displacement = displacement;
  return result;
}

// What is the answer everywhere; nothing: that there is none.
template <int dim>
void
check_motion(const Scene                                                            &scene,
             const std::optional<std::function<Tensor<1, dim>(const Point<dim> &)>> &expected,
             const std::string                                                      &what)
{
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  Discretization<dim> discretization(scene, geometry, 2);
  discretization.distribute_dofs();
  const auto supports = discretization.make_supports(1);
  const auto start    = discretization.make_relevant_vector();
  const auto motion   = common_turn(discretization, supports, start);
  const auto result   = motion ? moved(discretization, supports, *motion, start) : std::nullopt;
  check::is_true(result.has_value() == expected.has_value(), what + ": whether it turns as a whole");
  if (!result || !expected)
    return;
  std::map<types::global_dof_index, Point<dim>> points;
  DoFTools::map_dofs_to_support_points(discretization.mapping(), discretization.dof_handler, points);
  for (unsigned int c = 0; c < dim; ++c)
    {
      ComponentMask mask(dim, false);
      mask.set(c, true);
      for (const auto dof : DoFTools::extract_dofs(discretization.dof_handler, mask))
        check::is_close((*result)(dof), (*expected)(points.at(dof))[c], 1e-12, what, 1);
    }
}

void
check_in_plane()
{
  const std::array<std::optional<Expression>, 3>
      turned        = {{Expression("(cos(0.5)-1)*x - sin(0.5)*y + 0.3", {}),
                        Expression("sin(0.5)*x + (cos(0.5)-1)*y", {}),
                        {}}},
      other         = {{turned[0], Expression("sin(0.5)*x + (cos(0.5)-1)*y + 0.01", {}), {}}};
  const auto motion = [](const Point<2> &X) {
    return Tensor<1, 2>{{(std::cos(0.5) - 1) * X[0] - std::sin(0.5) * X[1] + 0.3,
                         std::sin(0.5) * X[0] + (std::cos(0.5) - 1) * X[1]}};
  };
  Scene scene;
  scene.bodies     = {block("a", 0), block("b", 2), block("free", 5)};
  scene.conditions = {displaced("a", turned), displaced("b", turned)};
  check_motion<2>(scene, {motion}, "two bodies turned, one free");
  scene.conditions = {displaced("a", turned)};
  check_motion<2>(scene, {motion}, "one line turned");
  scene.conditions = {displaced("a", turned), displaced("b", other)};
  check_motion<2>(scene, {}, "one of them moves on by itself");
  scene.conditions = {displaced("a", turned), displaced("b", {{Expression(0.), {}, {}}})};
  check_motion<2>(scene, {}, "one is held in part");
  scene.conditions = {displaced("a", {{Expression(0.1), Expression(0.2), {}}})};
  check_motion<2>(scene, {}, "a translation");
  scene.conditions = {};
  check_motion<2>(scene, {}, "nothing is held");
}

// By 120 degrees about (1, 1, 1): (x, y, z) -> (z, x, y)
void
check_in_space()
{
  const std::array<std::optional<Expression>, 3> turned = {
      {Expression("z - x", {}), Expression("x - y", {}), Expression("y - z", {})}};
  const auto motion = [](const Point<3> &X) { return Tensor<1, 3>{{X[2] - X[0], X[0] - X[1], X[1] - X[2]}}; };
  Scene      scene;
  scene.kind       = ProblemType::three_dimensional;
  scene.bodies     = {block("a", 0), block("free", 5)};
  scene.conditions = {displaced("a", turned)};
  check_motion<3>(scene, {motion}, "one plane turned in space");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_in_plane();
  check_in_space();
  return check::result();
}
} // namespace test_common_turn

// Derivatives of gaps, normals, areas and contact forces of moved surfaces in the plane against differences;
// rigid rotations change nothing.
#include "contact/moved_scene.h"

namespace test_coupling_derivatives
{
using ::block;

std::mt19937 generator(1);

BodyData
block(const std::string &name, const Point<3> &lower, const Point<3> &upper, const unsigned int nx)
{
  return block(name, lower, upper, std::array<unsigned int, 3>{{nx, 1, 1}});
}

void
check_scene(const Scene &scene, const unsigned int degree, const double size, const std::string &what)
{
  const std::string name = what + ", degree " + std::to_string(degree);
  Problem<2>        problem(scene, degree);
  Moved<2>          moved(problem);
  moved.displace_at_random(0.05 * size, generator);
  check_derivatives(moved, size, 0, generator, name);
  if (scene.kind != ProblemType::axisymmetric)
    check_rotation(moved, size, name);
}

Scene
two_blocks(const double a, const double b, const unsigned int n)
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {2, 1, 0}, 6), block("upper", {a, 1.02, 0}, {b, 2, 0}, n)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  return scene;
}

void
check_blocks(const unsigned int degree)
{
  check_scene(two_blocks(0.07, 1.9, 5), degree, 0.3, "blocks");
  check_scene(two_blocks(-0.3, 2.2, 4), degree, 0.3, "partly covered blocks");

  const Scene matching = two_blocks(1. / 3, 5. / 3, 4);
  Problem<2>  problem(matching, degree);
  Moved<2>    moved(problem);
  check_derivatives(moved, 0.3, 0, generator, "matching blocks, degree " + std::to_string(degree), 1e-4);

  Scene         held = two_blocks(0.07, 1.9, 4);
  ConditionData condition;
  condition.boundaries   = {{"upper", "left", {}}};
  condition.displacement = {{Expression(0.), Expression(0.), {}}};
  held.conditions        = {condition};
  check_scene(held, degree, 0.3, "a held corner");

  Scene declared                = two_blocks(0.07, 1.9, 4);
  declared.pairs[0].initial_gap = Expression("0.1 + 0.05*x^2", {});
  check_scene(declared, degree, 0.3, "a declared gap");

  Scene axisymmetric = two_blocks(0, 1.9, 4);
  axisymmetric.kind  = ProblemType::axisymmetric;
  check_scene(axisymmetric, degree, 0.3, "axisymmetric");
}

void
check_disk(const unsigned int degree)
{
  BodyData disk;
  disk.name        = "disk";
  disk.shape       = "half disk";
  disk.radius      = 2;
  disk.centre      = {0, 3.02, 0};
  disk.refinements = 2;
  Scene scene;
  scene.bodies = {block("it", {-1.1, 0, 0}, {1, 1, 0}, 5), disk};
  scene.pairs  = {pair_of({"it", "top", {}}, {"disk", "arc", {}})};
  check_scene(scene, degree, 0.4, "disk above block");
  scene.pairs = {pair_of({"disk", "arc", {}}, {"it", "top", {}})};
  check_scene(scene, degree, 0.4, "disk as slave");
}

void
check_obstacles(const unsigned int degree)
{
  ObstacleData obstacle;
  obstacle.type   = ObstacleData::Type::sphere;
  obstacle.centre = {0.1, 4.1, 0};
  obstacle.radius = 3;
  const auto body = block("it", {-1, 0, 0}, {1, 1, 0}, 5);
  check_scene(scene_with_obstacle(body, "top", obstacle), degree, 0.4, "circle");
  obstacle.type   = ObstacleData::Type::paraboloid;
  obstacle.centre = {0.1, 1.1, 0};
  obstacle.normal = Tensor<1, 3>({0.1, -1, 0});
  check_scene(scene_with_obstacle(body, "top", obstacle), degree, 0.4, "parabola");
}

// Normals on symmetry planes stay in them.
void
check_symmetry(const unsigned int degree)
{
  Scene         scene = two_blocks(0, 2, 5);
  ConditionData symmetry;
  symmetry.type          = ConditionData::Type::symmetry;
  symmetry.boundaries    = {{"upper", "left", {}}};
  scene.conditions       = {symmetry};
  const std::string what = "symmetry, degree " + std::to_string(degree);
  Problem<2>        problem(scene, degree);
  Moved<2>          moved(problem);
  moved.displace_at_random(0.02, generator);
  check_derivatives(moved, 0.4, 0, generator, what);
  for (const auto &node : problem.slave().nodes)
    for (const auto &plane : node.symmetry_planes)
      check::is_close(node.normal * plane, 0, 1e-14, what + ": normals lie in the planes", 1);
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_blocks(degree);
      check_disk(degree);
      check_obstacles(degree);
      check_symmetry(degree);
    }
  return check::result();
}
} // namespace test_coupling_derivatives

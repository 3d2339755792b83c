// The same in space: warped faces that do not match, hanging nodes, curved faces, obstacles, and faces that
// do match.
#include "contact/moved_scene.h"

namespace test_coupling_derivatives_3d
{
std::mt19937 generator(1);

void
check_scene(const Scene       &scene,
            const unsigned int degree,
            const double       size,
            const std::string &what,
            const unsigned int n_refinements = 0,
            const unsigned int seed          = 1)
{
  const std::string name = what + ", degree " + std::to_string(degree);
  Problem<3>        problem(scene, degree, n_refinements, seed);
  unsigned int      n_hanging = 0;
  for (const auto &node : problem.slave().nodes)
    n_hanging += !node.parents.empty();
  check::is_true((n_hanging > 0) == (n_refinements > 0), name + ": hanging nodes");
  Moved<3> moved(problem);
  moved.displace_at_random(0.03 * size, generator);
  check_derivatives(moved, size, 6, generator, name);
  check_rotation(moved, size, name);
}

Scene
two_blocks(const Point<3> &lower, const Point<3> &upper, const std::array<unsigned int, 3> &cells)
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 0.5}, {{2, 2, 1}}), block("upper", lower, upper, cells)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  return scene;
}

void
check_blocks(const unsigned int degree)
{
  check_scene(two_blocks({0.11, 0.07, 0.51}, {0.9, 0.95, 1}, {{1, 1, 1}}), degree, 0.5, "blocks");
  check_scene(
      two_blocks({-0.2, 0.13, 0.51}, {0.7, 1.2, 1}, {{2, 1, 1}}), degree, 0.5, "partly covered blocks");
  check_scene(
      two_blocks({0.11, 0.07, 0.51}, {0.9, 0.95, 1}, {{2, 2, 1}}), degree, 0.4, "hanging nodes", 1, 4);

  Scene         held = two_blocks({0.11, 0.07, 0.51}, {0.9, 0.95, 1}, {{2, 1, 1}});
  ConditionData condition;
  condition.boundaries   = {{"upper", "left", {}}};
  condition.displacement = {{Expression(0.), Expression(0.), Expression(0.)}};
  held.conditions        = {condition};
  check_scene(held, degree, 0.4, "a held edge");
}

// Lines of the master lie on the edges of the slave's faces: where these are covered whole, derivatives are
// continuous.
void
check_matching_faces(const unsigned int degree)
{
  const std::string what  = "matching faces, degree " + std::to_string(degree);
  Scene             scene = two_blocks({0.25, 0.25, 0.5}, {0.75, 0.75, 1}, {{2, 2, 1}});
  scene.bodies[0].cells   = {{4, 4, 1}};
  Problem<3> problem(scene, degree);
  Moved<3>   moved(problem);
  check_derivatives(moved, 0.25, 6, generator, what, 1e-4);
}

void
check_obstacle(const unsigned int degree)
{
  ObstacleData sphere;
  sphere.type   = ObstacleData::Type::sphere;
  sphere.centre = {0.1, 0.1, 3.6};
  sphere.radius = 3;
  check_scene(scene_with_obstacle(block("it", {0, 0, 0}, {1, 1, 0.5}, {{2, 1, 1}}), "top", sphere),
              degree,
              0.5,
              "sphere");
}

// Its true surface turns with its faces.
void
check_ball(const unsigned int degree)
{
  BodyData ball;
  ball.name   = "ball";
  ball.shape  = "half sphere";
  ball.centre = {0, 0, 1.02};
  Scene scene;
  scene.bodies = {block("it", {-0.61, -0.53, -1}, {0.7, 0.65, 0}, {{2, 3, 1}}), ball};
  scene.pairs  = {pair_of({"it", "top", {}}, {"ball", "surface", {}})};
  check_scene(scene, degree, 0.5, "ball above block");
  scene.pairs = {pair_of({"ball", "surface", {}}, {"it", "top", {}})};
  check_scene(scene, degree, 0.5, "ball as slave");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_blocks(degree);
      check_matching_faces(degree);
      check_obstacle(degree);
    }
  for (const unsigned int degree : {1, 2})
    check_ball(degree);
  return check::result();
}
} // namespace test_coupling_derivatives_3d

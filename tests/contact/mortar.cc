// Coupling rows of two meshed surfaces (or one and an obstacle): weights, areas, normals and gaps are those
// of geometry by hand, on flat, partly covered, curved and axisymmetric surfaces, in the
// plane and in space.
#include "contact/contact_scene.h"

namespace test_mortar
{
using ::block;

BodyData
block(const std::string &name, const Point<3> &lower, const Point<3> &upper, const unsigned int nx)
{
  return block(name, lower, upper, std::array<unsigned int, 3>{{nx, 2, 1}});
}

BodyData
ring(const std::string &name, const double inner, const double outer, const unsigned int refinements)
{
  BodyData body;
  body.name         = name;
  body.shape        = "ring";
  body.inner_radius = inner;
  body.radius       = outer;
  body.refinements  = refinements;
  return body;
}

void
check_blocks(const unsigned int degree)
{
  const std::string what = "blocks of degree " + std::to_string(degree);
  struct Case
  {
    double       a, b; // the slave on the master [0, 2]
    unsigned int n;
    double       gap;
  };
  for (const Case &c : {Case{0, 2, 5, 0},
                        Case{0, 2, 7, 0.1},
                        Case{0.3, 1.1, 3, 0.05},
                        Case{-0.7, 2.4, 4, 0.05},
                        Case{-1, 3, 1, 0},
                        Case{1.95, 4, 2, 0},
                        Case{1.2, 3.1, 9, 0.02}})
    {
      Scene scene;
      scene.bodies = {block("lower", {0, 0, 0}, {2, 1, 0}, 6),
                      block("upper", {c.a, 1 + c.gap, 0}, {c.b, 2, 0}, c.n)};
      scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
      check_flat(Problem<2>(scene, degree),
                 std::min(c.b, 2.) - std::max(c.a, 0.),
                 c.gap,
                 what + ", slave from " + std::to_string(c.a) + " to " + std::to_string(c.b));
    }
}

// Faces [k, k + 1] of a slave above a master: those that are covered whole, in the plane and as rings.
void
check_whole_faces(const unsigned int degree, const ProblemType kind)
{
  for (const auto &[a, b, wanted] : {std::make_tuple(0., 4., std::set<double>{0.5, 1.5, 2.5, 3.5}),
                                     std::make_tuple(0.4, 3., std::set<double>{1.5, 2.5}),
                                     std::make_tuple(-1., 2.98, std::set<double>{0.5, 1.5}),
                                     std::make_tuple(0.05, 0.9, std::set<double>{})})
    {
      if (kind == ProblemType::axisymmetric && a < 0)
        continue;
      Scene scene;
      scene.kind   = kind;
      scene.bodies = {block("lower", {a, 0, 0}, {b, 1, 0}, 3), block("upper", {0, 1, 0}, {4, 2, 0}, 4)};
      scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
      const Problem<2> problem(scene, degree);
      std::set<double> whole;
      for (const unsigned int f : problem.coupling().whole_faces)
        whole.insert(std::round(2 * problem.slave().faces[f].centre[0]) / 2);
      check::is_true(whole == wanted,
                     "whole faces above [" + std::to_string(a) + ", " + std::to_string(b) + "]");
    }
}

// A slave whose left side is held: its corner carries nothing, the others carry its share.
void
check_held_node(const unsigned int degree)
{
  Scene scene;
  scene.bodies = {block("lower", {-0.1, 0, 0}, {2, 1, 0}, 6), block("upper", {0, 1, 0}, {2, 2, 0}, 4)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  ConditionData held;
  held.boundaries   = {{"upper", "left", {}}};
  held.displacement = {{Expression(0.), Expression(0.), {}}};
  scene.conditions  = {held};
  const Problem<2> problem(scene, degree);
  check_flat(problem, 2, 0, "held corner");
  check::is_true(problem.interfaces[0].n_without_multiplier == 1, "one node without multiplier");
  check::is_true(problem.coupling().rows.size() + 1 == problem.interfaces[0].slave->nodes.size(),
                 "rows of the others");
}

// Gap x^2 / (2R) of a flat slave below a large circle: rows give (x_i^2 - h^2/6) / (2R) on linear faces,
// control values on quadratic ones.
void
check_circle_over_plane(const unsigned int degree)
{
  const double R = 1000, h = 0.25;
  ObstacleData circle;
  circle.type            = ObstacleData::Type::sphere;
  circle.centre          = {0, 1 + R, 0};
  circle.radius          = R;
  const Scene      scene = scene_with_obstacle(block("it", {-1, 0, 0}, {1, 1, 0}, 8), "top", circle);
  const Problem<2> problem(scene, degree);
  check_weights(problem, "circle over plane");
  check::is_close(problem.total_area(), 2, 1e-12, "circle over plane: area");
  for (const auto &row : problem.coupling().rows)
    {
      const double x        = problem.interfaces[0].slave->nodes[row.node].X[0];
      const bool   is_mid   = degree == 2 && std::abs(x / h - std::round(x / h)) > 0.1;
      const double expected = degree == 1 ? x * x - h * h / 6 : is_mid ? x * x - h * h / 4 : x * x;
      check::is_close(row.gap, expected / (2 * R), 1e-6, "circle over plane: gap", 1 / (2 * R));
    }
}

// A meshed disk above a flat slave: int (R - sqrt(R^2 - x^2)) dx over [-1, 1].
void
check_disk_over_plane(const unsigned int degree)
{
  const double R = 20;
  BodyData     disk;
  disk.name        = "disk";
  disk.shape       = "half disk";
  disk.radius      = R;
  disk.centre      = {0, 1 + R, 0};
  disk.refinements = 4;
  Scene scene;
  scene.bodies = {block("it", {-1, 0, 0}, {1, 1, 0}, 7), disk};
  scene.pairs  = {pair_of({"it", "top", {}}, {"disk", "arc", {}})};
  const Problem<2> problem(scene, degree);
  check_weights(problem, "disk over plane");
  check::is_close(problem.total_area(), 2, 1e-10, "disk over plane: area");
  check::is_close(problem.gap_integral(),
                  1 / (3 * R) + 1 / (20 * R * R * R) + 1 / (56 * std::pow(R, 5)),
                  1e-6,
                  "disk over plane: integral of the gap");
}

// Areas are int B_i 2 pi r dr.
void
check_axisymmetric(const unsigned int degree)
{
  const unsigned int n = 5;
  Scene              scene;
  scene.kind   = ProblemType::axisymmetric;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 0}, 7), block("upper", {0, 1, 0}, {1, 2, 0}, n)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<2> problem(scene, degree);
  check_flat(problem, numbers::PI, 0, "axisymmetric");
  check::is_true(problem.coupling().rows.size() == n * degree + 1,
                 "axisymmetric: all nodes carry multipliers");
  const double h = 1. / n;
  for (const auto &row : problem.coupling().rows)
    {
      // int B over one face is h/(degree + 1), with its centroid at (k + 1)/(degree + 2) for B_k
      const double x        = problem.interfaces[0].slave->nodes[row.node].X[0];
      const double k        = x / (h / degree);
      const bool   mid      = degree == 2 && std::lround(k) % 2 == 1;
      double       expected = 0;
      if (mid)
        expected = h / 3 * x;
      else
        {
          if (x < 1 - 1e-10)
            expected += h / (degree + 1) * (x + h / (degree + 2));
          if (x > 1e-10)
            expected += h / (degree + 1) * (x - h / (degree + 2));
        }
      check::is_close(row.area, 2 * numbers::PI * expected, 1e-10, "axisymmetric: area of a node");
    }
}

// Which nodes carry multipliers where the slave is covered in part does not depend on the radius.
void
check_partly_covered_turn(const unsigned int degree)
{
  for (const double end : {1.03, 1.2, 1.5, 1.85})
    {
      Scene scene;
      scene.bodies = {block("lower", {0, 0, 0}, {end, 1, 0}, 7), block("upper", {0, 1, 0}, {2, 2, 0}, 4)};
      scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
      const Problem<2> plane(scene, degree);
      scene.kind = ProblemType::axisymmetric;
      const Problem<2> turn(scene, degree);
      check_flat(turn, numbers::PI * end * end, 0, "partly covered, axisymmetric");
      check::is_true(turn.coupling().rows.size() == plane.coupling().rows.size(),
                     "partly covered up to " + std::to_string(end) + ", degree " + std::to_string(degree) +
                         ": " + std::to_string(turn.coupling().rows.size()) + " rows in the turn, " +
                         std::to_string(plane.coupling().rows.size()) + " in the plane");
    }
}

void
check_rings(const unsigned int degree, const double gap)
{
  const std::string what = "rings with gap " + std::to_string(gap);
  for (const bool inner_is_slave : {true, false})
    {
      Scene scene;
      scene.bodies = {ring("inner", 0.7, 1, 1), ring("outer", 1 + gap, 1.5, 2)};
      const BoundaryName a{"inner", "outer", {}}, b{"outer", "inner", {}};
      scene.pairs = {inner_is_slave ? pair_of(a, b) : pair_of(b, a)};
      const Problem<2> problem(scene, degree);
      check_weights(problem, what);
      const double R = inner_is_slave ? 1 : 1 + gap;
      check::is_close(problem.total_area(), 2 * numbers::PI * R, 1e-6, what + ": area");
      check::is_true(problem.coupling().rows.size() == problem.interfaces[0].slave->nodes.size(),
                     what + ": all nodes carry multipliers");
      for (const auto &node : problem.interfaces[0].slave->nodes)
        {
          const Tensor<1, 2> radial = (inner_is_slave ? 1 : -1) * node.X / node.X.norm();
          check::is_close(node.X.norm(), R, 1e-7, what + ": nodes on the circle");
          check::is_close((node.normal - radial).norm(), 0, 1e-6, what + ": normals are radial", 1);
        }
      for (const auto &point : problem.coupling().points)
        {
          check::is_close(point.gap, gap, 1e-6, what + ": gap at a point", R);
          check::is_close((point.x_master - point.x_slave - point.gap * point.normal).norm(),
                          0,
                          1e-10,
                          what + ": opposite points",
                          1);
        }
      for (const auto &row : problem.coupling().rows)
        // gap = normal . int psi g n / area, so that a uniform gap g gives g |normal|^2
        check::is_close(row.gap / row.normal.norm_square(), gap, 1e-6, what + ": weighted gap", R);
    }
}

// The ends of a quarter ring lie on symmetry planes: normals stay in them.
void
check_normals_at_symmetry()
{
  Scene scene;
  scene.bodies          = {ring("inner", 0.7, 1, 1), ring("outer", 1, 1.5, 2)};
  scene.bodies[0].shape = scene.bodies[1].shape = "quarter ring";
  scene.pairs                                   = {pair_of({"inner", "outer", {}}, {"outer", "inner", {}})};
  ConditionData symmetry;
  symmetry.type       = ConditionData::Type::symmetry;
  symmetry.boundaries = {{"inner", "cut x", {}}, {"inner", "cut y", {}}};
  scene.conditions    = {symmetry};
  const Problem<2> problem(scene, 2);
  check_weights(problem, "quarter rings");
  check::is_close(problem.total_area(), numbers::PI_2, 1e-6, "quarter rings: area");
  unsigned int n_on_planes = 0;
  for (const auto &node : problem.interfaces[0].slave->nodes)
    {
      n_on_planes += node.symmetry_planes.size();
      check::is_close(
          (node.normal - node.X / node.X.norm()).norm(), 0, 1e-5, "quarter rings: normals are radial", 1);
      for (const auto &plane : node.symmetry_planes)
        check::is_close(node.normal * plane, 0, 1e-12, "quarter rings: normals lie in the planes", 1);
    }
  check::is_true(n_on_planes == 2, "quarter rings: two nodes lie on symmetry planes");
}

// `Adjust` closes small gaps, an initial gap replaces the geometric one, an overlap is an error.
void
check_declared_gaps()
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {2, 1, 0}, 6), block("upper", {0, 1.001, 0}, {2, 2, 0}, 5)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  scene.pairs[0].adjust = 0.01;
  const Problem<2> adjusted(scene, 1);
  check::is_true(!adjusted.coupling().rows.empty(), "adjusted gap: there are rows");
  for (const auto &row : adjusted.coupling().rows)
    check::is_true(row.gap == 0, "adjusted gap");
  scene.pairs[0].adjust      = 0;
  scene.pairs[0].initial_gap = Expression("0.1 + 0.5*x", {});
  const Problem<2> declared(scene, 1);
  for (const auto &row : declared.coupling().rows)
    check::is_close(row.gap, 0.1 + 0.5 * declared.mean(row.slave)[0], 1e-10, "declared gap");
  scene.pairs[0].initial_gap = {};
  scene.bodies[1].lower[1]   = 0.9;
  bool thrown                = false;
  try
    {
      const Problem<2> overlapping(scene, 1);
    }
  catch (const InputError &)
    {
      thrown = true;
    }
  check::is_true(thrown, "bodies that overlap are an input error");
}

// A node that is open all around stays open, though psi, which changes its sign, finds a negative gap beside
// a step of the other side: at x = 2, between gaps of 0.3 and a step to 3 at 2.5, (0.3 - 0.375)/2 = -0.0375.
// The mean gap weighs with B: (0.3/2 + 0.3 3/8 + 3/8)/1 = 0.6375. Where the declared gap is seen to jump
// inside the face, it goes from node to node: 0.3 at 2, 3 at 3, and (0.3/2 + 0.3/3 + 3/6)/1 = 0.75.
void
check_open_beside_a_step(const std::string &gap, const double (&gaps)[5], const double (&means)[5])
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {4, 1, 0}, 8), block("upper", {0, 1, 0}, {4, 2, 0}, 4)};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  scene.pairs[0].initial_gap = Expression(gap, {});
  const Problem<2> problem(scene, 1);
  check::is_close(problem.coupling().rows.size(), 5, 0, "beside a step: rows");
  for (const auto &row : problem.coupling().rows)
    {
      const int         x    = std::lround(problem.slave().nodes[row.node].X[0]);
      const std::string name = "at " + std::to_string(x) + " for " + gap;
      check::is_close(row.gap, gaps[x], 1e-12, "beside a step: gap " + name, 1);
      check::is_close(row.mean_gap, means[x], 1e-12, "beside a step: mean gap " + name, 1);
    }
}

// The slave [a, b] x [c, d] on the master [0, 2] x [0, 1.5]: whole, half covered, beyond edges and corners.
void
check_blocks_in_space(const unsigned int degree)
{
  struct Case
  {
    double                      a, b, c, d;
    std::array<unsigned int, 3> cells;
    double                      gap;
  };
  for (const Case &c : {Case{0, 2, 0, 1.5, {{4, 3, 1}}, 0},
                        Case{0, 2, 0, 1.5, {{3, 3, 1}}, 0.1}, // faces match in y
                        Case{0.3, 1.1, 0.2, 1.3, {{3, 2, 1}}, 0.05},
                        Case{-1, 3, -0.7, 2.4, {{1, 1, 1}}, 0},
                        Case{-1, 3, -0.7, 2.4, {{5, 3, 1}}, 0},
                        Case{1.2, 3.1, 0.8, 1.9, {{2, 9, 1}}, 0.02},
                        Case{1.95, 4, 1.4, 3, {{2, 2, 1}}, 0}})
    {
      Scene scene;
      scene.bodies = {block("lower", {0, 0, 0}, {2, 1.5, 1}, {{6, 3, 1}}),
                      block("upper", {c.a, c.c, 1 + c.gap}, {c.b, c.d, 2}, c.cells)};
      scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
      check_flat(Problem<3>(scene, degree),
                 (std::min(c.b, 2.) - std::max(c.a, 0.)) * (std::min(c.d, 1.5) - std::max(c.c, 0.)),
                 c.gap,
                 "blocks in space of degree " + std::to_string(degree) + ", slave from " +
                     std::to_string(c.a) + ", " + std::to_string(c.c));
    }
}

// An eighth of a ball, locally refined, in a hollow one: normals are radial and lie in symmetry planes.
void
check_spheres(const unsigned int degree)
{
  const std::string what = "spheres of degree " + std::to_string(degree);
  Scene             scene;
  BodyData          ball, shell;
  ball.name = ball.shape = "eighth sphere";
  ball.radius            = 1;
  ball.refinements       = 1;
  shell                  = ball;
  shell.name             = "shell";
  shell.shape            = "eighth hollow sphere";
  shell.inner_radius     = 1.02;
  shell.radius           = 1.5;
  scene.bodies           = {ball, shell};
  scene.pairs            = {pair_of({"eighth sphere", "surface", {}}, {"shell", "inner", {}})};
  ConditionData symmetry;
  symmetry.type       = ConditionData::Type::symmetry;
  symmetry.boundaries = {
      {"eighth sphere", "plane x", {}}, {"eighth sphere", "plane y", {}}, {"eighth sphere", "plane z", {}}};
  scene.conditions = {symmetry};
  const Problem<3> problem(scene, degree, 2);
  check_weights(problem, what);
  unsigned int n_corners = 0, n_hanging = 0;
  for (const auto &node : problem.slave().nodes)
    {
      n_corners += node.symmetry_planes.size() == 2;
      n_hanging += !node.parents.empty();
      for (const auto &plane : node.symmetry_planes)
        check::is_close(node.normal * plane, 0, 1e-12, what + ": normals lie in the planes", 1);
      if (degree == 2 || node.parents.empty())
        check::is_close(node.X.norm(), 1, 1e-10, what + ": nodes on the sphere");
      check::is_close(
          (node.normal - node.X / node.X.norm()).norm(), 0, 1e-4, what + ": normals are radial", 1);
    }
  check::is_true(n_corners == 3, what + ": three nodes lie on two planes");
  check::is_true(n_hanging > 0, what + ": some nodes hang");
  check::is_close(problem.total_area(), numbers::PI_2, 1e-4, what + ": area");
  for (const auto &p : problem.coupling().points)
    {
      check::is_close(p.gap, 0.02, 1e-5, what + ": gap", 1);
      check::is_close(
          (p.x_master - p.x_slave - p.gap * p.normal).norm(), 0, 1e-10, what + ": opposite points", 1);
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      check_blocks(degree);
      check_whole_faces(degree, ProblemType::plane_strain);
      check_whole_faces(degree, ProblemType::axisymmetric);
      check_held_node(degree);
      check_circle_over_plane(degree);
      check_disk_over_plane(degree);
      check_axisymmetric(degree);
      check_partly_covered_turn(degree);
      check_rings(degree, 0);
      check_rings(degree, 0.01);
      check_blocks_in_space(degree);
      check_spheres(degree);
    }
  check_normals_at_symmetry();
  check_declared_gaps();
  check_open_beside_a_step("0.3/2*(1 + (x - 1)/abs(x - 1)) + 2.7/2*(1 + (x - 2.5)/abs(x - 2.5))",
                           {0, 0.15, 0.3, 3.3375, 3},
                           {0, 0.15, 0.6375, 2.6625, 3});
  check_open_beside_a_step(
      "if(x < 1, 0, if(x < 2.5, 0.3, 3))", {0, 0.15, 0.3, 3, 3}, {0, 0.15, 0.75, 2.55, 3});
  return check::result();
}
} // namespace test_mortar

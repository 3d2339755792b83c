// Rigid motions that neither supports nor contact hold are found and named; loads that drive one are the
// user's error.
#include "check.h"

#include <amontons/elasticity/loads.h>
#include <amontons/solver/floating_bodies.h>

#include <deal.II/base/mpi.h>

namespace test_floating_bodies
{
using namespace Amontons;

BodyData
block(const std::string &name, const Point<3> &lower, const Point<3> &upper)
{
  BodyData body;
  body.name  = name;
  body.lower = lower;
  body.upper = upper;
  body.cells = {{3, 2, 1}};
  return body;
}

ConditionData
condition(const ConditionData::Type type, const BoundaryName &boundary)
{
  ConditionData result;
  result.type       = type;
  result.boundaries = {boundary};
  return result;
}

ConditionData
hold(const BoundaryName &boundary)
{
  ConditionData held = condition(ConditionData::Type::displacement, boundary);
  held.displacement  = {{Expression(0.), Expression(0.), {}}};
  return held;
}

ConditionData
force(const BoundaryName &boundary, const double x, const double y)
{
  ConditionData result = condition(ConditionData::Type::total_force, boundary);
  result.value         = {{Expression(x), Expression(y), Expression(0.)}};
  return result;
}

// "lower" is held at its bottom, "upper" lies on it, frictionless.
Scene
two_blocks(const ProblemType kind = ProblemType::plane_strain)
{
  Scene scene;
  scene.kind       = kind;
  scene.bodies     = {block("lower", {0, 0, 0}, {2, 1, 0}), block("upper", {0, 1, 0}, {2, 2, 0})};
  scene.conditions = {hold({"lower", "bottom", {}})};
  PairData pair;
  pair.first  = {"upper", "bottom", {}};
  pair.second = BoundaryName{"lower", "top", {}};
  pair.slave  = PairData::Slave::first;
  scene.pairs = {pair};
  return scene;
}

struct Problem
{
  explicit Problem(const Scene &s) : scene(s), geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    discretization = std::make_unique<Discretization<2>>(scene, geometry, 2);
    discretization->distribute_dofs();
    interfaces          = make_interfaces(*discretization, choose_slaves(*discretization));
    const auto supports = discretization->make_supports(1);
    integrate_couplings(*discretization, supports, interfaces);
    for (const auto &interface : interfaces)
      for (const auto &row : interface.coupling.rows)
        for (unsigned int k = 0; k < (interface.pair->tied ? 2 : 1); ++k)
          {
            LinearEquation equation;
            for (unsigned int c = 0; c < 2; ++c)
              {
                const double n = interface.pair->tied ? double(c == k) : row.normal[c];
                for (const auto &[dofs, weight] : row.slave)
                  equation.coefficients[dofs[c]] += n * weight;
                for (const auto &[dofs, weight] : row.master)
                  equation.coefficients[dofs[c]] -= n * weight;
              }
            equations.push_back(equation);
          }
    for (const auto &equation : equations)
      all.push_back(&equation);
    floating = std::make_unique<FloatingBodies<2>>(*discretization, supports, interfaces);
    floating->set_loads(assemble_loads<2>(*discretization, 1, {}));
  }

  // The sentence about unheld motions, or "thrown: " and the message.
  std::string
  check_loads() const
  {
    try
      {
        return floating->check_loads(all);
      }
    catch (const InputError &error)
      {
        return std::string("thrown: ") + error.what();
      }
  }

  Scene                               scene;
  Geometry<2>                         geometry;
  std::unique_ptr<Discretization<2>>  discretization;
  std::vector<ContactInterface<2>>    interfaces;
  std::vector<LinearEquation>         equations;
  std::vector<const LinearEquation *> all;
  std::unique_ptr<FloatingBodies<2>>  floating;
};

// Names of the motions that the equations leave.
template <int dim>
std::string
free_rigid_modes(const FloatingBodies<dim> &floating, const std::vector<const LinearEquation *> &equations)
{
  std::string text;
  for (const auto &motion : floating.free_rigid_modes(equations))
    text += (text.empty() ? "" : "; ") + floating.describe(motion);
  return text;
}

bool
contains(const std::string &text, const std::string &part)
{
  return text.find(part) != std::string::npos;
}

void
check_sliding_block()
{
  Scene scene = two_blocks();
  scene.conditions.push_back(force({"upper", "top", {}}, 0, -1));
  Problem     pressed(scene);
  const auto &floats = pressed.floating->floats();
  check::is_true(pressed.floating->any() && !floats[0] && floats[1], "only the upper block floats");
  const std::string note = pressed.check_loads();
  check::is_true(!contains(note, "thrown") && contains(note, "motion along x of body 'upper'"),
                 "a note: " + note);
  check::is_true(!contains(note, "along y") && !contains(note, "'lower'"), "about nothing else: " + note);
  check::is_true(!free_rigid_modes(*pressed.floating, pressed.all).empty(), "contact does not hold sliding");
  pressed.floating->choose_pins(pressed.all);
  check::is_true(pressed.floating->pins().size() == 1, "one pin");
  check::is_true(free_rigid_modes(*pressed.floating, pressed.all).empty(), "contact and a pin hold all");
  check::is_true(free_rigid_modes(*pressed.floating, {pressed.all.front(), pressed.all.back()}).empty(),
                 "two nodes are enough");
  check::is_true(contains(free_rigid_modes(*pressed.floating, {pressed.all.front()}), "rotation"),
                 "one node is not");
  check::is_true(!free_rigid_modes(*pressed.floating, {}).empty(), "a pin alone is not");

  scene.conditions.back() = force({"upper", "top", {}}, 0.01, -1);
  check::is_true(contains(Problem(scene).check_loads(), "thrown"), "a tangential force drives the block");
  scene.conditions.push_back(force({"upper", "right", {}}, -0.01, 0));
  check::is_true(!contains(Problem(scene).check_loads(), "thrown"),
                 "tangential forces in equilibrium do not");
}

void
check_guided_block()
{
  Scene scene = two_blocks();
  scene.conditions.push_back(condition(ConditionData::Type::symmetry, {"upper", "left", {}}));
  scene.conditions.push_back(force({"upper", "top", {}}, 0.5, -1));
  Problem problem(scene);
  check::is_true(problem.floating->floats()[1], "a block on a guide floats");
  check::is_true(problem.check_loads().empty(),
                 "contact holds what the guide leaves: " + problem.check_loads());
  problem.floating->choose_pins(problem.all);
  check::is_true(problem.floating->pins().empty(), "no pins");
  check::is_true(free_rigid_modes(*problem.floating, {problem.all[1]}).empty(), "one node is enough");
  check::is_true(contains(free_rigid_modes(*problem.floating, {}), "motion along y of body 'upper'"),
                 "none is not");

  // without contact
  scene.pairs = {};
  check::is_true(contains(Problem(scene).check_loads(), "motion along y of body 'upper'"),
                 "nothing holds the block");
  check::is_true(contains(Problem(scene).check_loads(), "thrown"), "and the load drives it");
}

// Beside the origin the basis of its motions mixes them; each is named once, whatever that is.
void
check_free_block()
{
  Scene scene               = two_blocks();
  scene.pairs               = {};
  scene.bodies[1].lower     = {20, 3, 0};
  scene.bodies[1].upper     = {30, 7, 0};
  const std::string note    = Problem(scene).check_loads(),
                    motions = "rigid motion along x of body 'upper', motion along y of body 'upper', "
                              "rotation of body 'upper'; no load";
  check::is_true(contains(note, motions), "all three, once: " + note);
}

void
check_held_blocks()
{
  Scene scene = two_blocks();
  scene.conditions.push_back(hold({"upper", "top", {}}));
  scene.conditions.push_back(force({"upper", "right", {}}, 1, 1));
  Problem held(scene);
  check::is_true(!held.floating->any() && !held.floating->floats()[1], "held blocks do not float");
  check::is_true(held.check_loads().empty() && free_rigid_modes(*held.floating, {}).empty(),
                 "supports suffice");

  scene = two_blocks();
  scene.conditions.push_back(force({"upper", "right", {}}, 1, 1));
  scene.pairs[0].tied = true;
  Problem tied(scene);
  check::is_true(tied.floating->any() && tied.check_loads().empty(),
                 "a tied block is held: " + tied.check_loads());
  check::is_true(free_rigid_modes(*tied.floating, tied.all).empty(), "by the tied nodes");
}

// The upper block's top moves with a platen.
void
check_platen()
{
  Scene         scene  = two_blocks();
  ConditionData platen = condition(ConditionData::Type::platen, {"upper", "top", {}});
  MotionData    motion;
  motion.name      = "plate";
  motion.reference = {1, 2, 0};
  motion.force[1]  = Expression(-1.);
  platen.motion    = motion;
  scene.conditions.push_back(platen);
  Problem loaded(scene);
  check::is_true(loaded.floating->floats()[1] && loaded.floating->floats()[2], "block and platen float");
  check::is_true(!contains(loaded.check_loads(), "thrown") && contains(loaded.check_loads(), "'plate'"),
                 "nothing drives the platen sideways: " + loaded.check_loads());

  scene.conditions.back().motion->force[0] = Expression(0.2);
  check::is_true(contains(Problem(scene).check_loads(), "thrown"), "a sideways force does");

  scene.conditions.back().motion->displacement[0] = Expression(0.);
  check::is_true(Problem(scene).check_loads().empty(), "unless the platen is held sideways");

  scene.conditions.back().motion->displacement[1] = Expression(-0.1);
  Problem rotating(scene);
  check::is_true(rotating.floating->any(), "the rotation is free");
  check::is_true(contains(free_rigid_modes(*rotating.floating, {}), "rotation"), "and named");
  check::is_true(free_rigid_modes(*rotating.floating, rotating.all).empty(), "contact holds it");

  scene.conditions.back().motion->rotation[2] = Expression(0.);
  check::is_true(!Problem(scene).floating->any(), "a platen with all prescribed does not float");
}

void
check_axisymmetric()
{
  Scene scene = two_blocks(ProblemType::axisymmetric);
  scene.conditions.push_back(force({"upper", "top", {}}, 0, -1));
  Problem problem(scene);
  check::is_true(problem.floating->floats()[1], "axisymmetric: the upper body floats");
  check::is_true(problem.check_loads().empty(), "axisymmetric: contact holds it");
  check::is_true(free_rigid_modes(*problem.floating, {problem.all[2]}).empty(),
                 "axisymmetric: one node is enough");
  check::is_true(contains(free_rigid_modes(*problem.floating, {}), "axial motion of body 'upper'"),
                 "axisymmetric: axial motion");
  scene.pairs = {};
  check::is_true(contains(Problem(scene).check_loads(), "thrown"), "axisymmetric: nothing holds it");
  scene.conditions.pop_back();
  check::is_true(contains(Problem(scene).check_loads(), "axial motion of body 'upper'"),
                 "axisymmetric: nothing drives it");
}

// A frictionless ring in another may turn: one pin, whatever the small resistance of finite element circles.
void
check_ring()
{
  Scene scene = two_blocks();
  for (auto &body : scene.bodies)
    {
      body.shape       = "ring";
      body.refinements = 1;
    }
  scene.bodies[0].inner_radius    = 1;
  scene.bodies[0].radius          = 1.5;
  scene.bodies[1].inner_radius    = 0.6;
  scene.bodies[1].radius          = 1;
  scene.conditions                = {hold({"lower", "outer", {}})};
  scene.pairs[0].first.boundary   = "outer";
  scene.pairs[0].second->boundary = "inner";
  ConditionData pressure          = condition(ConditionData::Type::pressure, {"upper", "inner", {}});
  pressure.value[0]               = Expression(1.);
  scene.conditions.push_back(pressure);
  Problem problem(scene);
  check::is_true(!contains(problem.check_loads(), "thrown"),
                 "pressure does not turn a ring: " + problem.check_loads());
  problem.floating->choose_pins(problem.all);
  check::is_true(problem.floating->pins().size() == 1, "one pin holds the ring");
  check::is_true(free_rigid_modes(*problem.floating, problem.all).empty(), "and contact the rest");
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_sliding_block();
  check_guided_block();
  check_free_block();
  check_held_blocks();
  check_platen();
  check_axisymmetric();
  check_ring();
  return check::result();
}
} // namespace test_floating_bodies

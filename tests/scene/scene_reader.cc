// A realistic scene arrives in `Scene` as written, as .prm, as .json, with overrides, and from the printed
// template.
#include "check.h"

#include <amontons/scene/scene_reader.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

namespace test_scene_reader
{
using namespace Amontons;

namespace
{
  const std::string folder =
      (std::filesystem::temp_directory_path() / ("amontons_scene_reader_" + std::to_string(getpid())))
          .string();

  std::string
  write(const std::string &name, const std::string &text)
  {
    std::filesystem::create_directories(folder);
    const std::string file = folder + "/" + name;
    std::ofstream(file) << text;
    return file;
  }

  struct Newton : ParameterGroup
  {
    double tolerance = 1e-10;
    int    steps     = 20;
    bool   refuse    = false;

    void
    declare(dealii::ParameterHandler &prm) override
    {
      prm.enter_subsection("Contact solver"); // begins like a named section
      prm.add_parameter("Tolerance", tolerance, "Relative.", dealii::Patterns::Double(0));
      prm.enter_subsection("Line search");
      prm.add_parameter("Steps", steps, "At most.", dealii::Patterns::Integer(1));
      prm.leave_subsection();
      prm.enter_subsection("Damping"); // empty in JSON
      prm.declare_entry("Factor", "1", dealii::Patterns::Double());
      prm.leave_subsection();
      prm.leave_subsection();
    }
    void
    check() const override
    {
      if (tolerance >= 1)
        throw std::invalid_argument("Tolerance: found a number above 1; allowed 0 < tolerance < 1");
    }
  };

  const std::string materials = R"(
# defaults that the scene replaces
set Title = from the include
subsection Contact solver
  set Tolerance = 1e-6
  subsection Line search
    set Steps = 7
  end
end
)";

  const std::string scene_prm = R"(
include materials.prm
set Title      = Two blocks   # a comment
set Kind       = plane strain
set End time   = 2
set Increments = 8
set Minimum increment = 1e-3
set Output times      = 0.5, 1.25, 2

subsection Body lower
  set Mesh          = block
  set Lower corner  = -4, -2
  set Upper corner  = 4, 0
  set Cells         = 8, 4
  set Grading       = 1, 0.5
  set Young modulus = 210e3
  set Poisson ratio = 0.4999
  set Body force    = 0; -9.81*t
end

subsection Body upper
  set Mesh        = half disk
  set Centre      = 0, 3
  set Radius      = 3
  set Refinements = 2
  set Rotate      = 10
  set Young modulus = 1
  set Poisson ratio = 0.3
end

subsection Body punch
  set Mesh  = plate.msh
  set Rigid = true
  set Force = 0; -5*t
  set Rotation = free
  set Curved boundaries = arc = circle(1, 2, 9); \
                          # in between
                          inner = circle(0, 0)
end

subsection Obstacle floor
  set Surface = plane
  set Centre  = 0, -2
  set Normal  = 0, 2
end

subsection Boundary condition bottom
  set Boundaries = lower/bottom, lower/left
  set Value      = free; 0
end
subsection Boundary condition load
  set Boundaries   = upper/cut
  set Type         = platen
  set Displacement = table(0: 0, 1: 0.5, 2: -0.5); free
  set Force        = 0; -10*t
end
subsection Boundary condition field
  set Boundaries = lower/right
  set Value      = halfplane_elliptic(P = 1, a = 2*pi)
end
subsection Boundary condition wind
  set Boundaries = upper/arc
  set Type       = pressure
  set Value      = if(x < 1, 2*y, 3)
end

subsection Contact main
  set First       = lower/top
  set Second      = upper/arc
  set Initial gap = x^2/(2*3)
  set Adjust      = 1e-6
  set Friction coefficient = 0.3*exp(-p/2) + 0.1*table(0: 0, 0.75: 1, 1.5: table(1.6: 1, 1.75: x))
  set Tresca bound         = 5
end
subsection Contact punched
  set First  = punch/arc
  set Second = lower/right
end
subsection Contact ground
  set First  = lower/bottom
  set Second = floor
  set Tied   = true
end

subsection Probe middle
  set Body   = lower
  set From   = 0, -2
  set To     = 0, 0
  set Points = 21
end
subsection Reference
  set Solution = hertz_line(E = 210e3)
  set Contact  = main
end
)";

  // clang-format off
  const std::string scene_json = R"json({
  "Title": "Two blocks", "Kind": "plane strain", "End time": 2, "Increments": 8,
  "Minimum increment": 1e-3, "Output times": [0.5, 1.25, 2],
  "Contact solver": {"Tolerance": 1e-6, "Line search": {"Steps": 7}, "Damping": {}},
  "Body lower": {"Mesh": "block", "Lower corner": [-4, -2], "Upper corner": [4, 0], "Cells": [8, 4],
                 "Grading": [1, 0.5], "Young modulus": 210e3, "Poisson ratio": 0.4999,
                 "Body force": ["0", "-9.81*t"]},
  "Body upper": {"Mesh": "half disk", "Centre": [0, 3], "Radius": 3, "Refinements": 2, "Rotate": 10,
                 "Young modulus": 1, "Poisson ratio": 0.3},
  "Body punch": {"Mesh": "plate.msh", "Rigid": true, "Force": "0; -5*t", "Rotation": "free",
                 "Curved boundaries": "arc = circle(1, 2, 9); inner = circle(0, 0)"},
  "Obstacle floor": {"Surface": "plane", "Centre": "0, -2", "Normal": "0, 2"},
  "Boundary condition bottom": {"Boundaries": ["lower/bottom", "lower/left"], "Value": ["free", 0]},
  "Boundary condition load": {"Boundaries": "upper/cut", "Type": "platen",
                              "Displacement": ["table(0: 0, 1: 0.5, 2: -0.5)", "free"], "Force": [0, "-10*t"]},
  "Boundary condition field": {"Boundaries": "lower/right", "Value": "halfplane_elliptic(P = 1, a = 2*pi)"},
  "Boundary condition wind": {"Boundaries": "upper/arc", "Type": "pressure", "Value": "if(x < 1, 2*y, 3)"},
  "Contact main": {"First": "lower/top", "Second": "upper/arc", "Initial gap": "x^2/(2*3)", "Adjust": 1e-6,
                   "Friction coefficient": "0.3*exp(-p/2) + 0.1*table(0: 0, 0.75: 1, 1.5: table(1.6: 1, 1.75: x))", "Tresca bound": 5},
  "Contact punched": {"First": "punch/arc", "Second": "lower/right"},
  "Contact ground": {"First": "lower/bottom", "Second": "floor", "Tied": true},
  "Probe middle": {"Body": "lower", "From": [0, -2], "To": [0, 0], "Points": 21},
  "Reference": {"Solution": "hertz_line(E = 210e3)", "Contact": "main"}
})json";
  // clang-format on

  // Instead of closed forms: fields that bend at t = P, 2 and the end.
  const BoundaryFields fields = {{}, [](const FieldData &data, const double end_time) {
                                   return std::vector<double>({data.parameters.at("P"), 2, end_time});
                                 }};

  void
  check_bodies(const Scene &scene, const std::string &file)
  {
    const BodyData &lower = scene.bodies.at(0), &upper = scene.bodies.at(1), &punch = scene.bodies.at(2);
    check::is_true(lower.name == "lower" && lower.shape == "block", file + ": block");
    check::is_true(lower.lower == Point<3>(-4, -2, 0) && lower.upper == Point<3>(4, 0, 0),
                   file + ": corners");
    check::is_true(lower.cells[0] == 8 && lower.cells[1] == 4 && lower.grading[1] == 0.5, file + ": cells");
    check::is_true(lower.material.young == 210e3 && lower.material.poisson == 0.4999, file + ": material");
    check::is_close(lower.body_force[1].value(Point<3>(), 2), -19.62, 1e-14, file + ": body force");
    check::is_true(!lower.rigid && upper.shape == "half disk" && upper.radius == 3, file + ": half disk");
    check::is_true(upper.centre == Point<3>(0, 3, 0) && upper.refinements == 2, file + ": centre");
    check::is_true(upper.rotation_angle == 10 && upper.material.law == Law::neo_hookean, file + ": defaults");
    check::is_true(punch.shape == "file" && punch.mesh_file == folder + "/plate.msh", file + ": mesh file");
    check::is_true(punch.true_geometry.at("arc").centre == Point<3>(1, 2, 0), file + ": curved boundary");
    check::is_true(punch.true_geometry.at("inner").type == TrueGeometry::Type::circle, file + ": second one");
    check::is_true(punch.rigid && punch.rigid->name == "punch", file + ": rigid");
    check::is_true(punch.rigid->displacement[0]->is_zero() && !punch.rigid->displacement[1],
                   file + ": freed by force");
    check::is_true(!punch.rigid->rotation[2] && punch.rigid->rotation[0]->is_zero(),
                   file + ": free rotation");
  }

  void
  check_rest(const Scene &scene, const std::string &file)
  {
    const Point<3> p(2, 5, 0);
    check::is_true(scene.conditions.at(0).boundaries.at(1).boundary == "left", file + ": boundaries");
    check::is_true(!scene.conditions[0].displacement[0] && scene.conditions[0].displacement[1]->is_zero(),
                   file + ": free component");
    const MotionData &load = *scene.conditions.at(1).motion;
    check::is_true(load.name == "load" && !load.displacement[1] && load.rotation[2]->is_zero(),
                   file + ": platen");
    for (const auto &[t, u] :
         std::vector<std::pair<double, double>>{{-1, 0}, {0.5, 0.25}, {1, 0.5}, {1.5, 0}, {9, -0.5}})
      check::is_close(
          load.displacement[0]->value(p, t), u, 1e-14, file + ": table at " + std::to_string(t), 1);
    check::is_close(load.force[1].value(p, 2), -20, 1e-14, file + ": force");
    const FieldData &field = *scene.conditions.at(2).field;
    check::is_true(field.name == "halfplane_elliptic" && field.parameters.at("P") == 1,
                   file + ": closed form");
    check::is_close(field.parameters.at("a"), 2 * dealii::numbers::PI, 1e-14, file + ": parameter");
    check::is_close(
        scene.conditions.at(3).value[0].value(Point<3>(0, 5, 0), 0), 10, 1e-14, file + ": pressure");
    check::is_true(scene.obstacles.at(0).normal == Tensor<1, 3>({0, 1, 0}), file + ": normal of length one");

    const PairData &main = scene.pairs.at(0);
    check::is_true(main.second->body == "upper" && main.adjust == 1e-6 && !main.tied, file + ": pair");
    check::is_true(main.slave == PairData::Slave::automatic, file + ": automatic slave");
    check::is_close(main.initial_gap->value(p, 0), 4. / 6, 1e-14, file + ": gap");
    check::is_true(scene.pairs.at(1).slave == PairData::Slave::second, file + ": rigid bodies are masters");
    check::is_true(scene.pairs.at(2).obstacle == "floor" && scene.pairs[2].tied, file + ": obstacle");
    check::is_true(scene.pairs[2].slave == PairData::Slave::first, file + ": obstacles are masters");
    check::is_true(scene.probes.at(0).n_points == 21 && scene.probes[0].from == Point<3>(0, -2, 0),
                   file + ": probe");
    check::is_true(scene.reference->pair == "main" && scene.reference->solution.parameters.at("E") == 210e3,
                   file + ": reference");
  }

  void
  check_friction(const Scene &scene, const std::string &file)
  {
    check::is_true(scene.minimum_increment == 1e-3, file + ": smallest increment");
    check::is_true(scene.output_times == std::vector<double>({.5, 1.25, 2}), file + ": output times");
    check::is_true(scene.corner_times == std::vector<double>({.75, 1, 1.5, 1.6, 1.75}),
                   file + ": corners of all tables before the end time");
    const Expression &friction = *scene.pairs[0].friction;
    check::is_close(friction.value(Point<3>(), .75, 3), .3 * std::exp(-1.5) + .1, 1e-14, file + ": friction");
    check::is_close(friction.value(Point<3>(), 0, 3), .3 * std::exp(-1.5), 1e-14, file + ": friction at 0");
    check::is_close(friction.value(Point<3>(7, 0, 0), 2, 0), 1, 1e-14, file + ": friction at x");
    check::is_true(friction.corners() == std::vector<double>({0, .75, 1.5, 1.6, 1.75}), file + ": tables");
    check::is_close(scene.pairs[0].tresca_bound->value(Point<3>(), 0), 5, 1e-14, file + ": Tresca");
    check::is_true(!scene.pairs[1].friction && !scene.pairs[1].tresca_bound, file + ": frictionless");
  }

  void
  check_scene_of(const std::string &file)
  {
    Newton      newton;
    const Scene scene = read_scene(file, {}, {&newton}, fields);
    check::is_true(scene.title == "Two blocks" && scene.kind == ProblemType::plane_strain,
                   file + ": top level");
    check::is_true(scene.end_time == 2 && scene.n_increments == 8, file + ": time");
    check::is_true(newton.tolerance == 1e-6 && newton.steps == 7, file + ": groups");
    check_bodies(scene, file);
    check_rest(scene, file);
    check_friction(scene, file);
  }

  // The smallest valid scene with a contact, at any friction entries.
  Scene
  with_friction(const std::vector<std::string> &entries)
  {
    const std::string        file = write("friction.prm", R"(
set End time = 5
subsection Body block
  set Lower corner  = 0, 0
  set Upper corner  = 1, 1
  set Young modulus = 1
  set Poisson ratio = 0.3
end
subsection Obstacle floor
end
subsection Boundary condition side
  set Boundaries = block/left
  set Value      = halfplane_elliptic(P = 1, a = 1, y0 = 1, friction = 0.3, shear_ratio = 0.5)
end
subsection Contact base
  set First  = block/bottom
  set Second = floor
end
)");
    std::vector<std::string> overrides;
    for (const std::string &entry : entries)
      overrides.push_back("Contact base/" + entry);
    return read_scene(file, overrides, {}, fields);
  }

  void
  check_bounds()
  {
    const Scene none = with_friction({});
    check::is_true(!none.pairs[0].friction && !none.pairs[0].tresca_bound, "no friction by default");
    check::is_true(none.n_increments == 0 && none.minimum_increment == 1e-4 && none.output_times.empty(),
                   "automatic increments");
    check::is_true(none.corner_times == std::vector<double>({1, 2}), "corners of a field, before the end");
    for (const std::vector<std::string> &entries :
         std::vector<std::vector<std::string>>{{"Friction coefficient = 0"},
                                               {"Friction coefficient = 2-2"},
                                               {"Friction coefficient = 0", "Tresca bound = 3"},
                                               {"Friction coefficient = 0.2", "Tresca bound = 0"}})
      check::is_true(!with_friction(entries).pairs[0].friction &&
                         !with_friction(entries).pairs[0].tresca_bound,
                     "a bound that is zero: frictionless");
    const Scene tresca = with_friction({"Tresca bound = 1 + x*p*t"});
    check::is_true(!tresca.pairs[0].friction && !tresca.pairs[0].tresca_bound->is_constant(), "Tresca alone");
    check::is_close(
        tresca.pairs[0].tresca_bound->value(Point<3>(2, 0, 0), 3, 4), 25, 1e-14, "x, t and p together");
    check::is_close(
        tresca.pairs[0].tresca_bound->value(Point<3>(2, 0, 0), 1, 4), 9, 1e-14, "an earlier time again");
  }

  void
  check_overrides(const std::string &file)
  {
    Newton      newton;
    const Scene scene = read_scene(file,
                                   {"Increments = 3",
                                    "Body upper/Radius=1",
                                    "Body upper/Radius=2",
                                    "Contact solver/Line search/Steps = 4",
                                    "Contact main/Slave = second"},
                                   {&newton},
                                   fields);
    check::is_true(scene.n_increments == 3 && scene.bodies[1].radius == 2, "the last override counts");
    check::is_true(newton.steps == 4 && scene.pairs[0].slave == PairData::Slave::second,
                   "overrides of sections");
  }

  void
  check_template()
  {
    Newton             newton;
    std::ostringstream text;
    print_parameters(text, {&newton});
    const Scene scene = read_scene(write("template.prm", text.str()), {}, {&newton});
    check::is_true(scene.bodies.size() == 1 && scene.pairs.size() == 1 && scene.obstacles.size() == 1,
                   "the printed template is a scene");
    const Scene solid = read_scene(folder + "/template.prm",
                                   {"Kind = 3D",
                                    "Boundary condition TOP/Value = 0; free; table(0: x, 1: 2*x)",
                                    "Probe PROBE/Point = 1, 1, 1"},
                                   {&newton});
    check::is_close(
        solid.conditions[0].displacement[2]->value(Point<3>(1, 0, 0), 0.5), 1.5, 1e-14, "table of x");
    const Scene axisymmetric =
        read_scene(folder + "/template.prm",
                   {"Kind = axisymmetric", "Boundary condition TOP/Value = exp(-r)*2e0; x+y"},
                   {&newton});
    check::is_close(axisymmetric.conditions[0].displacement[0]->value(Point<3>(1, 0, 0), 0),
                    2 * std::exp(-1.),
                    1e-14,
                    "r stands for x, but not in exp or numbers");
  }
} // namespace

int
main(int, char **)
{
  write("materials.prm", materials);
  write("plate.msh", "");
  check_scene_of(write("scene.prm", scene_prm));
  check_scene_of(write("scene.json", scene_json));
  check_overrides(folder + "/scene.prm");
  check_template();
  check_bounds();
  std::filesystem::remove_all(folder);
  return check::result();
}
} // namespace test_scene_reader

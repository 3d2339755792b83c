// Every mistake in a scene is one InputError that names the place, what was found and what is allowed.
#include "check.h"

#include <amontons/scene/scene_reader.h>

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace test_wrong_scenes
{
using namespace Amontons;

namespace
{
  const std::string folder =
      (std::filesystem::temp_directory_path() / ("amontons_wrong_scenes_" + std::to_string(getpid())))
          .string();
  const std::string file = folder + "/scene.prm";

  const std::string good = R"(set Kind = plane strain
subsection Body lower
  set Lower corner = 0, 0
  set Upper corner = 1, 1
  set Young modulus = 1
  set Poisson ratio = 0.3
end
subsection Body upper
  set Lower corner = 0, 1
  set Upper corner = 1, 2
  set Young modulus = 1
  set Poisson ratio = 0.3
end
subsection Obstacle floor
end
subsection Boundary condition push
  set Boundaries = upper/top
  set Type = platen
  set Displacement = 0; free
end
subsection Boundary condition load
  set Boundaries = upper/left
  set Value = 0; 0
end
subsection Contact main
  set First = lower/top
  set Second = upper/bottom
end
)"; // 28 lines

  struct Tolerances : ParameterGroup
  {
    double newton = 0.1;
    void
    declare(dealii::ParameterHandler &prm) override
    {
      prm.enter_subsection("Newton");
      prm.add_parameter("Tolerance", newton, "Relative.", dealii::Patterns::Double(0));
      prm.leave_subsection();
    }
    void
    check() const override
    {
      if (newton > 1)
        throw std::invalid_argument("Tolerance: found 2; allowed less than 1");
    }
  };

  // The message of the error that the text (and overrides) lead to, "" if there is none.
  std::string
  message(const std::string              &text,
          const std::vector<std::string> &overrides = {},
          const std::string              &name      = file)
  {
    std::filesystem::create_directories(folder);
    std::ofstream(name) << text;
    Tolerances tolerances;
    try
      {
        read_scene(name, overrides, {&tolerances});
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
        return error.what();
      }
    return "";
  }

  void
  expect(const std::string &message, const std::vector<std::string> &parts)
  {
    check::is_true(message.find('\n') == std::string::npos, "one line: " + message);
    for (const std::string &part : parts)
      check::is_true(message.find(part) != std::string::npos, "'" + part + "' in '" + message + "'");
  }

  // With one override, what stands in the message.
  void
  expect_set(const std::string &setting, const std::vector<std::string> &parts)
  {
    expect(message(good, {setting}), parts);
  }

  void
  check_syntax()
  {
    expect(message(good + "subsection Probe p\n"), {"scene.prm:29: Probe p", "no 'end'"});
    expect(message(good + "end\n"), {"scene.prm:29", "no section is open"});
    expect(message(good + "Set a = 1\n"),
           {"scene.prm:29", "'Set a = 1'", "did you mean 'set'", "include FILE"});
    expect(message(good + "set End time 1\n"), {"scene.prm:29", "set NAME = VALUE"});
    expect(message(good + "subsection Body lower\nend\n"),
           {"scene.prm:29: Body lower", "second time", "line 2"});
    expect(message(good + "set Kind = 3D\n"), {"scene.prm:29: Kind", "second time", "line 1"});
    expect(message(good + "include nowhere.prm\n"), {"scene.prm:29", "nowhere.prm' cannot be opened"});
    expect(message(good + "set Title = a \\\n"), {"scene.prm:29", "continued line"});
    expect(message("{\"Kind\": \"3D\",\n oops}", {}, folder + "/scene.json"), {"scene.json:2", "no JSON"});
    expect(message("{\"Kind\": \"2D\"}", {}, folder + "/scene.json"),
           {"scene.json: Kind: found '2D'", "plane stress"});
    try
      {
        read_scene("/nowhere/scene.prm", {}, {});
        check::is_true(false, "a missing file is an error");
      }
    catch (const InputError &error)
      {
        expect(error.what(), {"/nowhere/scene.prm", "cannot be opened"});
      }
    expect(message("set Kind = 3D\n"), {"scene.prm", "no body", "Body NAME"});
  }

  void
  check_names()
  {
    expect(message(good + "subsection Bdy third\nend\n"),
           {"scene.prm:29",
            "unknown section 'Bdy third'",
            "did you mean 'Body third'",
            "Obstacle NAME",
            "Newton"});
    expect(message("include scene.prm\n" + good), {"include each other"});
    expect(message(good + "subsection Body a, b\nend\n"), {"scene.prm:29", "'a, b'", "without"});
    expect(message(good + "subsection Body   upper\nend\n"), {"scene.prm:29: Body upper", "second time"});
    expect(message(good + "subsection Body\nend\n"), {"scene.prm:29", "no name", "Body NAME"});
    expect(message(good + "subsection Newton\n  set Tolerence = 1\nend\n"),
           {"scene.prm:30: Newton/Tolerence", "did you mean 'Tolerance'"});
    expect_set("Body lower/Young modulis = 1",
               {"--set: Body lower/Young modulis", "did you mean 'Young modulus'"});
    expect_set("Body lowr/Radius = 1", {"--set", "unknown section 'Body lowr'", "did you mean 'Body lower'"});
    expect_set("Increments", {"--set", "Section/Name = value"});
    expect_set("Newton/Tolerance = 2", {"--set: Newton/Tolerance: found 2; allowed less than 1"});
    expect_set("Newton/Tolerance = big", {"found 'big'", "a number v >= 0"});
    expect_set("Kind = 2D", {"found '2D'", "one of plane strain, plane stress, axisymmetric, 3D"});
    expect_set("Increments = 0", {"found '0'", "automatic, or an integer n >= 1"});
    expect_set("Increments = 2.5", {"found '2.5'", "an integer n >= 1"});
    expect_set("Increments = auto", {"found 'auto'", "automatic"});
    expect_set("Minimum increment = 0", {"found 0", "positive"});
    expect_set("Minimum increment = 2", {"found 2", "fraction of the end time"});
    expect_set("Output times = 0, 1", {"found 0", "(0, End time]"});
    expect_set("Output times = 0.5, 2", {"found 2", "(0, End time]"});
    expect_set("Output times = 0.5, 0.5", {"found 0.5 after a later time", "increasing times"});
    expect_set("Output times = 0.5; 1", {"found '0.5; 1'", "numbers separated by commas"});
  }

  void
  check_bodies()
  {
    expect_set("Body lower/Mesh = half dsk", {"did you mean 'half disk'", ".msh"});
    expect_set("Body lower/Mesh = no.msh", {folder + "/no.msh", "no file"});
    expect_set("Body lower/Upper corner = 0, 1", {"larger coordinates"});
    expect_set("Body lower/Lower corner = 0", {"found '0', 1 number(s)", "2 numbers separated by commas"});
    expect_set("Body lower/Cells = 0, 1", {"found '0, 1'"});
    expect_set("Body lower/Poisson ratio = 0.5", {"Body lower/Poisson ratio", "fine up to 0.4999"});
    expect_set("Body lower/Poisson ratio = -1", {"more than -1"});
    expect_set("Body lower/Young modulus = 0", {"positive"});
    expect_set("Body lower/Radius = 2", {"Radius: this entry has no meaning for Mesh = block"});
    expect_set("Body lower/Force = 0; 1", {"Rigid = false"});
    expect_set("Body lower/Body force = 0", {"1 component(s)", "2 component(s) separated by ';'"});
    expect_set("Body lower/Body force = 0; q", {"Unexpected token \"q\"", "an expression of x, y, t"});
    expect_set("Body lower/Body force = 0; (x", {"parenthesis"});
    expect_set("Body lower/Body force = 0; r", {"variable r"});
    expect_set("Body lower/Body force = 0; table(0: 1, 0: 2)", {"increas"});
    expect_set("Body lower/Body force = 0; table(1)", {"time: value"});
    expect_set("Body lower/Body force = 0; 0.03table(0: 1, 1: 2)", {"right behind a number", "operator"});
    expect_set("Kind = 3D", {"3 numbers"});
    expect_set("Body lower/Young modulus = ", {"--set: Body lower/Young modulus: this entry is missing"});
    expect(message(good + "subsection Body b\n set Mesh = disk\nend\n"),
           {"scene.prm:29: Body b/Radius: this entry is missing", "for Mesh = disk"});
    expect(message(good + "subsection Body b\n set Mesh = disk\n set Radius = 1\nend\n"),
           {"scene.prm:29: Body b/Young modulus: this entry is missing", "for a deformable body"});
    check::is_true(
        message(good + "subsection Body b\n set Mesh = disk\n set Radius = 1\n set Rigid = true\nend\n")
            .empty(),
        "a rigid body has no material");
    expect(
        message(good + "subsection Body b\n set Mesh = ring\n set Inner radius = 2\n set Radius = 1\nend\n"),
        {"scene.prm:31: Body b/Inner radius", "less than the outer"});
    expect(
        message(good + "subsection Body b\n set Mesh = ring\n set Inner radius = 1\n set Radius = 1\nend\n"),
        {"scene.prm:31: Body b/Inner radius", "less than the outer"});
    // Radii are those after the shift.
    const auto shifted = [](const std::string &corners, const std::string &shift) {
      return message("set Kind = axisymmetric\nsubsection Body b\n set Lower corner = " + corners +
                     "\n set Shift = " + shift +
                     ", 0\n set Young modulus = 1\n set Poisson ratio = 0.3\nend\n");
    };
    check::is_true(shifted("-1, 0\n set Upper corner = 1, 1", "2").empty(), "shifted to radii from 1 on");
    check::is_true(shifted("-1, 0\n set Upper corner = 1, 1", "1").empty(), "shifted to the axis");
    expect(shifted("1, 0\n set Upper corner = 2, 1", "-2"),
           {"scene.prm:3: Body b/Lower corner", "found '1, 0'", "negative radius", "x >= 0"});
    expect(shifted("-1, 0\n set Upper corner = 1, 1", "0.5"), {"scene.prm:3", "negative radius"});
  }

  void
  check_motions_and_conditions()
  {
    expect_set("Boundary condition push/Force = 1; 1", {"push/Force", "Displacement prescribes '0'", "free"});
    expect_set("Boundary condition push/Displacement = 0", {"1 component(s)"});
    expect_set("Boundary condition push/Displacement = ; 0", {"component 0 is empty"});
    expect_set("Boundary condition push/Rotation = 0; 0; 1", {"1 component(s)"});
    expect(message(good, {"Kind = axisymmetric", "Boundary condition push/Displacement = free; 0"}),
           {"radial"});
    expect(message(good, {"Kind = axisymmetric", "Boundary condition push/Rotation = t"}), {"no rotation"});
    expect_set("Boundary condition push/Boundaries = top", {"found 'top'", "BODY/BOUNDARY"});
    expect_set("Boundary condition push/Boundaries = uper/top",
               {"unknown body 'uper'", "did you mean 'upper'"});
    expect_set("Boundary condition push/Boundaries = upper/top, upper/top", {"twice"});
    expect_set("Boundary condition push/Value = 1; 1", {"no meaning for Type = platen", "Displacement"});
    expect_set("Boundary condition load/Type = presure", {"found 'presure'", "pressure"});
    expect_set("Boundary condition load/Type = pressure", {"1 component(s)"});
    expect_set("Boundary condition load/Value = free; free", {"prescribes nothing"});
    expect_set("Boundary condition load/Value = hertz(a = x)", {"no constant"});
    expect_set("Boundary condition load/Displacement = 1; 1", {"use Value"});
    expect(message(good + "subsection Obstacle push\nend\n"), {"push' is taken by", "line 29"});
  }

  void
  check_pairs_and_probes()
  {
    expect_set("Contact main/Second = lower/top", {"slave = master"});
    expect_set("Contact main/Second = lower/left", {"self contact is not supported"});
    expect_set("Contact main/Second = flor",
               {"scene.prm:25", "unknown obstacle 'flor'", "did you mean 'floor'"});
    expect_set("Contact main/Second = upper", {"upper/BOUNDARY"});
    expect_set("Contact main/First = floor", {"BODY/BOUNDARY"});
    expect(message(good, {"Contact main/Second = floor", "Contact main/Slave = second"}),
           {"Slave = second", "obstacle"});
    expect(message(good, {"Body lower/Rigid = true", "Contact main/Second = floor"}), {"rigid"});
    expect(message(good, {"Body lower/Rigid = true", "Contact main/Slave = first"}), {"is rigid", "master"});
    expect(message(good, {"Body upper/Rigid = true"}), {"push", "the body 'upper' is rigid"});
    expect(
        message(good + "subsection Contact again\n set First = upper/bottom\n set Second = lower/top\nend\n"),
        {"scene.prm:29", "same two surfaces"});
    expect_set("Contact main/Adjust = -1", {"a number v >= 0"});
    expect_set("Contact main/Friction coefficient = -0.1",
               {"found -0.1, a negative bound", "the place, t and p"});
    expect_set("Contact main/Tresca bound = 1-3", {"found 1-3, a negative bound"});
    expect_set("Contact main/Friction coefficient = 0.3*q",
               {"main/Friction coefficient: '0.3*q' cannot be read: Unexpected token \"q\"",
                "x, y, t, p (contact pressure)"});
    for (const std::string comma : {"0,3", "(0,3)*t", "0.1*(t < 1 ? (1,2) : 3)"})
      expect_set("Contact main/Friction coefficient = " + comma,
                 {"'" + comma + "' has a comma that does not divide", "decimal point"});
    check::is_true(message(good, {"Contact main/Friction coefficient = max(0, min (0.3, t))"}).empty(),
                   "commas between arguments");
    expect_set("Contact main/Friction coefficient = r", {"variable r", "x, y, t, p (contact pressure)"});
    expect_set("Contact main/Initial gap = p", {"variable p", "expression of x, y, t,"});
    expect(message(good, {"Contact main/Tied = true", "Contact main/Friction coefficient = 0.1"}),
           {"no meaning for Tied = true"});
    expect(message(good, {"Contact main/Tied = true", "Contact main/Tresca bound = 1"}),
           {"no meaning for Tied = true"});
    expect(message(good + "subsection Probe p\n set Body = lower\nend\n"), {"scene.prm:29", "no place"});
    expect(message(good + "subsection Probe p\n set Body = x\n set Point = 0, 0\nend\n"),
           {"unknown body 'x'"});
    expect_set("Reference/Solution = hertz(a 1)", {"NAME(PARAMETER = NUMBER"});
    expect(message(good, {"Reference/Solution = hertz", "Reference/Contact = man"}), {"did you mean 'main'"});
  }
} // namespace

int
main(int, char **)
{
  check::is_true(message(good).empty(), "the good scene has no error");
  check_syntax();
  check_names();
  check_bodies();
  check_motions_and_conditions();
  check_pairs_and_probes();
  std::filesystem::remove_all(folder);
  return check::result();
}
} // namespace test_wrong_scenes

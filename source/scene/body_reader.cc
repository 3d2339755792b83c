#include <amontons/scene/section_readers.h>
#include <amontons/scene/scene_declarations.h>
#include <amontons/scene/text.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <filesystem>

namespace Amontons
{
  namespace
  {
    std::string
    ending_of(const std::string &file)
    {
      return std::filesystem::path(file).extension().string();
    }

    // The absolute name of the file that `entry` names relative to the scene.
    std::string
    existing_file(const SectionInput &section,
                  const std::string  &entry,
                  const std::string  &name,
                  const std::string  &what)
    {
      const auto folder = std::filesystem::absolute(section.scene_file()).parent_path();
      const auto file   = (folder / name).lexically_normal();
      if (!std::filesystem::is_regular_file(file))
        section.fail(entry,
                     "there is no file '" + file.string() + "'",
                     what + ", relative to the folder of the scene");
      return file.string();
    }

    bool
    is_among(const std::string &shape, const std::vector<std::string> &shapes)
    {
      return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
    }

    // A built-in shape, or "file" and the absolute name of an existing file.
    void
    read_mesh_name(const SectionInput &section, BodyData &body)
    {
      const std::string               mesh   = section.text("Mesh");
      const int                       dim    = section.dim();
      const std::vector<std::string> &shapes = built_in_shapes(dim);
      if (is_among(mesh, shapes))
        {
          section.refuse({"Part"}, "for Mesh = " + mesh);
          body.shape = mesh;
          return;
        }
      const std::string ending = ending_of(mesh);
      if (ending != ".msh" && ending != ".geo" && ending != ".inp")
        section.fail("Mesh",
                     "found '" + mesh + "'" +
                         (is_among(mesh, built_in_shapes(5 - dim))
                              ? ", a shape of scenes in " + std::to_string(5 - dim) + "D"
                              : suggestion(mesh, shapes)),
                     join(shapes, ", ") + ", or a file ending in .msh, .geo or .inp");
      body.shape     = "file";
      body.mesh_file = existing_file(section, "Mesh", mesh, "a mesh file");
      body.part      = section.text("Part");
    }

    void
    read_block(const SectionInput &section, BodyData &body)
    {
      body.lower                        = section.point("Lower corner");
      body.upper                        = section.point("Upper corner");
      const std::vector<double> cells   = section.numbers("Cells");
      const std::vector<double> grading = section.numbers("Grading");
      for (int i = 0; i < section.dim(); ++i)
        {
          body.cells[i]   = static_cast<unsigned int>(cells[i]);
          body.grading[i] = grading[i];
          if (!(body.lower[i] < body.upper[i]))
            section.fail("Upper corner",
                         "found '" + section.text("Upper corner") + "' with Lower corner = '" +
                             section.text("Lower corner") + "'",
                         "larger coordinates than those of the lower corner");
          if (!(grading[i] > 0))
            section.fail("Grading", "found '" + section.text("Grading") + "'", "positive numbers");
        }
      if (section.kind() == ProblemType::axisymmetric && body.rotation_angle == 0 &&
          body.lower[0] + body.shift[0] < 0)
        section.fail("Lower corner",
                     "found '" + section.text("Lower corner") + "', a negative radius",
                     "x >= 0 in axisymmetric scenes");
    }

    void
    read_shape(const SectionInput &section, BodyData &body)
    {
      const std::string context = "for Mesh = " + section.text("Mesh");
      const auto        is     = [&](const char *word) { return body.shape.find(word) != std::string::npos; };
      const bool        hollow = is("ring") || is("hollow");
      if (body.shape == "block")
        {
          section.require({"Lower corner", "Upper corner"}, context);
          read_block(section, body);
        }
      else
        section.refuse({"Lower corner", "Upper corner", "Cells", "Grading"}, context);
      if (body.shape != "block" && body.shape != "file")
        {
          section.require({"Radius"}, context);
          body.centre = section.point("Centre");
          body.radius = section.positive_number("Radius");
        }
      else
        section.refuse({"Centre", "Radius"}, context);
      if (hollow)
        {
          section.require({"Inner radius"}, context);
          body.inner_radius = section.positive_number("Inner radius");
          if (!(body.inner_radius < body.radius))
            section.fail("Inner radius",
                         "found " + section.text("Inner radius") + " with Radius = " + section.text("Radius"),
                         "less than the outer radius");
        }
      else
        section.refuse({"Inner radius"}, context);
      if (is("cylinder"))
        {
          section.require({"Length"}, context);
          body.length = section.positive_number("Length");
        }
      else
        section.refuse({"Length"}, context);
    }

    // cad(FILE[, scale])
    TrueGeometry
    read_cad_geometry(const SectionInput &section, const std::string &text, const Call &call)
    {
      const std::string allowed =
          "cad(FILE) or cad(FILE, SCALE) with a file ending in .step, .stp, .iges or .igs, "
          "in 3D; SCALE > 0 multiplies its lengths in mm";
      const std::string file = call.arguments.empty() ? "" : call.arguments[0];
      const auto        scale =
          call.arguments.size() == 2 ? as_number(call.arguments[1]) : std::optional<double>(1.);
      if (section.dim() != 3 || call.arguments.size() > 2 || !scale || !(*scale > 0) ||
          !is_among(boost::algorithm::to_lower_copy(ending_of(file)), {".step", ".stp", ".iges", ".igs"}))
        section.fail("Curved boundaries", "found '" + text + "'", allowed);
      TrueGeometry geometry;
      geometry.type  = TrueGeometry::Type::cad;
      geometry.file  = existing_file(section, "Curved boundaries", file, "a STEP or IGES file");
      geometry.scale = *scale;
      return geometry;
    }

    TrueGeometry
    read_true_geometry(const SectionInput &section, const std::string &text)
    {
      const std::string allowed =
          "circle(x, y), in 3D sphere(x, y, z), cylinder(x, y, z, ax, ay, az) or cad(FILE), as 'BOUNDARY = "
          "SHAPE; ...'";
      const auto call = as_call(text);
      if (call && call->name == "cad")
        return read_cad_geometry(section, text, *call);
      TrueGeometry        geometry;
      std::vector<double> numbers;
      if (call)
        for (const std::string &argument : call->arguments)
          if (const auto number = as_number(argument))
            numbers.push_back(*number);
      const std::size_t n    = numbers.size();
      const std::size_t dim  = section.dim();
      const bool        read = call && n == call->arguments.size();
      const bool round = read && (call->name == "circle" || call->name == "sphere") && n >= dim && n <= 3;
      const bool tube  = read && call->name == "cylinder" && n == 6 && dim == 3;
      if (!round && !tube)
        section.fail("Curved boundaries", "found '" + text + "'", allowed);
      geometry.type = round ? TrueGeometry::Type::circle : TrueGeometry::Type::cylinder;
      for (std::size_t i = 0; i < dim; ++i)
        geometry.centre[i] = numbers[i];
      for (std::size_t i = 0; tube && i < 3; ++i)
        geometry.axis[i] = numbers[3 + i];
      if (tube && !(geometry.axis.norm() > 0))
        section.fail("Curved boundaries", "found '" + text + "', an axis without a direction", allowed);
      if (tube)
        geometry.axis /= geometry.axis.norm();
      return geometry;
    }

    void
    read_curved_boundaries(const SectionInput &section, BodyData &body)
    {
      if (body.shape != "file")
        section.refuse({"Curved boundaries"},
                       "for Mesh = " + body.shape + ": built-in shapes know their geometry");
      for (const std::string &piece : split(section.text("Curved boundaries"), ';'))
        {
          const auto        equals = piece.find('=');
          const std::string name   = trim(piece.substr(0, equals));
          const std::string shape  = equals == std::string::npos ? piece : trim(piece.substr(equals + 1));
          if (!body.true_geometry.emplace(name, read_true_geometry(section, shape)).second)
            section.fail("Curved boundaries", "the boundary '" + name + "' stands here twice");
          if (equals == std::string::npos || name.empty())
            section.fail("Curved boundaries", "found '" + piece + "'", "BOUNDARY = SHAPE; ...");
        }
    }

    // Rigid bodies may have elastic constants (so that a switch of `Rigid` is one line), others must.
    MaterialData
    read_material(const SectionInput &section)
    {
      if (!section.flag("Rigid"))
        section.require({"Young modulus", "Poisson ratio"}, "for a deformable body");
      MaterialData material;
      if (section.is_given("Young modulus"))
        material.young = section.positive_number("Young modulus");
      if (section.is_given("Poisson ratio"))
        material.poisson = section.number("Poisson ratio");
      if (section.text("Law") != "neo-Hookean")
        material.law = Law::st_venant_kirchhoff;
      if (material.poisson >= 0.5)
        section.fail("Poisson ratio",
                     "found " + section.text("Poisson ratio"),
                     "less than 0.5; nearly incompressible bodies are fine up to 0.4999");
      if (material.poisson <= -1)
        section.fail(
            "Poisson ratio", "found " + section.text("Poisson ratio"), "more than -1, less than 0.5");
      return material;
    }
  } // namespace

  BodyData
  read_body(const SectionInput &section)
  {
    BodyData body;
    body.name           = section.name;
    body.where          = section.where();
    body.refinements    = static_cast<unsigned int>(section.number("Refinements"));
    body.rotation_angle = section.number("Rotate");
    if (section.dim() == 3)
      body.rotation_axis = section.direction("Rotation axis");
    body.rotation_centre = section.point("Rotation centre");
    body.shift           = section.point("Shift");
    read_mesh_name(section, body);
    read_shape(section, body);
    read_curved_boundaries(section, body);

    body.material   = read_material(section);
    body.body_force = section.expressions("Body force");
    if (section.flag("Rigid"))
      {
        section.refuse({"Body force"}, "for a rigid body: use Force");
        body.rigid = read_motion(section);
      }
    else
      section.refuse(motion_entries(), "for a deformable body (Rigid = false)");
    return body;
  }
} // namespace Amontons

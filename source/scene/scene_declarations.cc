#include <amontons/scene/scene_declarations.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // Entries without a default are empty here; their readers say what is missing (SectionInput::require).
    const Patterns::Anything anything;
    const Patterns::List     coordinates(Patterns::Double(), 2, 3, ",");

    void
    declare_motion(ParameterHandler &prm)
    {
      prm.declare_entry("Reference point",
                        "0, 0, 0",
                        coordinates,
                        "Motion: rotations are about this point and moments refer to it.");
      prm.declare_entry(
          "Displacement",
          "",
          anything,
          "Motion: 'ux; uy[; uz]', each an expression of t or 'free' (then Force drives it). Empty: held, "
          "except for components with a Force.");
      prm.declare_entry("Force",
                        "",
                        anything,
                        "Motion: 'fx; fy[; fz]', for free components (axisymmetric: for the full turn; "
                        "plane: per thickness).");
      prm.declare_entry(
          "Rotation",
          "",
          anything,
          "Motion: angle in radians, expression of t or 'free'; in 3D three of them. Empty: held. "
          "Axisymmetric: none.");
      prm.declare_entry(
          "Moment", "", anything, "Motion: 2D one moment, 3D 'mx; my; mz', for free rotations.");
    }

    void
    declare_mesh_file(ParameterHandler &prm)
    {
      prm.declare_entry(
          "Part",
          "",
          anything,
          "Mesh from a file with several bodies: the physical group of this one's cells (gmsh), "
          "or its element set, part or instance (Abaqus); empty: all cells of the file.");
      prm.declare_entry("Curved boundaries",
                        "",
                        anything,
                        "Mesh from a file: 'outer = circle(x, y[, z]); side = cylinder(x, y, z, ax, ay, "
                        "az); top = cad(FILE.step[, scale])': the true shape of boundaries, by centre (and "
                        "axis), or a STEP or IGES file beside the scene; in 3D, circle means sphere.");
    }

    void
    declare_mesh(ParameterHandler &prm)
    {
      prm.declare_entry(
          "Mesh",
          "block",
          anything,
          "block; in 2D [half | quarter] disk, ring; in 3D [half | quarter | eighth] sphere, hollow sphere, "
          "[half | quarter] cylinder, hollow cylinder; or a file .msh, .geo, .inp beside the scene.");
      prm.declare_entry(
          "Lower corner", "", anything, "Block: corner of smallest coordinates, 'x, y[, z]'; no default.");
      prm.declare_entry(
          "Upper corner", "", anything, "Block: corner of largest coordinates, 'x, y[, z]'; no default.");
      prm.declare_entry("Cells",
                        "1, 1, 1",
                        Patterns::List(Patterns::Integer(1), 2, 3, ","),
                        "Block: cells per direction before refinement.");
      prm.declare_entry("Grading",
                        "1, 1, 1",
                        Patterns::List(Patterns::Double(0), 2, 3, ","),
                        "Block: size of the last cell over that of the first, per direction.");
      prm.declare_entry(
          "Centre", "0, 0, 0", coordinates, "Round shapes: centre; cylinders: centre of the bottom.");
      prm.declare_entry("Radius", "", anything, "Round shapes: radius, outer radius; no default.");
      prm.declare_entry("Inner radius", "", anything, "Rings and hollow shapes: inner radius; no default.");
      prm.declare_entry("Length", "", anything, "Cylinders: length, along z before placement; no default.");
      prm.declare_entry(
          "Refinements", "0", Patterns::Integer(0, 20), "Uniform refinements before the first solve.");
      prm.declare_entry(
          "Rotate", "0", Patterns::Double(), "Placement: first rotate by this angle (degrees) ...");
      prm.declare_entry("Rotation axis", "0, 0, 1", coordinates, "... about this axis (3D) ...");
      prm.declare_entry("Rotation centre", "0, 0, 0", coordinates, "... through this point, ...");
      prm.declare_entry("Shift", "0, 0, 0", coordinates, "... then move by this vector.");
    }

    void
    declare_body(ParameterHandler &prm)
    {
      declare_mesh(prm);
      declare_mesh_file(prm);
      prm.declare_entry(
          "Young modulus", "", anything, "Young's modulus, positive; no default. Rigid bodies need none.");
      prm.declare_entry("Poisson ratio",
                        "",
                        anything,
                        "Poisson's ratio, between -1 and 0.5; no default. Rigid bodies need none.");
      prm.declare_entry("Law",
                        "neo-Hookean",
                        Patterns::Selection("neo-Hookean|St. Venant-Kirchhoff"),
                        "neo-Hookean | St. Venant-Kirchhoff. Finite strain only; small strain is linear "
                        "elastic. St. Venant-Kirchhoff: large rotations at small strain.");
      prm.declare_entry(
          "Body force", "", anything, "Force per volume, 'fx; fy[; fz]', expressions of x, y, z, t.");
      prm.declare_entry("Rigid",
                        "false",
                        Patterns::Bool(),
                        "A rigid body: all of it follows the motion below, which only rigid bodies have.");
      declare_motion(prm);
    }

    void
    declare_obstacle(ParameterHandler &prm)
    {
      prm.declare_entry(
          "Surface",
          "plane",
          Patterns::Selection("plane|circle|sphere|cylinder|paraboloid|cone"),
          "plane | circle | sphere | cylinder | paraboloid | cone: shape of the rigid surface.");
      prm.declare_entry(
          "Centre", "0, 0, 0", coordinates, "A point of the plane; centre; apex of paraboloid and cone.");
      prm.declare_entry("Normal",
                        "0, 1, 0",
                        coordinates,
                        "Plane, paraboloid, cone: normal at the centre, from the obstacle towards the body.");
      prm.declare_entry("Axis", "0, 0, 1", coordinates, "Cylinder: its axis.");
      prm.declare_entry(
          "Radius", "", anything, "Circle, sphere, cylinder; paraboloid: at the apex. No default.");
      prm.declare_entry(
          "Flank angle",
          "",
          anything,
          "Cone: angle in degrees between its surface and the plane normal to its axis; no default.");
      prm.declare_entry(
          "Half width",
          "0",
          Patterns::Double(0),
          "Plane, paraboloid, cone: the surface ends at this distance from the centre; 0: unbounded.");
      prm.declare_entry("Hollow", "false", Patterns::Bool(), "Circle, sphere, cylinder: the body is inside.");
      declare_motion(prm);
    }

    void
    declare_condition(ParameterHandler &prm)
    {
      prm.declare_entry("Boundaries", "", anything, "Where: 'BODY/BOUNDARY, BODY/BOUNDARY, ...'.");
      prm.declare_entry("Type",
                        "displacement",
                        Patterns::Selection("displacement|symmetry|traction|pressure|total force|platen"),
                        "displacement | symmetry | traction | pressure | total force | platen. symmetry: no "
                        "motion normal to the (plane) boundary; total force: spread as a uniform traction; "
                        "platen: the boundary moves as one rigid body, with the motion below.");
      prm.declare_entry(
          "Value",
          "",
          anything,
          "displacement: 'ux; uy[; uz]', each an expression or 'free', or a closed form NAME(PARAMETER = "
          "NUMBER, "
          "...); traction, total force (of t alone): 'fx; fy[; fz]'; pressure: one expression. Expressions "
          "of x, y, z, t, "
          "pi, and table(0: 0, 1: 5, ...), piecewise linear in t.");
      declare_motion(prm);
    }

    void
    declare_contact(ParameterHandler &prm)
    {
      prm.declare_entry("First", "", anything, "One side, BODY/BOUNDARY.");
      prm.declare_entry("Second",
                        "",
                        anything,
                        "The other side: BODY/BOUNDARY of another body, or the name of an obstacle.");
      prm.declare_entry("Slave",
                        "automatic",
                        Patterns::Selection("automatic|first|second"),
                        "automatic | first | second: which side carries the contact pressure; automatic: the "
                        "finer, softer one.");
      prm.declare_entry("Initial gap",
                        "",
                        anything,
                        "Expression of the slave's reference position and the time t that replaces the "
                        "geometric gap; empty: "
                        "geometric.");
      prm.declare_entry(
          "Adjust", "0", Patterns::Double(0), "Initial gaps and overlaps up to this size count as zero.");
      prm.declare_entry(
          "Tied", "false", Patterns::Bool(), "Glue the two surfaces: no opening and no sliding.");
      prm.declare_entry(
          "Friction coefficient",
          "",
          anything,
          "Coulomb friction: shear tractions are at most this times the pressure. A number or an "
          "expression of the slave's reference position x, y, z (axisymmetric: r), the time t "
          "and the contact pressure p. Empty or 0: frictionless.");
      prm.declare_entry(
          "Tresca bound",
          "",
          anything,
          "Shear tractions are at most this; the same variables. With both entries, the smaller "
          "of the two bounds holds. Empty: no such bound.");
    }

    void
    declare_probe(ParameterHandler &prm)
    {
      prm.declare_entry("Body", "", anything, "The body whose values are written.");
      prm.declare_entry(
          "Point", "", anything, "At this point 'x, y[, z]' of the reference configuration, or ...");
      prm.declare_entry("From", "", anything, "... along the line from here ...");
      prm.declare_entry("To", "", anything, "... to here ...");
      prm.declare_entry("Points", "11", Patterns::Integer(2, 100000), "... in this number of points.");
    }
  } // namespace

  const std::vector<NamedSection> &
  named_sections()
  {
    static const std::vector<NamedSection> sections = {{"Body", declare_body},
                                                       {"Obstacle", declare_obstacle},
                                                       {"Boundary condition", declare_condition},
                                                       {"Contact", declare_contact},
                                                       {"Probe", declare_probe}};
    return sections;
  }

  const NamedSection *
  find_named_section(const std::string &path)
  {
    for (const NamedSection &section : named_sections())
      if (path == section.prefix || path.rfind(section.prefix + " ", 0) == 0)
        return &section;
    return nullptr;
  }

  static void
  declare_model(ParameterHandler &prm)
  {
    prm.declare_entry(
        "Kinematics",
        "auto",
        Patterns::Selection("small strain|finite strain|auto"),
        "small strain | finite strain | auto. small strain: linear, with contact surfaces where "
        "they were at the start. finite strain: large deformation, rotation and sliding. auto: "
        "small strain, then finite strain if small strain leaves out more than the target error "
        "(or 1 %) and the answer would change by more than that.");
    prm.declare_entry(
        "Model",
        "automatic",
        Patterns::Selection("automatic|full"),
        "automatic | full. automatic: with a target error, bodies that are stiff enough for it become "
        "rigid, and friction that cannot matter is left out; notes say so.");
  }

  void
  declare_top_level(ParameterHandler &prm)
  {
    prm.declare_entry("Title", "", anything, "One line for reports.");
    prm.declare_entry(
        "Units",
        "",
        anything,
        "LENGTH, FORCE, as in 'mm, N': names for labels of the answer and the report; nothing is "
        "computed with them. Empty: no labels.");
    prm.declare_entry("Kind",
                      "plane strain",
                      Patterns::Selection("plane strain|plane stress|axisymmetric|3D"),
                      "plane strain | plane stress | axisymmetric | 3D. axisymmetric: x is the radius (r in "
                      "expressions) and y the axis; forces are for the full turn.");
    declare_model(prm);
    prm.declare_entry(
        "End time", "1", Patterns::Double(), "Loads are functions of a time t from 0 to this one.");
    prm.declare_entry("Increments",
                      "automatic",
                      anything,
                      "automatic, or the number of equal steps that the load program starts with; automatic: "
                      "one where nothing depends on the history (no friction), else ten for each straight "
                      "piece of the load path (fewer where a target error allows it). Steps follow the "
                      "number of iterations, are cut back on "
                      "failure, and end at all output times and corners of tables.");
    prm.declare_entry("Minimum increment",
                      "1e-4",
                      Patterns::Double(0),
                      "Smallest step, as a fraction of the end time: the run ends where that one fails.");
    prm.declare_entry("Output times",
                      "",
                      anything,
                      "Times 't1, t2, ...' from 0 to the end time, increasing, at which an increment ends.");
    prm.enter_subsection("Reference");
    prm.declare_entry("Solution",
                      "",
                      anything,
                      "A closed form to compare with, NAME(PARAMETER = NUMBER, ...); empty: none.");
    prm.declare_entry("Contact", "", anything, "The contact pair that it describes; empty: the first.");
    prm.leave_subsection();
  }

  const std::vector<std::string> &
  built_in_shapes(const int dim)
  {
    static const std::vector<std::string> plane = {
        "block", "disk", "half disk", "quarter disk", "ring", "half ring", "quarter ring"};
    static const std::vector<std::string> solid = {"block",
                                                   "sphere",
                                                   "half sphere",
                                                   "quarter sphere",
                                                   "eighth sphere",
                                                   "hollow sphere",
                                                   "half hollow sphere",
                                                   "quarter hollow sphere",
                                                   "eighth hollow sphere",
                                                   "cylinder",
                                                   "half cylinder",
                                                   "quarter cylinder",
                                                   "hollow cylinder",
                                                   "half hollow cylinder",
                                                   "quarter hollow cylinder"};
    return dim == 2 ? plane : solid;
  }

  const std::vector<std::string> &
  motion_entries()
  {
    static const std::vector<std::string> entries = {
        "Reference point", "Displacement", "Force", "Rotation", "Moment"};
    return entries;
  }
} // namespace Amontons

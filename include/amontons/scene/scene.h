// The scene as data: what the .prm says, checked. No mesh, no numerics. Units are the user's (consistent).
#pragma once

#include <amontons/base/input_error.h>
#include <amontons/scene/expression.h>
#include <amontons/scene/units.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Amontons
{
  using dealii::Point;
  using dealii::Tensor;

  // Points and vectors are always written with three components; in 2D the third is ignored.
  // Axisymmetric: x = r, y = z (axis of revolution x = 0).
  enum class ProblemType
  {
    plane_strain,
    plane_stress,
    axisymmetric,
    three_dimensional
  };

  enum class Kinematics
  {
    small_strain,
    finite_strain, // Updated Lagrangian, large sliding
    automatic      // small strain, repeated with finite strain if that would change the answer
  };

  inline int
  dimension_of(const ProblemType kind)
  {
    return kind == ProblemType::three_dimensional ? 3 : 2;
  }

  // Of finite strain; small strain is linear elastic.
  enum class Law
  {
    neo_hookean,
    st_venant_kirchhoff
  };

  struct MaterialData
  {
    double young   = 1;
    double poisson = 0.3;
    Law    law     = Law::neo_hookean;
  };

  // A curved boundary: circle (2D; sphere in 3D) about `centre`, cylinder about the axis (3D), or what a CAD
  // file says (3D).
  struct TrueGeometry
  {
    enum class Type
    {
      flat,
      circle, // in 3D: sphere
      cylinder,
      cad
    } type = Type::flat;
    Point<3>     centre;
    Tensor<1, 3> axis;       // cylinder only
    std::string  file  = {}; // CAD: absolute; its points have the body's placement still to come
    double       scale = 1;  // CAD: of its lengths in millimetres
  };

  // Rigid motion of an obstacle, a platen or a rigid body, about `reference`:
  // u(X) = U + theta x (X - reference). Component i is prescribed where displacement[i] is set, else it is
  // free and driven by force[i]; likewise rotations and moments (2D: only index 2, about z; axisymmetric:
  // none). Forces of axisymmetric scenes are for the full turn; of plane scenes per unit thickness.
  struct MotionData
  {
    std::string                              name;
    SourceLocation                           where;
    Point<3>                                 reference;
    std::array<std::optional<Expression>, 3> displacement;
    std::array<Expression, 3>                force;
    std::array<std::optional<Expression>, 3> rotation;
    std::array<Expression, 3>                moment;
  };

  struct BodyData
  {
    std::string    name;
    SourceLocation where;

    // A shape of built_in_shapes(), or "file". Before placement: the half disk is the part y <= 0, with
    // boundaries "arc" (curved) and "cut" (y = 0); quarter disk: x >= 0, y <= 0, boundaries "arc", "cut" (y =
    // 0), "axis" (x = 0); disk: "arc"; ring: "inner", "outer"; half ring y >= 0 and quarter ring x, y >= 0:
    // also "cut x" (on y = 0), "cut y" (on x = 0). block: "left", "right" (x), "bottom", "top" (y in 2D, z in
    // 3D), in 3D also "front", "back" (y). 3D: half sphere z <= 0, quarter sphere x >= 0, z <= 0, eighth
    // sphere x, y >= 0, z <= 0; cylinders stand on z = 0, half cylinder y <= 0, quarter cylinder x >= 0, y <=
    // 0. Boundaries are "surface" (hollow: "inner", "outer"), for cylinders "bottom", "top" (z = length), and
    // the cuts "plane x" (on x = 0), "plane y", "plane z".
    std::string                 shape = "block";
    std::string                 mesh_file;             // absolute
    std::string                 part;                  // of the file: a group or set of its cells; "": all
    Point<3>                    lower, upper;          // block
    std::array<unsigned int, 3> cells   = {{1, 1, 1}}; // block: cells per direction of the coarse mesh
    std::array<double, 3>       grading = {{1, 1, 1}}; // block: ratio of last to first cell, per direction
    Point<3>                    centre;                // round shapes; cylinders: of the bottom
    double                      radius       = 1;      // round shapes: (outer) radius
    double                      inner_radius = 0.5;    // rings, hollow shapes
    double                      length       = 1;      // cylinders
    unsigned int                refinements  = 0;      // uniform, before the first solve
    // Placement: first rotate (degrees, about `rotation_axis` through `rotation_centre`), then shift.
    double       rotation_angle = 0;
    Tensor<1, 3> rotation_axis  = Tensor<1, 3>({0, 0, 1});
    Point<3>     rotation_centre;
    Tensor<1, 3> shift;

    MaterialData              material;
    std::array<Expression, 3> body_force; // per volume

    std::map<std::string, TrueGeometry>
                              true_geometry; // boundary name -> curved geometry, for meshes from files
    std::optional<MotionData> rigid; // a rigid body (a meshed obstacle): all of it follows this motion
  };

  struct BoundaryName
  {
    std::string              body, boundary;
    SourceLocation           where;
    std::vector<std::string> more = {}; // contact surfaces may go on over further boundaries of the same body
  };

  // A closed form, by name and parameters.
  struct FieldData
  {
    std::string                   name;
    std::map<std::string, double> parameters;
    SourceLocation                where;
  };

  using DisplacementField = std::function<Tensor<1, 3>(const Point<3> &, const double t)>;

  // The displacement fields that a scene may name as boundary values. The program has none of its own:
  // whoever reads a scene that names some hands them over (see read_scene).
  struct BoundaryFields
  {
    // For a body of this material. Throws InputError at data.where.
    std::function<DisplacementField(
        const FieldData &data, const MaterialData &material, const ProblemType kind)>
        displacement;
    // The times up to `end_time` at which the field bends.
    std::function<std::vector<double>(const FieldData &data, const double end_time)> corner_times;
  };

  struct ConditionData
  {
    enum class Type
    {
      displacement, // `displacement` by component (unset: free), or `field`
      symmetry,     // the plane boundary stays in its plane: u.n = 0
      traction,     // `value` per area, by component
      pressure,     // value[0], positive in compression
      total_force,  // `value` by component, spread as a uniform traction
      platen        // the boundary moves as one rigid body: `motion`
    } type = Type::displacement;
    std::string                              name;
    SourceLocation                           where;
    std::vector<BoundaryName>                boundaries;
    std::array<std::optional<Expression>, 3> displacement;
    std::optional<FieldData>                 field;
    std::array<Expression, 3>                value;
    std::optional<MotionData>                motion;
  };

  // An analytic rigid surface; the body lies outside of it: `normal` points from the obstacle to the body.
  struct ObstacleData
  {
    std::string    name;
    SourceLocation where;
    enum class Type
    {
      plane,      // through `centre`, with outward `normal`
      sphere,     // 2D: circle; with `radius` about `centre`; `hollow`: the body is inside
      cylinder,   // 3D: about `axis` through `centre` (2D: a circle)
      paraboloid, // apex `centre`, apex normal `normal`: height = -r^2/(2 radius) along the normal
      cone // apex `centre`, apex normal `normal`, `flank` = angle (degrees) between the surface and the plane
    } type = Type::plane;
    Point<3>     centre;
    Tensor<1, 3> normal = Tensor<1, 3>({0, 1, 0});
    Tensor<1, 3> axis   = Tensor<1, 3>({0, 0, 1});
    double       radius = 1;
    double       flank  = 5;
    double       size =
        0; // half-extent of the surface from `centre` normal to `normal` (sharp punch); 0: unbounded
    bool       hollow = false;
    MotionData motion;
  };

  struct PairData
  {
    std::string                 name;
    SourceLocation              where;
    BoundaryName                first;    // always a boundary of a body
    std::optional<BoundaryName> second;   // a boundary of another body, or
    std::string                 obstacle; // the name of an obstacle
    // Which of the two carries the multiplier; automatic: the finer, softer side. Obstacles and rigid bodies
    // are masters.
    enum class Slave
    {
      automatic,
      first,
      second
    } slave = Slave::automatic;
    std::optional<Expression>
           initial_gap; // replaces the geometric gap; function of the slave's reference position
    double adjust = 0;  // geometric gaps of at most this size (either sign) count as zero
    bool   tied   = false;
    // Shear tractions are at most min(friction p, tresca_bound), each if given: functions of the slave's
    // reference position, t and the pressure p. Neither: frictionless.
    std::optional<Expression> friction, tresca_bound;

    bool
    has_friction() const
    {
      return friction || tresca_bound;
    }
    bool
    bound_depends_on_place() const
    {
      return (friction && friction->depends_on_place()) || (tresca_bound && tresca_bound->depends_on_place());
    }
  };

  // Values at a point, or at n points of a line, of a body.
  struct ProbeData
  {
    std::string    name;
    SourceLocation where;
    std::string    body;
    Point<3>       from, to;
    unsigned int   n_points = 1;
  };

  // A closed form that the answer is compared with.
  struct ReferenceData
  {
    FieldData   solution;
    std::string pair; // the contact pair it describes; empty: the first
  };

  struct Scene
  {
    std::string              title;
    std::string              file; // path as given
    Units                    units;
    ProblemType              kind       = ProblemType::plane_strain;
    Kinematics               kinematics = Kinematics::small_strain;
    std::vector<std::string> entries; // "Section/Name = value" of all that the answer depends on
    std::vector<std::string> notes;   // for the user, of what the scene says
    bool                     full_model        = false; // nothing is left out, see model_reduction.h
    double                   end_time          = 1;
    unsigned int             n_increments      = 0;    // to start with, over the end time; 0: automatic
    double                   minimum_increment = 1e-4; // of the end time
    std::vector<double>      output_times;             // increasing, in (0, end_time]
    std::vector<double>      corner_times; // in (0, end_time): where loads and motions turn, bend or jump
    // How far loads and motions have come, from 0 to 1, by equidistant times from 0 to the end: the mean of
    // what each has varied by, but for jumps, and a tenth of the time. Empty: not looked at.
    std::vector<double>          load_progress;
    bool                         is_loaded_at_start = false; // some load or motion is not zero at t = 0
    std::vector<BodyData>        bodies;
    std::vector<ObstacleData>    obstacles;
    std::vector<ConditionData>   conditions;
    std::vector<PairData>        pairs;
    std::vector<ProbeData>       probes;
    std::optional<ReferenceData> reference;
    BoundaryFields               boundary_fields; // of `conditions`

    // Meshes and CAD surfaces, absolute.
    std::set<std::string>
    files() const;

    // The answer depends on the path of the load.
    bool
    has_friction() const
    {
      return std::any_of(
          pairs.begin(), pairs.end(), [](const PairData &pair) { return pair.has_friction(); });
    }
  };
} // namespace Amontons

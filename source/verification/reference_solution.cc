#include <amontons/verification/half_body_loading.h>
#include <amontons/verification/half_plane_field.h>
#include <amontons/verification/half_space_field.h>
#include <amontons/verification/reference_builders.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Amontons
{
  namespace
  {
    const double unset = std::numeric_limits<double>::quiet_NaN();

    struct Form
    {
      ClosedFormDeclaration declaration;
      ReferenceSolution (*build)(const ClosedFormArguments &, const Scene &);
    };

    const std::vector<Form> &
    forms()
    {
      namespace R                          = ReferenceBuilders;
      static const std::vector<Form> table = {
          {{"hertz_line",
            "line contact; load P per thickness, effective radius R, without E2 and nu2 the second body is "
            "rigid",
            {"P", "R", "E1", "nu1"},
            {{"E2", unset}, {"nu2", unset}, {"x", 0}, {"y", 0}}},
           R::hertz_line},
          {{"hertz_point",
            "point contact of circular shape; load P of the full turn",
            {"P", "R", "E1", "nu1"},
            {{"E2", unset}, {"nu2", unset}, {"x", 0}, {"y", 0}, {"z", 0}}},
           R::hertz_point},
          {{"hertz_elliptic",
            "elliptic point contact in a plane normal to z (3D); principal radii of the two bodies, those of "
            "body 1 along x "
            "and y, those of body 2 turned by `angle` (degrees) about z; left out: plane, negative: concave",
            {"P", "E1", "nu1"},
            {{"R1x", unset},
             {"R1y", unset},
             {"R2x", unset},
             {"R2y", unset},
             {"angle", 0},
             {"E2", unset},
             {"nu2", unset},
             {"x", 0},
             {"y", 0},
             {"z", 0}}},
           R::hertz_elliptic},
          {{"half_space_box",
            "hertz_point of radius a, with displacements and stresses; the lower body (E1, nu1) ends at z "
            "(axisymmetric: y) from below, the upper one from above; with friction as half_plane_box, in 3D "
            "(Mindlin, exact for nu = 0; no stresses); the sides need halfspace_hertz with the same",
            {"a", "R", "E1", "nu1"},
            {{"E2", unset},
             {"nu2", unset},
             {"friction", unset},
             {"shear_ratio", 0},
             {"x", 0},
             {"y", 0},
             {"z", 0}}},
           R::half_space_box},
          {{"half_plane_box",
            "hertz_line of half-width a, with displacements and stresses; the lower body (E1, nu1) ends at y "
            "from below, the upper one from above. With friction (equal bodies): P grows until t = 1, then "
            "the "
            "shear force is shear_ratio friction P at t = 2, the opposite at t = 3, the same again at t = 4, "
            "..., linear in between, on the lower body in +x; the sides need halfplane_elliptic with the "
            "same "
            "friction and shear_ratio",
            {"a", "R", "E1", "nu1"},
            {{"E2", unset}, {"nu2", unset}, {"friction", unset}, {"shear_ratio", 0}, {"x", 0}, {"y", 0}}},
           R::half_plane_box},
          {{"cattaneo_mindlin",
            "hertz_line with friction and a shear force Q (on the slave, in +x) after the normal one: first "
            "loading, or with Q_max on the way from Q_max to -Q_max (reversals odd; default 1) or back "
            "(even); "
            "dissipation from the beginning; exact for elastically similar bodies",
            {"P", "R", "E1", "nu1", "friction", "Q"},
            {{"Q_max", unset}, {"reversals", unset}, {"E2", unset}, {"nu2", unset}, {"x", 0}, {"y", 0}}},
           R::cattaneo_mindlin},
          {{"mindlin_sphere",
            "hertz_point with friction and a shear force Q, as in cattaneo_mindlin; without slip across the "
            "force, which is exact for nu = 0",
            {"P", "R", "E1", "nu1", "friction", "Q"},
            {{"Q_max", unset},
             {"reversals", unset},
             {"E2", unset},
             {"nu2", unset},
             {"x", 0},
             {"y", 0},
             {"z", 0}}},
           R::mindlin_sphere},
          {{"flat_punch_line",
            "sharp rigid punch of half-width a, load P per thickness; compared up to 0.9 a",
            {"P", "a"},
            {{"x", 0}, {"y", 0}}},
           R::flat_punch_line},
          {{"flat_punch_axisymmetric",
            "sharp rigid punch of radius a, pressed in by delta; compared up to 0.9 a",
            {"a", "delta", "E", "nu"},
            {{"x", 0}, {"y", 0}, {"z", 0}}},
           R::flat_punch_axisymmetric},
          {{"cone",
            "rigid cone whose flank makes the angle `flank` (degrees) with the surface",
            {"P", "flank", "E", "nu"},
            {{"x", 0}, {"y", 0}, {"z", 0}}},
           R::cone},
          {{"uniform",
            "uniform pressure p, compared up to the distance `width` from the centre (patch tests)",
            {"p", "width"},
            {{"x", 0}, {"y", 0}, {"z", 0}}},
           R::uniform},
          {{"two_block_patch",
            "uniform pressure of two stacked blocks of heights h1 and h2, shortened by delta; confined = 1: "
            "no lateral "
            "strain",
            {"E1", "nu1", "h1", "E2", "nu2", "h2", "delta", "width"},
            {{"confined", 0}, {"x", 0}, {"y", 0}, {"z", 0}}},
           R::two_block_patch},
          {{"shrink_fit_cylinders",
            "tubes ri < rc (Ei, nui) and rc < ro (Eo, nuo) with the radial interference delta; plane strain, "
            "or plane stress (free ends) if plane_stress = 1 or the scene is",
            {"ri", "rc", "ro", "Ei", "nui", "Eo", "nuo", "delta"},
            {{"plane_stress", unset}, {"width", unset}, {"x", 0}, {"y", 0}, {"z", 0}}},
           R::shrink_fit_cylinders},
          {{"shrink_fit_spheres",
            "spherical shells ri < rc (Ei, nui) and rc < ro (Eo, nuo) with the radial interference delta",
            {"ri", "rc", "ro", "Ei", "nui", "Eo", "nuo", "delta"},
            {{"width", unset}, {"x", 0}, {"y", 0}, {"z", 0}}},
           R::shrink_fit_spheres},
          {{"tubes_external_pressure",
            "outer tube R1 > R2 (E1, nu1) around an inner one R2 > R3 (E2, nu2) under the pressure p on R1",
            {"p", "E1", "nu1", "R1", "E2", "nu2", "R2", "R3"},
            {{"plane_stress", unset}, {"width", unset}, {"x", 0}, {"y", 0}, {"z", 0}}},
           R::tubes_external_pressure},
      };
      return table;
    }

    const ClosedFormDeclaration &
    half_plane_elliptic()
    {
      static const ClosedFormDeclaration declaration = {
          "halfplane_elliptic",
          "boundary values: displacement of a half plane under Hertz's pressure of resultant P and "
          "half-width a about "
          "(x0, y0), where it is zero; side = -1: body below y0, +1: above; Q: shear force on this body in "
          "+x with the stick half-width c (Cattaneo; c = 0: sliding). With friction: at time t of the load "
          "program of half_plane_box",
          {"P", "a"},
          {{"x0", 0},
           {"y0", 0},
           {"side", -1},
           {"Q", 0},
           {"c", 0},
           {"friction", unset},
           {"shear_ratio", 0},
           {"plane_stress", 0}}};
      return declaration;
    }

    const ClosedFormDeclaration &
    half_space_hertz()
    {
      static const ClosedFormDeclaration declaration = {
          "halfspace_hertz",
          "boundary values: displacement of a half space under Hertz's pressure of resultant P and radius a "
          "about "
          "(x0, y0, z0), where it is zero; its surface is normal to z (axisymmetric: y); side = -1: body "
          "below it, +1: above. With friction: at time t of the load program of half_space_box",
          {"P", "a"},
          {{"x0", 0}, {"y0", 0}, {"z0", 0}, {"side", -1}, {"friction", unset}, {"shear_ratio", 0}}};
      return declaration;
    }

    int
    side(const ClosedFormArguments &get)
    {
      if (std::abs(get("side")) != 1)
        get.fail("the side is neither -1 nor 1",
                 "side = -1 (the body is below the surface) or side = 1 (above)");
      return get("side") < 0 ? -1 : 1;
    }

    // Cattaneo's ellipses of half-widths a and c < a, with the resultants Q/(1-(c/a)^2) and -Q
    // (c/a)^2/(1-(c/a)^2).
    std::vector<ClosedForms::EllipticTraction>
    constant_shear(const ClosedFormArguments &get)
    {
      const double Q = get("Q"), c = get("c"), a = get("a"), square = c * c / (a * a);
      if (!(c >= 0 && c < a))
        get.fail("the stick half-width c is not in [0, a)", "0 <= c < a");
      std::vector<ClosedForms::EllipticTraction> shear;
      if (Q != 0)
        shear.push_back({Q / (1 - square), a, 0});
      if (Q != 0 && c > 0)
        shear.push_back({-Q * square / (1 - square), c, 0});
      if (Q != 0 && get.is_given("friction"))
        get.fail("found Q and friction",
                 "Q (and c) for a constant field, friction and shear_ratio for a load program");
      return shear;
    }

    HalfBodyLoading<HalfPlaneField>
    half_plane_field(const ClosedFormArguments &get, const MaterialData &material)
    {
      HalfPlaneField field;
      field.material     = material;
      field.force        = get("P");
      field.size         = get("a");
      field.shear        = constant_shear(get);
      field.centre       = Point<3>(get("x0"), get("y0"), 0);
      field.side         = side(get);
      field.plane_stress = get("plane_stress") != 0;
      return read_loading(get, field);
    }

    HalfBodyLoading<HalfSpaceField>
    half_space_field(const ClosedFormArguments &get, const MaterialData &material, const ProblemType kind)
    {
      HalfSpaceField field;
      field.material = material;
      field.force    = get("P");
      field.size     = get("a");
      field.centre   = Point<3>(get("x0"), get("y0"), get("z0"));
      field.side     = side(get);
      field.axis     = normal_axis(kind);
      if (field.axis != 2 && get("shear_ratio") != 0)
        get.fail("found a shear force", "shear_ratio = 0 in axisymmetric scenes");
      return read_loading(get, field);
    }

    [[noreturn]] void
    refuse_unknown(const FieldData &data, const std::vector<std::string> &names)
    {
      std::string allowed;
      for (const std::string &name : names)
        allowed += (allowed.empty() ? "" : ", ") + name;
      throw InputError(
          data.where, "found the closed form '" + data.name + "'" + suggestion(data.name, names), allowed);
    }
  } // namespace

  ReferenceSolution
  make_reference_solution(const FieldData &data, const Scene &scene)
  {
    std::vector<std::string> names;
    for (const Form &form : forms())
      {
        if (form.declaration.name == data.name)
          return form.build(ClosedFormArguments(data, form.declaration), scene);
        names.push_back(form.declaration.name);
      }
    refuse_unknown(data, names);
  }

  void
  refuse_points_in_plane(const FieldData &data, const ProblemType kind)
  {
    static const std::set<std::string> of_points = {"cone",
                                                    "flat_punch_axisymmetric",
                                                    "half_space_box",
                                                    "hertz_elliptic",
                                                    "hertz_point",
                                                    "mindlin_sphere",
                                                    "shrink_fit_spheres"};
    if ((kind == ProblemType::plane_strain || kind == ProblemType::plane_stress) &&
        of_points.count(data.name) > 0)
      throw InputError(data.where,
                       "found '" + data.name +
                           "', of a contact in a point or between balls, in a plane scene",
                       "it in 3D and axisymmetric scenes");
  }

  DisplacementField
  make_displacement_field(const FieldData &data, const MaterialData &material, const ProblemType kind)
  {
    if (data.name == half_space_hertz().name)
      {
        const auto loading = half_space_field({data, half_space_hertz()}, material, kind);
        return [loading](const Point<3> &p, const double t) { return loading.at(t).displacement(p); };
      }
    if (data.name == half_plane_elliptic().name)
      {
        const auto loading = half_plane_field({data, half_plane_elliptic()}, material);
        return [loading](const Point<3> &p, const double t) { return loading.at(t).displacement(p); };
      }
    refuse_unknown(data, {half_plane_elliptic().name, half_space_hertz().name});
  }

  std::vector<double>
  displacement_field_corners(const FieldData &data, const double end_time)
  {
    std::vector<double> corners;
    const auto          ratio = data.parameters.find("shear_ratio");
    const bool          shear = ratio != data.parameters.end() && ratio->second != 0;
    const double        last  = std::min(end_time, shear ? 1e4 : 1.);
    for (double t = 1; data.parameters.count("friction") > 0 && t <= last; ++t)
      corners.push_back(t);
    return corners;
  }

  std::vector<std::pair<std::string, std::string>>
  reference_solution_names()
  {
    std::vector<std::pair<std::string, std::string>> names;
    for (const Form &form : forms())
      names.emplace_back(form.declaration.signature(), form.declaration.meaning);
    for (const auto &field : {half_plane_elliptic(), half_space_hertz()})
      names.emplace_back(field.signature(), field.meaning);
    return names;
  }
} // namespace Amontons

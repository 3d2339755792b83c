// Closed-form solutions that the program is verified against; some also give displacements to impose on a
// boundary.
#pragma once

#include <amontons/scene/scene.h>

#include <deal.II/base/symmetric_tensor.h>

#include <functional>
#include <memory>
#include <optional>

namespace Amontons
{
  // What a closed form knows at the scene's end time; an unset member is not known. Lengths and pressures in
  // the scene's units.
  struct ReferenceSolution
  {
    std::optional<double> normal_force;  // total, as reported for the full problem (full turn, full width)
    std::optional<double> contact_size;  // half-width or radius a
    std::optional<double> peak_pressure; // p0
    std::optional<double> approach;
    // a^2 / <r^2> of the pressure, <r^2> = int p r^2 / int p: 4 for Hertz lines, 2.5 for Hertz points
    std::optional<double> size_factor;
    // pressure at distance r from the centre of the contact, and the interval of r over which L2 errors are
    // taken
    std::function<double(double)> pressure;
    double                        pressure_range = 0;
    // Friction: tangential force on the slave along +x, half-width or radius of the stick region, shear
    // traction on the slave along +x at distance x from the centre (for the axis through the contact along
    // the force), and the dissipated work of the whole load history.
    std::optional<double> tangential_force, stick_size, dissipation;
    // Whether mu p - |q| is a Hertz traction of the size stick_size, from which the size is measured.
    bool                          unused_shear_is_hertzian = true;
    std::function<double(double)> shear_traction;
    // Elliptic contact: contact_size is the semi-axis along axes[0], second_size that along axes[1] (unit
    // vectors in the plane of contact), and the pressure is a function of the position relative to the
    // centre.
    struct Ellipse
    {
      double                                              second_size;
      std::array<dealii::Tensor<1, 3>, 2>                 axes;
      std::function<double(const dealii::Tensor<1, 3> &)> pressure;
    };
    std::optional<Ellipse> ellipse;
    // position of the contact centre (reference configuration); r is measured from it
    dealii::Point<3> centre;
    // displacement and stress of one body (by name) where the field is known
    std::function<dealii::Tensor<1, 3>(const std::string &body, const dealii::Point<3> &)> displacement;
    std::function<dealii::SymmetricTensor<2, 3>(const std::string &body, const dealii::Point<3> &)> stress;
  };

  // Builds the closed form `data.name`; throws InputError at data.where for an unknown name or a missing
  // parameter.
  ReferenceSolution
  make_reference_solution(const FieldData &data, const Scene &scene);

  // Throws InputError for contacts in points, which no plane scene has.
  void
  refuse_points_in_plane(const FieldData &data, const ProblemType kind);

  // Displacement field `data` for a body of the given material, to be imposed as boundary values at time t.
  // The kind says which axis is normal to the surface of a half space. A field without friction does not
  // depend on t.
  DisplacementField
  make_displacement_field(const FieldData    &data,
                          const MaterialData &material,
                          const ProblemType   kind = ProblemType::three_dimensional);

  // The times up to `end_time` at which such a field bends; none for a field that does not depend on t.
  std::vector<double>
  displacement_field_corners(const FieldData &data, const double end_time);

  // Names of all closed forms with their parameters and meanings, for --parameters and messages.
  std::vector<std::pair<std::string, std::string>>
  reference_solution_names();
} // namespace Amontons

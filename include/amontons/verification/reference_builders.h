// One function per closed form: from its checked arguments to a ReferenceSolution. The table of
// reference_solution.cc says which parameters each of them reads.
#pragma once

#include <amontons/verification/closed_form_arguments.h>
#include <amontons/verification/closed_forms_friction.h>
#include <amontons/verification/reference_solution.h>

namespace Amontons
{
  // E* of (E1, nu1) and (E2, nu2); a body without them is rigid. Plane stress by the kind of the scene.
  double
  contact_modulus(const ClosedFormArguments &get, const Scene &scene);

  ReferenceSolution
  hertz_solution(const ClosedFormArguments &get, const ClosedForms::Hertz &hertz);

  // From the pressure of `s`: shear force, stick size and shear traction of this history.
  void
  set_shear(const ClosedForms::ShearHistory &history,
            const ClosedForms::ContactShape  shape,
            const double                     mu,
            ReferenceSolution               &s);

  // The same for two halves (HalfPlaneField, HalfSpaceField), of this history on the lower body: the shear is
  // that on the slave in +x, where Slave = automatic stands for the lower body. Throws InputError for bodies
  // that are not elastically similar.
  template <typename Field>
  void
  set_shear_of_halves(const ClosedFormArguments           &get,
                      const Scene                         &scene,
                      ClosedForms::ShearHistory            history,
                      const Field                         &lower,
                      ReferenceSolution                   &s,
                      const std::function<double(double)> &cost_of_cycle);
  // (2-nu1)/G1 + (2-nu2)/G2
  double
  mindlin_compliance(const ClosedFormArguments &get);

  namespace ReferenceBuilders
  {
    ReferenceSolution
    hertz_line(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    hertz_point(const ClosedFormArguments &get, const Scene &scene);
    // Elliptic point contact of bodies with given principal radii, in a plane normal to z.
    ReferenceSolution
    hertz_elliptic(const ClosedFormArguments &get, const Scene &scene);
    // Hertz point contact of the radius a, with the displacements and stresses of both half spaces.
    ReferenceSolution
    half_space_box(const ClosedFormArguments &get, const Scene &scene);
    // Hertz line contact of the half-width a, with the displacements and stresses of both half planes. Both
    // boxes with friction: at the end time of the load program of HalfBodyLoading.
    ReferenceSolution
    half_plane_box(const ClosedFormArguments &get, const Scene &scene);
    // Line contact and sphere with a shear force: first loading, or on the way back after reversals.
    ReferenceSolution
    cattaneo_mindlin(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    mindlin_sphere(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    flat_punch_line(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    flat_punch_axisymmetric(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    cone(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    uniform(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    two_block_patch(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    shrink_fit_cylinders(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    shrink_fit_spheres(const ClosedFormArguments &get, const Scene &scene);
    ReferenceSolution
    tubes_external_pressure(const ClosedFormArguments &get, const Scene &scene);
  } // namespace ReferenceBuilders
} // namespace Amontons

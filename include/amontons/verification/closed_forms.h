// Closed-form solutions of contact problems: functions of numbers only; nothing here knows a scene or a mesh.
// Pressures are positive in compression; stresses are positive in tension. Consistent units.
// Sources: [J] Johnson, Contact Mechanics (1985); [S] Sneddon, Int. J. Eng. Sci. 3 (1965) 47; [T] Timoshenko
// and Goodier, Theory of Elasticity (1970); [B] Barber, Contact Mechanics (2018). For friction see
// closed_forms_friction.h.
#pragma once

#include <deal.II/base/numbers.h>

#include <functional>
#include <limits>

namespace Amontons
{
  namespace ClosedForms
  {
    constexpr double pi    = dealii::numbers::PI;
    constexpr double rigid = std::numeric_limits<double>::infinity(); // Young's modulus of a rigid body

    // 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2; [J] sec. 4.2
    double
    contact_modulus(const double E1, const double nu1, const double E2 = rigid, const double nu2 = 0);
    // 1/E* = 1/E1 + 1/E2: line contact in plane stress
    double
    contact_modulus_plane_stress(const double E1, const double E2 = rigid);
    // E (1-nu) / ((1+nu)(1-2nu)): no lateral strain
    double
    confined_modulus(const double E, const double nu);

    // ---- Hertz. p(r) = p0 sqrt(1 - r^2/a^2) on r < a, in both cases.

    struct Hertz
    {
      double force, size, peak; // P (line: per thickness), a, p0
      double approach;          // point contact: delta; line contact: NaN (logarithmic)
    };
    // a^2 = 4 P R / (pi E*), p0 = 2 P / (pi a); [J] (4.43)-(4.45)
    Hertz
    hertz_line(const double P, const double R, const double modulus);
    // the same, of given a: P = pi E* a^2 / (4 R)
    Hertz
    hertz_line_of_size(const double a, const double R, const double modulus);
    // a^3 = 3 P R / (4 E*), p0 = 3 P / (2 pi a^2), delta = a^2 / R; [J] (4.22)-(4.24)
    Hertz
    hertz_point(const double P, const double R, const double modulus);
    // the same, of given a: P = 4 E* a^3 / (3 R)
    Hertz
    hertz_point_of_size(const double a, const double R, const double modulus);
    double
    elliptic_pressure(const double r, const double a, const double p0);

    // Gap outside of the contact: [x sqrt(x^2-a^2) - a^2 arccosh(x/a)] / (2R)
    double
    hertz_line_gap(const double x, const double a, const double R);
    // (a^2/(pi R)) [sqrt(s^2-1) + (s^2-2) arccos(1/s)], s = r/a; [J] sec. 3.4
    double
    hertz_point_gap(const double r, const double a, const double R);

    // Plane stress state in the axes (x along the surface, z into the body).
    struct PlaneStress
    {
      double xx, zz, xz;
    };
    // On the axis x = 0: xx = -p0/a ((a^2+2z^2)/sqrt(a^2+z^2) - 2z), zz = -p0 a / sqrt(a^2+z^2); [J] sec. 4.2
    PlaneStress
    hertz_line_axis(const double z, const double a, const double p0);
    // McEwen's formulas at (x, z >= 0); with mu: the shear traction mu p pushes this body in +x; [J] (4.49),
    // (7.8).
    PlaneStress
    hertz_line_field(const double x, const double z, const double a, const double p0, const double mu = 0);
    // On the axis of a point contact: radial stress and zz (xx = rr = tt); [J] sec. 3.4
    PlaneStress
    hertz_point_axis(const double z, const double a, const double p0, const double nu);

    // Elliptic point contact with the gap A x^2 + B y^2, 0 < A <= B; semi-axes a (along x) >= b; [J]
    // sec. 4.2
    struct EllipticContact
    {
      double a, b, peak, approach;
    };
    EllipticContact
    hertz_elliptic(const double P, const double A, const double B, const double modulus);
    // The gap of two surfaces with principal curvatures k1x, k1y and k2x, k2y (plane: 0, concave: negative),
    // the x direction of the second being at `angle` (radians) from that of the first: A x^2 + B y^2, A <= B,
    // where this x is at `direction` from that of the first surface; [J] sec. 4.1
    struct QuadraticGap
    {
      double A, B, direction;
    };
    QuadraticGap
    quadratic_gap(
        const double k1x, const double k1y, const double k2x, const double k2y, const double angle = 0);
    // Two cylinders whose axes enclose `angle` (radians); [J] sec. 4.1
    EllipticContact
    crossed_cylinders(
        const double P, const double R1, const double R2, const double angle, const double modulus);

    // Relative change of a at given load if the profile is a circle or sphere, not a parabola:
    // -(3/16)(a/R)^2 in 2D, -(2/15)(a/R)^2 axisymmetric (first term of the series).
    double
    circle_correction(const double a_over_R, const int dim);

    // ---- Half plane z >= 0 in plane strain, under elliptic tractions.

    // Traction (2F/(pi a)) sqrt(1-((x-x0)/a)^2) of resultant F on |x-x0| < a.
    struct EllipticTraction
    {
      double force, size, centre;
    };
    struct HalfPlaneState
    {
      double      ux, uz; // up to a rigid translation that depends on the unit of length
      PlaneStress stress;
    };
    // A pressure pushes the surface in +z, a shear traction pushes it in +x; points with z < 0 are taken to z
    // = 0. At (0,0) the derivatives are finite; at the edges x = x0 +- a of the surface they are not,
    // displacements are.
    HalfPlaneState
    half_plane_pressure(
        const double x, const double z, const double E, const double nu, const EllipticTraction &traction);
    HalfPlaneState
    half_plane_shear(
        const double x, const double z, const double E, const double nu, const EllipticTraction &traction);

    // ---- Half space z >= 0 under Hertz's pressure of resultant P on the circle r < a.

    // Stress in cylindrical axes; displacements vanish far away. [J] sec. 3.4 for surface and axis, Huber
    // (1904) for the stresses in the inside. Points with z < 0 are taken to z = 0; all is finite but for no
    // more than the slopes at the edge r = a of the surface.
    struct HalfSpaceState
    {
      double ur, uz;
      double rr, tt, zz, rz;
    };
    HalfSpaceState
    half_space_hertz(
        const double r, const double z, const double E, const double nu, const double P, const double a);

    // The same under the shear traction (3Q/(2 pi a^2)) sqrt(1-r^2/a^2) in +x: displacements, which vanish
    // far away; [J] sec. 3.6.
    struct Displacement
    {
      double x, y, z; // z into the body
    };
    Displacement
    half_space_shear(const double x,
                     const double y,
                     const double z,
                     const double E,
                     const double nu,
                     const double Q,
                     const double a);

    // ---- Punches without rounded edges, and general profiles.

    // p = P / (pi sqrt(a^2-x^2)); [J] (2.64)
    double
    flat_punch_line_pressure(const double x, const double P, const double a);
    // P = 2 E* a delta; p = P / (2 pi a sqrt(a^2-r^2)); [S], [J] (3.34)
    double
    flat_punch_force(const double a, const double delta, const double modulus);
    double
    flat_punch_pressure(const double r, const double P, const double a);

    // Cone whose flank makes the angle `flank` (radians) with the surface:
    // P = 2 E* delta^2 / (pi tan), a = 2 delta / (pi tan), p = (E*/2) tan arccosh(a/r); [S], [J] sec. 5.2
    struct Cone
    {
      double size, approach;
    };
    Cone
    cone(const double P, const double flank, const double modulus);
    double
    cone_pressure(const double r, const double a, const double flank, const double modulus);

    // Load at which a symmetric convex profile z = f(|x|) touches along |x| < a:
    // P = E* int_0^a x f'(x) / sqrt(a^2-x^2) dx; [B]
    double
    line_profile_force(const std::function<double(double)> &slope, const double a, const double modulus);

    // ---- Blocks, tubes and shells: uniform pressures.

    enum class Confinement
    {
      plane_strain, // the sides are free in the plane
      plane_stress, // also: uniaxial, in 3D
      confined      // no lateral strain
    };
    // Two stacked blocks of heights h, shortened by delta: p = delta / (h1/M1 + h2/M2)
    double
    two_block_patch(const double      E1,
                    const double      nu1,
                    const double      h1,
                    const double      E2,
                    const double      nu2,
                    const double      h2,
                    const double      delta,
                    const Confinement confinement);

    // Tube or spherical shell between two radii.
    struct Tube
    {
      double E, nu, inner, outer;
    };
    // Both of these for plane_strain or plane_stress (free ends). The bodies meet at inner.outer =
    // outer.inner (Lame, [T]). Interface pressure of the radial interference delta.
    double
    shrink_fit_cylinders(const Tube       &inside,
                         const Tube       &outside,
                         const double      delta,
                         const Confinement confinement);
    // Interface pressure under the pressure p on outside.outer; a free bore, no initial gap.
    double
    tubes_external_pressure(const double      p,
                            const Tube       &outside,
                            const Tube       &inside,
                            const Confinement confinement);
    // Spherical shells with interference delta ([T]).
    double
    shrink_fit_spheres(const Tube &inside, const Tube &outside, const double delta);
  } // namespace ClosedForms
} // namespace Amontons

// Uniform contact pressures: stacked blocks, tubes and shells.
#include <amontons/verification/closed_forms.h>

namespace Amontons
{
  namespace ClosedForms
  {
    namespace
    {
      // Plane strain is plane stress with E/(1-nu^2) and nu/(1-nu).
      Tube
      in_plane_stress(const Tube &tube, const Confinement confinement)
      {
        if (confinement == Confinement::plane_stress)
          return tube;
        return {tube.E / (1 - tube.nu * tube.nu), tube.nu / (1 - tube.nu), tube.inner, tube.outer};
      }

      // Lame: outward displacement of the bore, and inward one of the rim, per unit of pressure on it.
      double
      bore_compliance(const Tube &t)
      {
        const double i = t.inner * t.inner, o = t.outer * t.outer;
        return t.inner / t.E * ((o + i) / (o - i) + t.nu);
      }

      double
      rim_compliance(const Tube &t)
      {
        const double i = t.inner * t.inner, o = t.outer * t.outer;
        return t.outer / t.E * ((o + i) / (o - i) - t.nu);
      }

      double
      modulus(const double E, const double nu, const Confinement confinement)
      {
        switch (confinement)
          {
            case Confinement::plane_strain:
              return E / (1 - nu * nu);
            case Confinement::confined:
              return confined_modulus(E, nu);
            default:
              return E;
          }
      }
    } // namespace

    double
    two_block_patch(const double      E1,
                    const double      nu1,
                    const double      h1,
                    const double      E2,
                    const double      nu2,
                    const double      h2,
                    const double      delta,
                    const Confinement confinement)
    {
      return delta / (h1 / modulus(E1, nu1, confinement) + h2 / modulus(E2, nu2, confinement));
    }

    double
    shrink_fit_cylinders(const Tube       &inside,
                         const Tube       &outside,
                         const double      delta,
                         const Confinement confinement)
    {
      return delta / (rim_compliance(in_plane_stress(inside, confinement)) +
                      bore_compliance(in_plane_stress(outside, confinement)));
    }

    // Inward displacement of the outer bore by p alone: p 2 Ro^2 Ri / (E (Ro^2-Ri^2)).
    double
    tubes_external_pressure(const double      p,
                            const Tube       &outside,
                            const Tube       &inside,
                            const Confinement confinement)
    {
      const Tube   ring = in_plane_stress(outside, confinement);
      const double i = ring.inner * ring.inner, o = ring.outer * ring.outer;
      const double by_pressure = 2 * o * ring.inner / (ring.E * (o - i));
      return p * by_pressure / (bore_compliance(ring) + rim_compliance(in_plane_stress(inside, confinement)));
    }

    double
    shrink_fit_spheres(const Tube &inside, const Tube &outside, const double delta)
    {
      const auto cube = [](const double r) { return r * r * r; };
      const auto rim  = [&](const Tube &t) {
        const double i = cube(t.inner), o = cube(t.outer);
        return t.outer / t.E * ((1 - 2 * t.nu) * o + (1 + t.nu) * i / 2) / (o - i);
      };
      const auto bore = [&](const Tube &t) {
        const double i = cube(t.inner), o = cube(t.outer);
        return t.inner / t.E * ((1 - 2 * t.nu) * i + (1 + t.nu) * o / 2) / (o - i);
      };
      return delta / (rim(inside) + bore(outside));
    }
  } // namespace ClosedForms
} // namespace Amontons

/// Errors of fields against those of a closed form, in norms. All relative; what the closed form knows of
/// them must be set.
#pragma once

#include <amontons/output/quantities.h>
#include <amontons/verification/reference_solution.h>

namespace Amontons
{
  // sqrt(int (p - p_exact)^2 / int p_exact^2) over the slave surface within the range of the closed form.
  template <int dim>
  double
  pressure_error(const ContactInterface<dim> &interface,
                 const SurfaceFields<dim>    &fields,
                 const ReferenceSolution     &reference,
                 const ProblemType            kind);

  // sqrt(int (q - q_exact)^2 / int q_exact^2) with the shear traction along x: over lines, or, where the
  // closed form is one of the radius, over discs.
  template <int dim>
  double
  shear_error(const ContactInterface<dim> &interface,
              const SurfaceFields<dim>    &fields,
              const ReferenceSolution     &reference);

  // Norms of the displacement error (rigid motions included) and, if the stress is known, of the stress error
  // in the energy norm. Collective.
  template <int dim>
  void
  compare_fields(const Answer<dim> &answer, const ReferenceSolution &reference, ReferenceSummary &summary);
} // namespace Amontons

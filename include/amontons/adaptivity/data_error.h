// What of a scene's formulas is lost between the nodes.
#pragma once

#include <amontons/adaptivity/error_estimator.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  // By slave face, int d^2 dA and |int d dA| of what is missing in the shear where the bound of friction
  // depends on the place: where nodes slip, d = phi(X, p) less its interpolation between the nodes; where all
  // stick, d = max(0, |q| - phi). At 4000 samples of the surface at least, in space 40000. 0 of other pairs.
  struct FrictionError
  {
    double square = 0, resultant = 0;
  };
  template <int dim>
  std::vector<FrictionError>
  friction_errors(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const ProblemType            kind);

  // Prescribed displacements that depend on the place, g(X, t): the energy of d = g - u_h on the boundary,
  // E |d|^2 in the norm of H^(1/2), sqrt(int d^2 dA int |grad d|^2 dA) of each face. It is added to the error
  // of the stress, and as much, relative, to that of the pressure. Collective.
  template <int dim>
  void
  add_error_of_displacements(const Discretization<dim> &discretization,
                             const SolutionState<dim>  &state,
                             ErrorEstimate<dim>        &error);
} // namespace Amontons

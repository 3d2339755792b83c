// Where to refine, and how the state gets to the new mesh.
#pragma once

#include <amontons/adaptivity/error_estimator.h>
#include <amontons/base/parameters.h>
#include <amontons/solver/solution_state.h>

namespace Amontons
{
  struct RefinementParameters : ParameterGroup
  {
    unsigned int cycles       = 0;      // refinements after the first solve
    unsigned int max_dofs     = 1000000; // no mesh with more than about this many DoFs
    double       target_error = 0;      // stop once the estimated relative error of the contact pressure is below; 0: off
    double       fraction     = 0.5;    // bulk (Doerfler) fraction of the squared error to be refined
    std::string  strategy     = "adaptive"; // adaptive | uniform
    // Before the first solve: refine faces that are close to the other surface until about this many faces see a contact.
    unsigned int initial_refinements = 3;

    void declare(ParameterHandler &prm) override;
  };

  // Marks the cells (never carriers) with the largest indicators until their squares make `fraction` of the sum; uniform: all cells of deformable bodies.
  template <int dim>
  void mark_cells(const Discretization<dim>   &discretization,
                  Geometry<dim>               &geometry,
                  const RefinementParameters  &parameters,
                  const Vector<float>         &indicators);

  // Marks the cells behind slave and master faces that may touch first: faces whose overlap points have a gap below `distance`.
  template <int dim>
  unsigned int mark_close_cells(Geometry<dim>                            &geometry,
                                const std::vector<ContactInterface<dim>> &interfaces,
                                const double                              distance);

  // Refines; displacement and traction are interpolated to the new mesh. `rebuild` is called between refinement and interpolation to
  // distribute the DoFs of the new mesh and must leave discretization ready to make vectors.
  template <int dim>
  void refine_and_transfer(Discretization<dim>         &discretization,
                           Geometry<dim>               &geometry,
                           SolutionState               &state,
                           const std::function<void()> &rebuild);
} // namespace Amontons

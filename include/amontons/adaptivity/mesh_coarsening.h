// Meshes that follow a contact: what it has left is coarse again.
#pragma once

#include <amontons/discretization/discretization.h>

#include <set>

namespace Amontons
{
  // Active cells of deformable bodies, of all ranks. Collective.
  template <int dim>
  std::set<CellId>
  deformable_cells(const Discretization<dim> &discretization);

  // Where contact has moved on. After the cells to be refined are marked: marks the children of cells where
  // none of them is refined, nor one of `first`, and where the squares of what the cell would have instead
  // make little of the `target` for all of them (of indicators relative to it). Collective.
  template <int dim>
  void
  mark_cells_to_coarsen(const Discretization<dim> &discretization,
                        Geometry<dim>             &geometry,
                        const std::set<CellId>    &first,
                        const Vector<float>       &indicators,
                        const double               target);

  // Before marked cells are refined and coarsened: flags of which neighbours allow no coarsening are taken
  // back, by all neighbours, also those of other ranks, so that the mesh does not depend on these.
  // Collective.
  template <int dim>
  void
  prepare_refinement(parallel::distributed::Triangulation<dim> &triangulation);
} // namespace Amontons

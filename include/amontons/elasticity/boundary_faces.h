// Faces of the mesh's boundary, as they are and as they are deformed.
#pragma once

#include <amontons/discretization/discretization.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  // action(cell, face) for the owned cells' faces on this boundary.
  template <int dim, typename Action>
  void
  for_each_face(const Discretization<dim> &discretization,
                const types::boundary_id   boundary,
                const Action              &action)
  {
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary)
            action(cell, f);
  }

  // At the points of a face: their positions x, deformation gradients F (in the space of the mesh) and
  // n da/dA = det F F^-T N (Nanson). In axisymmetry the ratio of the radii is left to measure() of x.
  template <int dim>
  struct DeformedFace
  {
    std::vector<Point<dim>>     positions;
    std::vector<Tensor<2, dim>> gradients;
    std::vector<Tensor<1, dim>> normals;
  };

  // u readable at relevant DoFs; null: undeformed. Needs, of `values`, quadrature points and normal vectors,
  // with u also values and gradients.
  template <int dim>
  DeformedFace<dim>
  deform(const FEFaceValues<dim> &values, const LA::Vector *u);
} // namespace Amontons

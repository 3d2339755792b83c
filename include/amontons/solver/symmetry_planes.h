/// Bodies that have moved through a plane of symmetry, on the other side of which is their own image.
#pragma once

#include <amontons/discretization/discretization.h>

namespace Amontons
{
  /// Of the bodies that the mesh has on one side of the plane of a boundary with `Type = symmetry`: the
  /// vertices (reference configuration) that u takes farthest beyond it, one for each body and plane, by more
  /// than a thousandth of the body's size; unless the scene itself takes a boundary there that lay in the
  /// plane. Contact with the image is not modelled, so that this is no answer. u readable at relevant DoFs.
  /// Collective.
  template <int dim>
  std::vector<Point<dim>>
  beyond_symmetry_planes(const Discretization<dim> &discretization, const LA::Vector &u);
} // namespace Amontons

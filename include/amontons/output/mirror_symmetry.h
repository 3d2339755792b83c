/// Whether half of a scene would do.
#pragma once

#include <amontons/adaptivity/increment_error.h>
#include <amontons/output/quantities.h>

namespace Amontons
{
  /// The planes "x = 0", ... at which the bodies (the vertices of their coarse meshes, if these are not
  /// many) and their displacements, to `tolerance` of the largest deformation, are their own mirror images,
  /// and so are the forces of pairs and supports and, to ten times as much, the pressures. Something must
  /// touch. Where the path has `breakpoints`, forces of pairs are so at all of them. Planes are normal to an
  /// axis, in the middle of all bodies; axisymmetric: normal to y. Collective.
  template <int dim>
  std::vector<std::string>
  mirror_planes(const Answer<dim>                      &answer,
                const double                            tolerance,
                const std::vector<LoadRecord::Landing> &breakpoints = {});
} // namespace Amontons

// Bodies whose meshes fall apart.
#pragma once

#include <amontons/geometry/geometry.h>

namespace Amontons
{
  // A sentence for each deformable body whose coarse mesh is in several parts that share no face. Throws
  // InputError where different vertices of two parts are in the same place: a seam that was not merged.
  template <int dim>
  std::vector<std::string>
  bodies_in_parts(const Scene &scene, const Geometry<dim> &geometry);
} // namespace Amontons

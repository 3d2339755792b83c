/// The boundaries that a name stands for.
#pragma once

#include <amontons/geometry/geometry.h>

#include <set>

namespace Amontons
{
  /// With the further ones of the same body. Throws InputError, see Geometry::boundary().
  template <int dim>
  std::set<dealii::types::boundary_id>
  boundary_ids(const Geometry<dim> &geometry, const Scene &scene, const BoundaryName &name)
  {
    std::set<dealii::types::boundary_id> ids = {geometry.boundary(name, scene).id};
    for (const auto &further : name.more)
      ids.insert(geometry.boundary({name.body, further, name.where}, scene).id);
    return ids;
  }
} // namespace Amontons

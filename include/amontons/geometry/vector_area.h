/// The vector area of a face of a mesh.
#pragma once

#include <deal.II/base/tensor.h>

namespace Amontons
{
  /// int N dA over the flat face through its vertices. That of a chord goes through the circle's centre.
  template <int dim, typename Face>
  dealii::Tensor<1, dim>
  vector_area(const Face &face)
  {
    if constexpr (dim == 2)
      return cross_product_2d(face->vertex(1) - face->vertex(0));
    else
      return 0.5 * cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1));
  }
} // namespace Amontons

/// Unit vectors that are square to each other.
#pragma once

#include <deal.II/base/tensor.h>

#include <vector>

namespace Amontons
{
  using namespace dealii;

  /// v without its parts along the directions.
  template <int dim>
  Tensor<1, dim>
  without(Tensor<1, dim> v, const std::vector<Tensor<1, dim>> &directions)
  {
    for (const auto &q : directions)
      v -= (v * q) * q;
    return v;
  }

  /// What the directions leave: further ones, by the axes. A rest of less than 0.1 is none: if anything is
  /// left, another axis has more of it.
  template <int dim>
  std::vector<Tensor<1, dim>>
  directions_left(std::vector<Tensor<1, dim>> directions)
  {
    std::vector<Tensor<1, dim>> left;
    for (unsigned int c = 0; c < dim; ++c)
      {
        Tensor<1, dim> axis;
        axis[c] = 1;
        axis    = without(axis, directions);
        if (axis.norm() < 0.1)
          continue;
        left.push_back(axis / axis.norm());
        directions.push_back(left.back());
      }
    return left;
  }
} // namespace Amontons

// Points and area vectors of surface faces.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/utilities.h>

#include <array>
#include <vector>

namespace Amontons
{
  using namespace dealii;

  // The (degree+1)^fdim equidistant points of the unit face, the first coordinate running fastest.
  template <int fdim>
  std::vector<Point<fdim>>
  lattice(const unsigned int degree)
  {
    std::vector<Point<fdim>> points;
    const unsigned int       n = degree + 1;
    for (unsigned int i = 0; i < Utilities::fixed_power<fdim>(n); ++i)
      {
        Point<fdim>  p;
        unsigned int rest = i;
        for (unsigned int d = 0; d < fdim; ++d, rest /= n)
          p[d] = double(rest % n) / degree;
        points.push_back(p);
      }
    return points;
  }

  template <int fdim>
  Point<fdim>
  face_centre()
  {
    Point<fdim> xi;
    for (unsigned int d = 0; d < fdim; ++d)
      xi[d] = 0.5;
    return xi;
  }

  // Normal to the tangents, of the length of their area element: t_0 x t_1; in 2D (t_y, -t_x).
  inline Tensor<1, 2>
  area_vector(const std::array<Tensor<1, 2>, 1> &t)
  {
    return Tensor<1, 2>({t[0][1], -t[0][0]});
  }

  inline Tensor<1, 3>
  area_vector(const std::array<Tensor<1, 3>, 2> &t)
  {
    return cross_product_3d(t[0], t[1]);
  }
} // namespace Amontons

// Where formulas are looked at on a surface.
#pragma once

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  using namespace dealii;

  // Along one direction of a face of a surface of so many: Gauss points, whose distances differ, so that no
  // wave fits all of them; on surfaces of few faces the more.
  template <int dim>
  QGauss<1>
  samples_along(const unsigned int n_faces)
  {
    const unsigned int n = std::max(1u, n_faces);
    return dim == 2 ? std::clamp(4000 / n, 24u, 400u)
                    : std::clamp(static_cast<unsigned int>(std::sqrt(4e4 / n)), 8u, 40u);
  }
} // namespace Amontons

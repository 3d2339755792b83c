// One piece of an overlap: all points of its quadrature formula, or none.
#pragma once

#include <amontons/contact/coupling.h>

namespace Amontons
{
  // Appends slave_point(q), q < n, completed by `opposite` (which returns whether there is anything on the
  // other side) and by the gap. Nothing stays if a point has nothing opposite, or if all gaps are above
  // `reach`.
  template <int dim, typename SlavePoint, typename Opposite>
  void
  append_piece(const unsigned int              n,
               const SlavePoint               &slave_point,
               const Opposite                 &opposite,
               const double                    reach,
               std::vector<OverlapPoint<dim>> &points)
  {
    const std::size_t before  = points.size();
    double            closest = std::numeric_limits<double>::max();
    for (unsigned int q = 0; q < n && closest >= 0; ++q)
      {
        OverlapPoint<dim> p     = slave_point(q);
        const bool        found = opposite(p);
        p.gap                   = p.normal * (p.x_master - p.x_slave);
        closest                 = found ? std::min(closest, std::abs(p.gap)) : -1;
        points.push_back(p);
      }
    if (closest < 0 || closest > reach)
      points.resize(before);
  }
} // namespace Amontons

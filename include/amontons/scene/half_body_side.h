// Which of two half planes or half spaces a body of the scene is cut out of.
#pragma once

#include <amontons/scene/scene.h>

namespace Amontons
{
  class TwoHalves
  {
  public:
    // The common surface is normal to `axis` and goes through `centre`; lengths below 1e-9 `size` count as
    // zero.
    TwoHalves(const Point<3>              &centre,
              const double                 size,
              const unsigned int           axis,
              const MaterialData          &lower,
              const MaterialData          &upper,
              const std::vector<BodyData> &bodies);

    // -1: below, 1: above: by the body's shape where that says it, else by the point; on the surface by the
    // material.
    int
    side(const std::string &body, const Point<3> &p) const;

  private:
    struct Sides
    {
      int by_shape, by_material; // 0: not known
    };
    double                       surface, tolerance;
    unsigned int                 axis;
    std::map<std::string, Sides> sides; // by body
  };
} // namespace Amontons

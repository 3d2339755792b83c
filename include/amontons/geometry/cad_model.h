// What a STEP or IGES file says about surfaces, through OpenCASCADE.
#pragma once

#include <amontons/scene/scene.h>

#include <deal.II/base/bounding_box.h>

#include <functional>
#include <vector>

namespace Amontons
{
  // A face or an edge of a CAD model. The closest point is on the whole surface or curve, which may go on
  // beyond the face or edge; the box is that of the face or edge.
  struct CadShape
  {
    dealii::BoundingBox<3>                    box;
    std::function<Point<3>(const Point<3> &)> closest_point;

    // Of all points from the shape; infinite if one of them is farther than `tolerance` from the box.
    double
    largest_distance(const std::vector<Point<3>> &points, const double tolerance) const;
  };

  struct CadModel
  {
    std::vector<CadShape> faces, edges;
  };

  // The model of geometry.file, scaled, and placed like `body`. Throws InputError.
  CadModel
  read_cad_model(const TrueGeometry &geometry, const BodyData &body);
} // namespace Amontons

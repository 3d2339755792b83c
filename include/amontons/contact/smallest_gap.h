// Gaps between the points of integration, where corners and tips come nearest.
#pragma once

#include <amontons/contact/surface_approach.h>

#include <limits>
#include <set>

namespace Amontons
{
  // At the points of one slave face, and the faces of the master (none: an obstacle) that they are opposite
  // of.
  struct FaceGaps
  {
    double smallest = std::numeric_limits<double>::max(), largest = -std::numeric_limits<double>::max();
    std::set<unsigned int> opposite;

    // By how much they vary; negative: no points.
    double
    range() const
    {
      return largest - smallest;
    }
  };

  // By slave face, nearer by `approach`.
  template <int dim>
  std::vector<FaceGaps>
  gaps_by_face(const ContactSurface<dim>            &slave,
               const std::vector<OverlapPoint<dim>> &points,
               const SurfaceApproach<dim>           &approach);

  // The smallest gap g of x + g n = y between a slave face and what is opposite, with its continuous normal
  // n, where the surfaces are that `points` were taken at, nearer by `approach`: at the nodes of both sides,
  // around the lowest of many places between, and at the points. A gap that the pair declares
  // replaces it, or (adds_declared) is added to it.
  template <int dim>
  double
  smallest_gap(const ContactInterface<dim> &interface,
               const unsigned int           face,
               const FaceGaps              &points,
               const SurfaceApproach<dim>  &approach,
               const bool                   adds_declared);
} // namespace Amontons

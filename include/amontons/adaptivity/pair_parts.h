/// What the error estimate of a pair of surfaces is put together from.
#pragma once

#include <amontons/adaptivity/data_error.h>
#include <amontons/adaptivity/face_points.h>

#include <map>

namespace Amontons
{
  /// By slave face: whether it is near the contact, the errors of edge_errors(), gap_errors() and
  /// friction_errors(); by point of the overlap tractions_of_master(); pair_weights(); and what the doubts of
  /// RefinedPairs make.
  template <int dim>
  struct PairParts
  {
    FacePoints<dim>                        points;
    std::vector<bool>                      near;
    std::vector<double>                    edge, gap;
    std::vector<FrictionError>             friction;
    std::map<unsigned int, Tensor<1, dim>> of_master;
    double                                 weight;
    double                                 hidden; // squared errors that are not seen, of those that are
  };
} // namespace Amontons

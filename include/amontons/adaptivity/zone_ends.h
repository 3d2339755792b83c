/// How far the ends of a contact, or of a zone that sticks, may be from where a mesh has them.
#pragma once

#include <amontons/adaptivity/error_estimator.h>

namespace Amontons
{
  /// name: contact size | stick size.
  /// By pair: a mean error of the size. Between the last node of the zone and the first one outside it may
  /// end anywhere, by h/4 from the middle in the mean. Where a zone ends with a body, nothing is in doubt. In
  /// space, where an end is a line whose errors cancel each other: 0.
  template <int dim>
  std::vector<double>
  doubts_of_sizes(const std::string                        &name,
                  const std::vector<ContactInterface<dim>> &interfaces,
                  const std::vector<SurfaceFields<dim>>    &fields);

  /// The cells of both sides there, as `quantity_indicators`: the lengths of the slave's faces. is_needed: no
  /// mesh tells where they are; else none.
  template <int dim>
  void
  add_ends_of_sizes(const std::string                        &name,
                    const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<SurfaceFields<dim>>    &fields,
                    const bool                                is_needed,
                    ErrorEstimate<dim>                       &estimate);
} // namespace Amontons

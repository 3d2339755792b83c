/// What the answer of a scene is compared with at the end of its load program. The program knows no such
/// reference: whoever runs a scene that names one hands over how to make it.
#pragma once

#include <amontons/output/quantities.h>
#include <amontons/output/report.h>

#include <functional>
#include <memory>

namespace Amontons
{
  /// The reference of one scene. One run asks it at the end, on every mesh of the last increment.
  template <int dim>
  class Reference
  {
  public:
    virtual ~Reference() = default;

    // Errors of the answer on the present mesh. Collective.
    virtual ReferenceSummary
    compare(const Answer<dim> &answer) const = 0;

    // Adds the error of the work of friction of the whole load history to that summary, if the reference
    // knows it.
    virtual void
    compare_dissipation(const Answer<dim> &answer,
                        const double       dissipation,
                        ReferenceSummary  &summary) const = 0;

    // For the charts of the report.
    virtual ReferenceTractions
    tractions() const = 0;
  };

  /// For scenes with `reference`. Throws InputError at its place.
  template <int dim>
  using MakeReference = std::function<std::unique_ptr<const Reference<dim>>(const Scene &scene)>;
} // namespace Amontons

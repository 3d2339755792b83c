/// An increment that failed, and whether a shorter one is another problem.
#pragma once

#include <amontons/model.h>
#include <amontons/solver/newton_report.h>

namespace Amontons
{
  template <int dim>
  struct FailedIncrement
  {
    FailedIncrement() = default;
    FailedIncrement(const Model<dim> &model, const NewtonReport &report);

    /// A shorter increment than `before` is the same problem again if neither loads, supports nor declared
    /// gaps depend on t; or, from rest, if they all grow alike and the iteration went the same way. Where
    /// bodies and surfaces move, never. Collective.
    bool
    is_alike(const FailedIncrement &before, const bool from_rest) const;

    NewtonReport        report;
    bool                moves = false; // finite strain
    LA::Vector          loads, values; // prescribed ones, on the owned DoFs
    std::vector<double> gaps;          // declared, of rows where they grow
  };
} // namespace Amontons

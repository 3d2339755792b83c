// Squared indicators, of which thresholds are asked for.
#pragma once

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Amontons
{
  // Of this rank; questions are about all ranks, and collective.
  class SquaredErrors
  {
  public:
    SquaredErrors(std::vector<double> squares, const MPI_Comm communicator)
        : squares(std::move(squares)), communicator(communicator)
    {
      double mine = 0;
      for (const double square : this->squares)
        mine = std::max(mine, square);
      largest = dealii::Utilities::MPI::max(mine, communicator);
    }

    // Of a function of the squares.
    template <typename Function>
    double
    sum(const Function &f) const
    {
      double mine = 0;
      for (const double square : squares)
        mine += f(square);
      return dealii::Utilities::MPI::sum(mine, communicator);
    }

    double
    sum_above(const double threshold) const
    {
      return sum([&](const double square) { return square >= threshold ? square : 0; });
    }

    double
    sum_below(const double threshold) const
    {
      return sum([&](const double square) { return square < threshold ? square : 0; });
    }

    double
    count_above(const double threshold) const
    {
      return sum([&](const double square) { return square >= threshold ? 1 : 0; });
    }

    // Bisection between 0, where `holds` is true or nothing matters, and above the largest: the largest
    // threshold that holds, if `holds` turns false with growing thresholds.
    template <typename Condition>
    double
    largest_threshold(const Condition &holds) const
    {
      double low = 0, high = 2 * largest;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double middle          = (low + high) / 2;
          (holds(middle) ? low : high) = middle;
        }
      return low;
    }

    double largest;

  private:
    std::vector<double> squares;
    MPI_Comm            communicator;
  };
} // namespace Amontons

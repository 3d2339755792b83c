/// Errors of different causes.
#pragma once

#include <algorithm>
#include <cmath>

namespace Amontons
{
  /// What errors of the mesh and of the increments make together, as fields in the mean square: one
  /// oscillates from cell to cell, the other from increment to increment, so that they are nearly orthogonal,
  /// |a + b|^2 = |a|^2 + |b|^2; those of numbers have signs that know nothing of each other. (What small
  /// strain leaves out is smooth, is no random number, and comes on top.)
  inline double
  together(const double a, const double b)
  {
    return std::hypot(a, b);
  }

  /// What another error may be for both to make the whole; 0 where one is more than that.
  inline double
  left_of(const double whole, const double error)
  {
    return std::sqrt(std::max(0., whole * whole - error * error));
  }
} // namespace Amontons

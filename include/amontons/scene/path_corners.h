// Where a function of the time turns, bends or jumps, and how far it has come by when.
#pragma once

#include <functional>
#include <vector>

namespace Amontons
{
  struct PathCourse
  {
    // With 0 < t < end_time: where it is largest or smallest, where its slope jumps (as that of min(t, 1)
    // does), and the last time before it jumps itself. Increasing.
    std::vector<double> corners;
    // How much it has varied by 1001 equidistant times from 0 to end_time, its jumps left out: int_0^t |df|
    // over the same of the whole path. Empty: it does not vary.
    std::vector<double> variation;
  };

  // Of a load, a motion, ... f, from 1001 values of it, so that what happens within a thousandth of the end
  // time may be missed.
  PathCourse
  course_of_path(const std::function<double(double)> &f, const double end_time);
} // namespace Amontons

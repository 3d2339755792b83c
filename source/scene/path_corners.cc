#include <amontons/scene/path_corners.h>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Amontons
{
  namespace
  {
    class Path
    {
    public:
      Path(const std::function<double(double)> &f, const double end_time) : f(f), end_time(end_time)
      {
        for (unsigned int i = 0; i <= n; ++i)
          values.push_back(f(time(i)));
        const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
        range                          = *largest - *smallest;
        is_still                       = range <= 1e-12 * std::max(std::abs(*largest), std::abs(*smallest));
      }

      std::vector<double>
      corners() const
      {
        std::vector<double> times;
        const auto          add = [&](const std::optional<double> &t) {
          if (t && *t > 1e-6 * end_time && *t < (1 - 1e-6) * end_time &&
              (times.empty() || *t > times.back() + 1e-6 * end_time))
            times.push_back(*t);
        };
        for (unsigned int i = 1; !is_still && i < n; ++i)
          if (const auto before = jump(i))
            add(before);
          else if (const auto bend = kink(i))
            add(bend);
          else
            add(extremum(i));
        return times;
      }

      std::vector<double>
      variation() const
      {
        std::vector<double> sums(1, 0.);
        for (unsigned int i = 0; i < n; ++i)
          sums.push_back(sums.back() + (i > 0 && jump(i) ? 0. : std::abs(slope(i))));
        if (is_still || sums.back() == 0)
          return {};
        for (double &sum : sums)
          sum /= sums.back();
        return sums;
      }

    private:
      static constexpr unsigned int n = 1000;

      double
      time(const double i) const
      {
        return end_time * (i / n);
      }
      // What a user writes is mostly a multiple of a thousandth.
      double
      rounded(const double t) const
      {
        const double nearest = time(std::round(t / end_time * n));
        return std::abs(t - nearest) < 1e-6 * end_time ? nearest : t;
      }
      // Of the interval after i, to one of a thousandth; none beyond the ends.
      double
      slope(const int i) const
      {
        const int k = std::clamp(i, 0, static_cast<int>(n) - 1);
        return values[k + 1] - values[k];
      }
      // Of the slope from one side of time i - 1 to i + 1 to the other.
      double
      bend(const int i) const
      {
        return slope(i + 1) - slope(i - 2);
      }

      // Far more than beside it: halved until nothing but the jump is left.
      std::optional<double>
      jump(const unsigned int i) const
      {
        const double step   = std::abs(slope(i)),
                     beside = std::max(std::abs(slope(i - 1)), std::abs(slope(i + 1)));
        if (i + 1 >= n || step < 1e-3 * range || step < 8 * beside)
          return {};
        double before = time(i), after = time(i + 1), v_before = values[i], v_after = values[i + 1];
        for (unsigned int k = 0; k < 34; ++k)
          {
            const double middle = (before + after) / 2, v = f(middle);
            const bool   is_later           = std::abs(v - v_before) <= std::abs(v_after - v);
            (is_later ? before : after)     = middle;
            (is_later ? v_before : v_after) = v;
          }
        if (std::abs(v_after - v_before) < 0.5 * step)
          return {};
        const double nearest = rounded(before);
        return std::abs(f(nearest) - v_before) <= std::abs(f(nearest) - v_after) ? nearest : before;
      }

      // The slope changes by far more than beside it: where the lines on either side meet, looked at from
      // ever nearer.
      std::optional<double>
      kink(const unsigned int i) const
      {
        const double here   = std::abs(bend(i)),
                     beside = std::max(std::abs(bend(i - 3)), std::abs(bend(i + 3)));
        if (i < 3 || i + 3 >= n || here < 8 * beside || here < 1e-5 * range ||
            here < std::max(std::abs(bend(i - 1)), std::abs(bend(i + 1))) * (1 - 1e-6))
          return {};
        double t = time(i);
        for (double h = 1; h > 1e-5; h /= 8)
          t = meeting_of_lines(t, time(h));
        return rounded(t);
      }

      // Of those through two values each before t - h and after t + h; not beyond these.
      double
      meeting_of_lines(const double t, const double h) const
      {
        const double before = f(t - h), after = f(t + h), left = before - f(t - 2 * h),
                     right = f(t + 2 * h) - after;
        if (left == right)
          return t;
        return t + h * std::clamp((before - after + left + right) / (right - left), -1., 1.);
      }

      // Values on either side of one midway between them are the same.
      std::optional<double>
      extremum(const unsigned int i) const
      {
        const double rounding  = 1e-13 * range;
        const bool   is_midway = std::abs(slope(i)) <= rounding;
        const double left = slope(i - 1), right = slope(is_midway ? i + 1 : i);
        if (!(left > rounding && right < -rounding) && !(left < -rounding && right > rounding))
          return {};
        const double sign = left > 0 ? -1 : 1;
        return rounded(boost::math::tools::brent_find_minima([&](const double t) { return sign * f(t); },
                                                             time(i - 1.),
                                                             time(i + (is_midway ? 2. : 1.)),
                                                             40)
                           .first);
      }

      const std::function<double(double)> &f;
      const double                         end_time;
      std::vector<double>                  values;
      double                               range    = 0;
      bool                                 is_still = true;
    };
  } // namespace

  PathCourse
  course_of_path(const std::function<double(double)> &f, const double end_time)
  {
    const Path path(f, end_time);
    return {path.corners(), path.variation()};
  }
} // namespace Amontons

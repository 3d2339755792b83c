// Where loads turn, bend and jump.
#include <amontons/scene/path_corners.h>

#include <cmath>
#include <sstream>

#include "check.h"

namespace test_path_corners
{
using namespace Amontons;

void
check_corners(const std::string                   &what,
              const std::function<double(double)> &f,
              const std::vector<double>           &expected,
              const double                         tolerance = 1e-12)
{
  const auto         found = course_of_path(f, 2).corners;
  std::ostringstream text;
  text.precision(12);
  for (const double t : found)
    text << " " << t;
  check::is_true(found.size() == expected.size(), what + ": number of corners," + text.str());
  for (unsigned int i = 0; i < std::min(found.size(), expected.size()); ++i)
    check::is_close(found[i], expected[i], tolerance, what);
}

int
main(int, char **)
{
  const double pi = std::acos(-1.);
  check_corners("nothing", [](double) { return 3.; }, {});
  check_corners("rounding", [](double t) { return 1 + 1e-15 * std::sin(50 * t); }, {});
  check_corners("straight", [](double t) { return 1e-9 * t; }, {});
  check_corners("curved", [](double t) { return t * t * t; }, {});
  check_corners("exponential", [](double t) { return std::exp(5 * t); }, {});
  check_corners("square root", [](double t) { return std::sqrt(t); }, {});
  check_corners("min", [](double t) { return std::min(t, 1.); }, {1});
  check_corners(
      "min between values", [](double t) { return std::min(t, 0.7313371); }, {0.7313371}, 1e-9);
  check_corners("absolute value", [](double t) { return std::abs(t - 0.5); }, {0.5});
  check_corners("weak bend", [](double t) { return t + 0.05 * std::max(0., t - 1); }, {1});
  check_corners("table", [](double t) { return t < 0.5 ? t : t < 1.5 ? 1 - t : t - 2; }, {0.5, 1.5});
  check_corners(
      "midway between values", [&](double t) { return std::sin(pi * (t - 0.063)); }, {0.563, 1.563}, 1e-7);
  check_corners("sine", [&](double t) { return std::sin(pi * t); }, {0.5, 1.5});
  check_corners("ten periods",
                [&](double t) { return std::sin(10 * pi * t); },
                {0.05, .15,  .25,  .35,  .45,  .55,  .65,  .75,  .85,  .95,
                 1.05, 1.15, 1.25, 1.35, 1.45, 1.55, 1.65, 1.75, 1.85, 1.95});
  check_corners("sine after a while",
                [&](double t) { return t > 1 ? std::sin(2 * pi * (t - 1)) : 0.; },
                {1, 1.25, 1.75});
  check_corners(
      "sine of a bend",
      [](double t) { return std::sin(1.3 + 2 * std::min(t, 1.)); },
      {0.135398163397, 1},
      1e-7); // an extremum is known to the square root of rounding
  check_corners(
      "bend of a curve",
      [](double t) { return t * t * (1 + 0.3 * std::max(0., t - 0.7771)); },
      {0.7771},
      1e-7);
  check_corners(
      "pulse", [](double t) { return std::exp(-std::pow((t - 1.37) / 0.03, 2)); }, {1.37}, 1e-8);
  check_corners(
      "jump", [](double t) { return t > 0.7 ? 1. : 0.; }, {0.7}, 1e-9);
  check_corners(
      "jump of a slope", [](double t) { return t > 0.7 ? 1 + t : t; }, {0.7}, 1e-9);
  check_corners(
      "parabola", [](double t) { return t * (1.3 - t); }, {0.65}, 1e-8);
  check_corners("small units", [](double t) { return 1e-12 * std::min(t, 1.); }, {1});
  check_corners(
      "beside a large constant", [](double t) { return 1e3 + std::min(t, 1.); }, {1}, 1e-9);

  const auto pulse =
      course_of_path([](double t) { return std::exp(-std::pow((t - 1) / 0.03, 2)); }, 2).variation;
  check::is_true(pulse.size() == 1001 && pulse[0] == 0, "values of the variation");
  check::is_close(pulse[400], 0, 1e-12, "before the pulse", 1);
  check::is_close(pulse[500], 0.5, 1e-12, "up and down count alike");
  check::is_close(pulse[1000], 1, 1e-12, "all of it");
  const auto step = course_of_path([](double t) { return t > 0.7 ? 1 + t : t; }, 2).variation;
  check::is_close(step[600], 0.6, 2e-3, "without the jump");
  check::is_true(course_of_path([](double) { return 3.; }, 2).variation.empty(), "nothing varies");
  return check::result();
}
} // namespace test_path_corners

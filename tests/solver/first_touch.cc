// Where an open node touches first, by what gap and tangential jump did before.
#include "check.h"

#include <amontons/solver/first_touch.h>

#include <cmath>

namespace test_first_touch
{
using namespace Amontons;

// The jump when the gap has gone from `now` to 0, by the jumps at the three gaps.
template <typename Jump>
double
predicted(const Jump &jump, const double now, const double before, const std::optional<double> &earlier)
{
  const auto [one, two] = first_touch_weights(now, before, earlier, 1e9);
  return jump(now) + one * (jump(before) - jump(now)) + two * (jump(earlier.value_or(0)) - jump(now));
}

int
main(int, char **)
{
  const auto line     = [](const double g) { return 3 - 2 * g; };
  const auto parabola = [](const double g) { return 3 - 2 * g + 5 * g * g; };
  check::is_close(predicted(line, 0.3, 0.7, {}), 3, 1e-14, "two states: a line");
  check::is_close(predicted(parabola, 0.3, 0.7, 1.6), 3, 1e-14, "three states: a parabola");

  // Beside the front of a contact, at the distances 1, 2, 3: J = J_0 + g + 0.4 g^(5/3).
  const auto   front  = [](const double g) { return 3 + g + 0.4 * std::pow(g, 5. / 3); };
  const double g[]    = {1., std::pow(2., 1.5), std::pow(3., 1.5)};
  const double by_two = predicted(front, g[0], g[1], {}), by_three = predicted(front, g[0], g[1], g[2]);
  check::is_true(std::abs(by_three - 3) < 0.35 * std::abs(by_two - 3), "a third of the error");

  // What the increment does not close: half of the way that two increments took.
  const auto half = first_touch_weights(1, 2, {}, 0.5);
  check::is_close(half[0], -0.5, 1e-14, "to the end of the increment");
  const auto unsure = first_touch_weights(1, 2, 2 + 1e-3, 1);
  check::is_close(unsure[0], -1, 1e-14, "hardly another gap: a line");
  check::is_close(unsure[1], 0, 0, "without the third state");
  for (const auto &none : {first_touch_weights(-1e-3, 1, 2, 1), first_touch_weights(1, 0.5, 2, 1)})
    check::is_true(none[0] == 0 && none[1] == 0, "closed, or opening");
  return check::result();
}
} // namespace test_first_touch

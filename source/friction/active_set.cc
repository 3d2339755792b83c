#include <amontons/friction/active_set.h>

#include <cmath>

namespace Amontons
{
  unsigned int
  ActiveSetUpdate::update(const std::vector<double> &pressure,
                          const std::vector<double> &gap,
                          const std::vector<double> &c,
                          const double               tolerance,
                          std::vector<bool>         &closed)
  {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < closed.size(); ++i)
      {
        const double indicator = pressure[i] - c[i] * gap[i];
        if ((indicator > 0) != closed[i] && std::abs(indicator) > tolerance)
          wrong.push_back(i);
      }
    if (wrong.empty())
      return 0;

    if (wrong.size() < fewest)
      {
        fewest    = wrong.size();
        remaining = patience;
        single    = false;
      }
    else if (remaining > 0)
      --remaining;
    else
      single = true;

    if (single)
      wrong = {wrong.back()};
    for (const std::size_t i : wrong)
      closed[i] = !closed[i];
    return wrong.size();
  }
} // namespace Amontons

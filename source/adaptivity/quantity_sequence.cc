#include <amontons/adaptivity/quantity_sequence.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Amontons
{
  namespace
  {
    constexpr double smallest_rho = 0.4, largest_rho = 0.8;

    double
    rest_of(const double change_before, const double change)
    {
      if (change == 0 && change_before == 0)
        return 0;
      const double rho =
          change_before > 0 ? std::clamp(change / change_before, smallest_rho, largest_rho) : largest_rho;
      return std::max(change, smallest_rho * change_before) * rho / (1 - rho);
    }
  } // namespace

  void
  QuantitySequence::add(const double               n_dofs,
                        const std::vector<double> &values,
                        const double               least,
                        const std::vector<double> &doubts)
  {
    least_value = least;
    if (!meshes.empty() && meshes.back().n_dofs == n_dofs)
      meshes.pop_back();
    else
      settle();
    meshes.push_back({n_dofs, values, doubts});
    if (unseen && meshes.front().n_dofs == 0 && half_of(meshes.size() - 1) > 0)
      meshes.erase(meshes.begin());
  }

  void
  QuantitySequence::add_unseen(const std::vector<double> &values)
  {
    *this  = {};
    unseen = Mesh{0, values, {}};
  }

  void
  QuantitySequence::compare_with_unseen()
  {
    if (unseen)
      meshes = {*unseen};
  }

  void
  QuantitySequence::repeat()
  {
    settle();
    if (!meshes.empty())
      before = meshes.back().values;
  }

  void
  QuantitySequence::settle()
  {
    for (unsigned int k = 0; k < meshes.size(); ++k)
      for (unsigned int i = 0; i < before.size(); ++i)
        meshes[k].values[i] = value(k, i);
    before.clear();
  }

  double
  QuantitySequence::value(const unsigned int mesh, const unsigned int i) const
  {
    const bool is_earlier = !before.empty() && mesh + 1 < meshes.size();
    return meshes[mesh].values[i] + (is_earlier ? meshes.back().values[i] - before[i] : 0.);
  }

  // The changes from mesh to mesh shrink and keep their sign, or there is but one.
  bool
  QuantitySequence::settles(const unsigned int from, const unsigned int to, const unsigned int i) const
  {
    double before = 0;
    for (unsigned int k = from; k < to; ++k)
      {
        const double change = value(k + 1, i) - value(k, i);
        if (change * before < 0 || (before != 0 && std::abs(change) > std::abs(before)))
          return false;
        before = change;
      }
    return true;
  }

  // The last mesh of at most half as many DoFs as the k-th one; the number of meshes if there is none.
  unsigned int
  QuantitySequence::half_of(const unsigned int k) const
  {
    for (unsigned int i = k; i-- > 0;)
      if (2 * meshes[i].n_dofs <= meshes[k].n_dofs)
        return i;
    return meshes.size();
  }

  bool
  QuantitySequence::vanishes() const
  {
    return !meshes.empty() && std::all_of(meshes.begin(), meshes.end(), [](const Mesh &mesh) {
      return std::all_of(mesh.values.begin(), mesh.values.end(), [](const double v) { return v == 0; });
    });
  }

  bool
  QuantitySequence::keeps_on_changing() const
  {
    constexpr unsigned int n_changes = 3;
    const unsigned int     n         = meshes.size();
    for (unsigned int i = 0; n > n_changes && i < meshes.back().values.size(); ++i)
      {
        bool   goes_on = true;
        double before  = 0;
        for (unsigned int k = n - n_changes; k < n; ++k)
          {
            const double change = value(k, i) - value(k - 1, i);
            goes_on             = goes_on && change != 0 && change * before >= 0.8 * before * before;
            before              = change;
          }
        if (goes_on)
          return true;
      }
    return false;
  }

  double
  QuantitySequence::error(const bool is_smooth) const
  {
    const unsigned int n = meshes.size();
    if (n < 2)
      return std::numeric_limits<double>::infinity();
    const double before = error_on(n - 2, is_smooth);
    return std::max(
        {error_on(n - 1, is_smooth), std::isfinite(before) ? before / 4 : 0., doubt_on(n - 2) / 2});
  }

  double
  QuantitySequence::error_on(const unsigned int last, const bool is_smooth) const
  {
    const unsigned int n = meshes.size(), half = half_of(last), quarter = half < n ? half_of(half) : n;
    if (half == n || meshes[last].values.empty() || norm(last, 0) == 0)
      return std::numeric_limits<double>::infinity();
    double worst = 0;
    for (unsigned int i = 0; i < meshes[last].values.size(); ++i)
      {
        const auto change = [&](const unsigned int from, const unsigned int to) {
          double result = 0; // a number may happen to come back in between
          for (unsigned int k = from; k < to; ++k)
            result = std::max(result, std::abs(value(to, i) - value(k, i)));
          return result;
        };
        const double left =
            quarter < n
                ? rest_of(change(quarter, half), change(half, last))
                : std::max(change(half, last) *
                               (!is_smooth || settles(half, last, i) ? 1 : largest_rho / (1 - largest_rho)),
                           change(half > 0 ? half - 1 : 0, half) * smallest_rho * smallest_rho /
                               (1 - smallest_rho));
        worst = std::max(worst, left / norm(last, i));
      }
    return std::max(worst, doubt_on(last));
  }

  double
  QuantitySequence::norm(const unsigned int mesh, const unsigned int i) const
  {
    double largest = 0;
    for (unsigned int k = 0; k < meshes[mesh].values.size(); ++k)
      largest = std::max(largest, std::abs(value(mesh, k)));
    return std::max({std::abs(value(mesh, i)), least_of_largest * largest, least_value});
  }

  double
  QuantitySequence::spread() const
  {
    if (meshes.empty())
      return std::numeric_limits<double>::infinity();
    const unsigned int last = meshes.size() - 1, half = half_of(last),
                       quarter = half < last ? half_of(half) : meshes.size();
    if (quarter > last)
      return std::numeric_limits<double>::infinity();
    return change_since(quarter);
  }

  double
  QuantitySequence::change() const
  {
    return meshes.empty() ? 0 : change_since(0);
  }

  double
  QuantitySequence::change_since(const unsigned int first) const
  {
    const unsigned int last  = meshes.size() - 1;
    double             worst = 0;
    for (unsigned int i = 0; i < meshes[last].values.size(); ++i)
      for (unsigned int k = first; k < last; ++k)
        worst = std::max(worst, std::abs(value(last, i) - value(k, i)) / norm(last, i));
    return worst;
  }

  double
  QuantitySequence::doubt() const
  {
    return meshes.empty() ? 0 : doubt_on(meshes.size() - 1);
  }

  double
  QuantitySequence::doubt_on(const unsigned int last) const
  {
    constexpr double   enough = 0.75;
    const unsigned int half   = half_of(last);
    double             worst  = 0;
    for (unsigned int i = 0; half < meshes.size() && i < meshes[last].doubts.size(); ++i)
      if (const double now = meshes[last].doubts[i]; now > enough * meshes[half].doubts[i])
        worst = std::max(worst, now / norm(last, i));
    return worst;
  }
} // namespace Amontons

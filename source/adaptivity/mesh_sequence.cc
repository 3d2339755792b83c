#include <amontons/adaptivity/mesh_sequence.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Amontons
{
  void
  MeshSequence::add(const double n_dofs, const double error, const double growth, const bool has_limit)
  {
    least_growth = growth;
    always_falls = has_limit;
    if (!meshes.empty() && meshes.back().n_dofs == n_dofs)
      {
        meshes.pop_back();
        begin = std::min(begin, meshes.size());
      }
    if (error > 0 && std::isfinite(error))
      meshes.push_back({n_dofs, error});
  }

  void
  MeshSequence::add_lasting(const double n_dofs, const double error, const double target)
  {
    if (!lasting.empty() && lasting.back().n_dofs == n_dofs)
      lasting.pop_back();
    lasting.push_back({n_dofs, error});
    if (lasting.size() > 2)
      lasting.erase(lasting.begin());
    has_ended = lasting.size() == 2 && lasting[0].error > target && lasting[1].error > target &&
                lasting[1].error > 0.95 * lasting[0].error;
  }

  double
  MeshSequence::order() const
  {
    constexpr unsigned int n_refinements = 4;
    const unsigned int     first =
        meshes.size() > begin + 1 && meshes[begin + 1].error > meshes[begin].error ? begin + 1 : begin;
    if (meshes.size() <= first + n_refinements)
      return std::numeric_limits<double>::quiet_NaN();
    const auto &last = meshes.back();
    for (unsigned int i = meshes.size() - n_refinements; i-- > first;)
      if (last.n_dofs >= least_growth * meshes[i].n_dofs && last.error > 0)
        return std::log(meshes[i].error / last.error) / std::log(last.n_dofs / meshes[i].n_dofs);
    return std::numeric_limits<double>::quiet_NaN();
  }

  double
  MeshSequence::trend() const
  {
    constexpr unsigned int n = 9;
    if (meshes.size() < n || meshes.back().n_dofs < least_growth * meshes[meshes.size() - n].n_dofs)
      return std::numeric_limits<double>::quiet_NaN();
    double x = 0, y = 0, xx = 0, xy = 0;
    for (auto mesh = meshes.end() - n; mesh != meshes.end(); ++mesh)
      {
        const double log_n = std::log(mesh->n_dofs), log_e = std::log(mesh->error);
        x += log_n / n;
        y += log_e / n;
        xx += log_n * log_n / n;
        xy += log_n * log_e / n;
      }
    return -(xy - x * y) / (xx - x * x);
  }

  bool
  MeshSequence::stands_still() const
  {
    constexpr unsigned int n_refinements = 2;
    if (meshes.size() <= begin + n_refinements)
      return false;
    const auto &last = meshes.back(), &before = meshes[meshes.size() - 1 - n_refinements];
    return last.n_dofs >= least_growth * least_growth * before.n_dofs &&
           std::abs(last.error - before.error) <= 0.01 * before.error;
  }

  double
  MeshSequence::dofs_for(const double target) const
  {
    return dofs_at(stands_still() ? 0 : order(), target);
  }

  double
  MeshSequence::dofs_at(const double r, const double target) const
  {
    return std::isnan(r) ? r
           : r > 0       ? meshes.back().n_dofs * std::pow(meshes.back().error / target, 1 / r)
                         : std::numeric_limits<double>::infinity();
  }

  bool
  MeshSequence::is_hopeless(const double target, const double max_dofs) const
  {
    constexpr double least = 0.1;
    const double     far   = 10 * max_dofs;
    return has_ended || ((stands_still() || (!always_falls && order() < least)) && dofs_for(target) > far) ||
           (begin > 0 && !always_falls && trend() < least && dofs_at(trend(), target) > far);
  }

  std::string
  MeshSequence::why_missed(const double       target,
                           const double       max_dofs,
                           const std::string &place,
                           const std::string &reason) const
  {
    std::ostringstream text;
    text.precision(2);
    if (is_hopeless(target, max_dofs))
      {
        text << "warning: the target error is out of reach: the estimated error "
             << (has_ended                            ? "stays, with cells as small as they can be"
                 : !stands_still() && order() > 0.005 ? "hardly falls with the DoFs"
                                                      : "does not fall with the DoFs")
             << ", most of it is near (" << place << ")" << reason;
        return text.str();
      }
    text << "the target error was not reached: allow more 'Cycles' or 'Maximum DoFs'";
    if (const double dofs = dofs_for(target); dofs < 1e15)
      text << " (as the error has fallen so far, it would take about " << dofs << " DoFs)";
    return text.str();
  }
} // namespace Amontons

#include <amontons/adaptivity/unseen_contact.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  // At small strain gaps of points are those at rest. Where nothing touches the surfaces come nearer as they
  // are, by as much as the nodes beside.
  template <int dim>
  std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<dim> &interface,
                          const SurfaceFields<dim>    &fields,
                          const std::vector<double>   &gap_errors)
  {
    const auto       &slave = *interface.slave;
    std::vector<bool> unseen(slave.faces.size(), false);
    if (interface.pair->tied || std::any_of(fields.state.begin(), fields.state.end(), [](const auto state) {
          return state != ContactStatus::open;
        }))
      return unseen;
    const double        far = std::numeric_limits<double>::max();
    std::vector<double> approach(slave.nodes.size(), far);
    for (const auto &row : interface.coupling.rows)
      if (std::isfinite(fields.gap[row.node]))
        approach[row.node] = row.gap - fields.gap[row.node];
    std::vector<double> smallest(slave.faces.size(), far), largest(slave.faces.size(), -far);
    for (const auto &point : interface.coupling.points)
      {
        double least = far;
        for (const unsigned int node : slave.faces[point.slave_face].unknowns)
          least = std::min(least, approach[node]);
        if (least == far)
          continue;
        auto &s = smallest[point.slave_face], &l = largest[point.slave_face];
        s = std::min(s, point.gap - least);
        l = std::max(l, point.gap - least);
      }
    for (unsigned int f = 0; f < unseen.size(); ++f)
      {
        const double range = largest[f] - smallest[f];
        unseen[f] = gap_errors[f] > 0 || (range > 1e-6 * slave.faces[f].size && smallest[f] < 0.01 * range);
      }
    return unseen;
  }

  template std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<2> &, const SurfaceFields<2> &, const std::vector<double> &);
  template std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<3> &, const SurfaceFields<3> &, const std::vector<double> &);
} // namespace Amontons

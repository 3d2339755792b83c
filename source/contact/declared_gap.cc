#include <amontons/base/points.h>
#include <amontons/contact/declared_gap.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/surface_extent.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Amontons
{
  bool
  is_adjusted(const PairData &pair, const double gap, const double face_size)
  {
    return std::abs(gap) <= std::max(pair.adjust, 1e-10 * face_size);
  }

  namespace
  {
    // The gap that counts at a point where none is declared: closed by `Adjust`, or geometric. Numbers of
    // five digits make overlaps, of whatever size the faces are.
    template <int dim>
    void
    adjust_gap(const PairData &pair, const double face_size, const double surface_size, OverlapPoint<dim> &p)
    {
      if (is_adjusted(pair, p.gap, face_size))
        p.gap = 0;
      if (p.gap < -std::max(1e-4 * face_size, 1e-5 * surface_size) && !pair.tied)
        {
          std::ostringstream found;
          found << "the bodies overlap by " << -p.gap << " near (" << p.x_slave << ")";
          throw InputError(
              pair.where,
              found.str(),
              "declare an interference with 'Initial gap' (negative), close mesh gaps up to a size with "
              "'Adjust', declare round boundaries in 'Curved boundaries', or move the bodies apart");
        }
    }
  } // namespace

  template <int dim>
  DeclaredGap<dim>::DeclaredGap(const PairData &pair, const ContactSurface<dim> &slave, const double t)
      : gap(*pair.initial_gap), slave(slave), t(t)
  {
  }

  template <int dim>
  double
  DeclaredGap<dim>::at(const Point<dim> &X) const
  {
    return gap.value(as_3d(X), t);
  }

  template <int dim>
  bool
  DeclaredGap<dim>::jumps(const unsigned int face) const
  {
    if (!gap.may_jump())
      return false;
    const auto [it, is_new] = known.emplace(face, false);
    if (!is_new)
      return it->second;
    // In the middles of n parts along each direction: what jumps at a node is no jump inside.
    constexpr unsigned int n = dim == 2 ? 32 : 8;
    std::vector<double>    values;
    for (unsigned int q = 0; q < std::pow(n, dim - 1); ++q)
      {
        Point<dim - 1> xi;
        for (unsigned int d = 0, rest = q; d < dim - 1; ++d, rest /= n)
          xi[d] = (rest % n + 0.5) / n;
        values.push_back(at(slave.reference_position(face, xi)));
      }
    double     step       = 0;
    const auto look_along = [&](const double first, const double next) {
      step = std::max(step, std::abs(next - first));
    };
    for (unsigned int q = 0; q < values.size(); ++q)
      for (unsigned int d = 0, stride = 1; d < dim - 1; ++d, stride *= n)
        if (q / stride % n + 1 < n)
          look_along(values[q], values[q + stride]);
    if (!slave.faces[face].subdivision.empty()) // and beyond it, as far as its unknowns
      {
        Point<dim - 1> middle;
        for (unsigned int d = 0; d < dim - 1; ++d)
          middle[d] = 0.5;
        const Point<dim> centre = slave.reference_position(face, middle);
        for (const unsigned int node : slave.faces[face].unknowns)
          for (unsigned int q = 0; q < n; ++q)
            {
              values.push_back(at(centre + (q + 0.5) / n * (slave.nodes[node].X - centre)));
              if (q > 0)
                look_along(values[values.size() - 2], values.back());
            }
      }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return it->second        = step > 0.5 * (*most - *least);
  }

  template <int dim>
  double
  DeclaredGap<dim>::ramp(const unsigned int face, const Point<dim - 1> &xi) const
  {
    const auto &of     = slave.faces[face];
    const auto  traces = traces_of_unknowns(bernstein_values<dim - 1>(slave.degree, xi), of.subdivision);
    double      result = 0;
    for (unsigned int j = 0; j < traces.size(); ++j)
      result += traces[j] * at(slave.nodes[of.unknowns[j]].X);
    return result;
  }

  template <int dim>
  bool
  DeclaredGap<dim>::is_within_unknowns(const unsigned int face, const double least, const double most) const
  {
    std::vector<double> values;
    for (const unsigned int node : slave.faces[face].unknowns)
      values.push_back(at(slave.nodes[node].X));
    const auto [first, last] = std::minmax_element(values.begin(), values.end());
    const double rounding    = 1e-12 * (most - least);
    return *first <= least + rounding && *last >= most - rounding;
  }

  template <int dim>
  void
  declare_gaps(const PairData                 &pair,
               const ContactSurface<dim>      &slave,
               const double                    t,
               const bool                      moved,
               std::vector<OverlapPoint<dim>> &points)
  {
    if (!pair.initial_gap)
      {
        const double size = moved || points.empty() ? 0 : extent<dim>({&slave});
        for (auto &p : points)
          if (!moved)
            adjust_gap(pair, slave.faces[p.slave_face].size, size, p);
        return;
      }
    const DeclaredGap<dim> declared(pair, slave, t);
    for (auto &p : points)
      {
        const double gap = declared.jumps(p.slave_face) ? declared.ramp(p.slave_face, p.xi_slave)
                           : moved ? declared.at(slave.reference_position(p.slave_face, p.xi_slave))
                                   : declared.at(p.x_slave);
        p.gap            = moved ? p.gap + gap : gap;
      }
  }

  template <int dim>
  std::optional<Point<dim>>
  step_by_adjust(const PairData                       &pair,
                 const ContactSurface<dim>            &slave,
                 const std::vector<OverlapPoint<dim>> &points,
                 const NodalContacts<dim>             &contact)
  {
    if (pair.tied || pair.initial_gap || pair.adjust == 0)
      return {};
    std::vector<bool> has_none(slave.nodes.size(), false); // nodes of faces that touch
    for (const auto &p : points)
      if (const auto &nodes = slave.faces[p.slave_face].unknowns;
          p.gap == 0 && std::any_of(nodes.begin(), nodes.end(), [&](const unsigned int node) {
            return contact[node].state != ContactStatus::open;
          }))
        for (const unsigned int node : nodes)
          has_none[node] = true;
    for (const auto &p : points)
      if (pair.adjust < p.gap && p.gap < 2 * pair.adjust) // more: it is one of the bodies
        for (const unsigned int node : slave.faces[p.slave_face].unknowns)
          if (has_none[node])
            return p.x_slave;
    return {};
  }

  template class DeclaredGap<2>;
  template class DeclaredGap<3>;
  template void
  declare_gaps(
      const PairData &, const ContactSurface<2> &, const double, const bool, std::vector<OverlapPoint<2>> &);
  template void
  declare_gaps(
      const PairData &, const ContactSurface<3> &, const double, const bool, std::vector<OverlapPoint<3>> &);
  template std::optional<Point<2>>
  step_by_adjust(const PairData &,
                 const ContactSurface<2> &,
                 const std::vector<OverlapPoint<2>> &,
                 const NodalContacts<2> &);
  template std::optional<Point<3>>
  step_by_adjust(const PairData &,
                 const ContactSurface<3> &,
                 const std::vector<OverlapPoint<3>> &,
                 const NodalContacts<3> &);
} // namespace Amontons

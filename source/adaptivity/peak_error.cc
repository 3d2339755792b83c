#include <amontons/adaptivity/peak_error.h>
#include <amontons/contact/covered_shares.h>
#include <amontons/contact/surface_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Amontons
{
  namespace
  {
    struct Drop
    {
      double r = 0, value = 0;
    };

    // Whether p = a - c r^m through the three has m < 1/4. From one to the next the pressure falls by amounts
    // in the ratio (r_3^m - r_2^m)/(r_2^m - r_1^m), which grows with m; the peak itself, which is of the
    // mesh, does not count.
    bool
    has_no_limit(const std::array<Drop, 3> &drops)
    {
      constexpr double slow     = 0.25;
      const auto       fall     = [&](const unsigned int i) { return drops[i + 1].value - drops[i].value; };
      const auto       of_power = [&](const unsigned int i) {
        return std::pow(drops[i + 1].r, slow) - std::pow(drops[i].r, slow);
      };
      return fall(1) * of_power(0) < of_power(1) * fall(0);
    }

    // Along the direction in which the pressure falls most, by the largest drops in three rings around the
    // highest node, h apart from its neighbours; in the plane, where meshes are deep enough, so far away that
    // it makes no difference where in its face the peak is. Nothing is told where the rings reach beyond the
    // contact, or another peak; nor where the peak is round: within the first ring, from its inner nodes, the
    // pressure falls by 0.6 of what it falls from there to the next if m = 1/4, by 8/135 if m = 2.
    template <int dim>
    bool
    rises_for_ever(const ContactSurface<dim> &slave,
                   const SurfaceFields<dim>  &fields,
                   const unsigned int         top,
                   const double               h)
    {
      constexpr double visible = 0.01, narrow = 0.9, steady = 0.8, round = 0.2, first = dim == 2 ? 3.2 : 1.6,
                       wider = dim == 2 ? 4 : 2;
      const double peak      = shown_pressure(fields, top);
      const auto   drop      = [&](const unsigned int i) { return peak - shown_pressure(fields, i); };
      const auto   ring = [&](const double r) { return r < first * h ? 0 : r < wider * first * h ? 1 : 2; };
      const auto   from_top = [&](const unsigned int i) { return slave.nodes[i].x - slave.nodes[top].x; };
      std::vector<unsigned int> near;
      Tensor<1, dim>            down;
      double                    most = 0;
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        if (const double r = from_top(i).norm(); i != top && r < wider * wider * first * h)
          {
            near.push_back(i);
            if (shown_pressure(fields, i) > 0 && ring(r) == 1 && drop(i) > most)
              {
                most = drop(i);
                down = from_top(i) / r;
              }
          }
      std::array<Drop, 3> largest;
      double              least_far = peak, inner = 0;
      for (const unsigned int i : near)
        if (const double r = from_top(i).norm(); from_top(i) * down > narrow * r)
          {
            if (!(shown_pressure(fields, i) > 0))
              return false;
            Drop &of_ring = largest[ring(r)];
            if (drop(i) > of_ring.value)
              of_ring = {r, drop(i)};
            if (dim == 2 && r < 1.6 * h)
              inner = std::max(inner, drop(i));
            if (ring(r) == 2)
              least_far = std::min(least_far, drop(i));
          }
      return largest[0].r > 0 && largest[1].r > 0 && largest[2].r > 0 &&
             least_far > steady * largest[1].value && largest[1].value - largest[0].value > visible * peak &&
             (dim == 3 || largest[0].value - inner > round * (largest[1].value - largest[0].value)) &&
             has_no_limit(largest);
    }

    // The node on the axis stands for the disk around it, and its pressure falls short of p_0 - c r^m by
    // k c H^m, where H is the length of a face. With the drops from there to the next corners, q = d_2/d_1 =
    // (2^m - k)/(1 - k), and what is missing is k/(1 - k) d_1. Measured in degree 2: k = 0.83, 0.6, 0.43,
    // 0.33 for m = 0.1, 0.3, 0.5, 0.7, which makes it 0.4/(q - 1.35) d_1, to a factor of 0.6 to 1.6; smooth
    // peaks have q = 4, and none is seen from 2^(3/2). In degree 1 the first drop is not that regular: 1.7
    // to 2.2 d_1 for m = 0.3, 0.5, where q was 1.7 to 3.3.
    template <int dim>
    double
    missing_on_the_axis(const ContactSurface<dim> &slave,
                        const SurfaceFields<dim>  &fields,
                        const unsigned int         top,
                        const double               face)
    {
      const bool   linear = slave.faces.front().nodes.size() == 2;
      const double smooth = linear ? 4 : 2.83, most = 5;
      const double peak    = shown_pressure(fields, top);
      const auto   drop_at = [&](const double r) {
        unsigned int nearest  = top;
        const auto   distance = [&](const unsigned int i) {
          return std::abs(slave.nodes[i].x.distance(slave.nodes[top].x) - r);
        };
        for (unsigned int i = 0; i < slave.nodes.size(); ++i)
          if (distance(i) < distance(nearest))
            nearest = i;
        return shown_pressure(fields, nearest) > 0 ? peak - shown_pressure(fields, nearest) : 0.;
      };
      const double near = drop_at(face), far = drop_at(2 * face);
      if (!(near > 0 && far > 0 && far < smooth * near))
        return 0;
      if (linear)
        return 2 * near;
      const double excess = far / near - 1.35;
      return near * (0.4 < most * excess ? 0.4 / excess : most);
    }
  } // namespace

  template <int dim>
  PeakError
  peak_error(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields, const bool has_axis)
  {
    constexpr double smooth = 1.5, noteworthy = 1e-4, part = 0.25; // measured: n = 1.1, 1.3, 1.5
    const auto      &slave = *interface.slave;
    unsigned int     top   = 0;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      if (shown_pressure(fields, i) > shown_pressure(fields, top))
        top = i;
    const double peak = slave.nodes.empty() ? 0 : shown_pressure(fields, top);
    PeakError    result;
    if (!(peak > 0))
      return result;
    const auto distance = [&](const unsigned int i) { return slave.nodes[i].x.distance(slave.nodes[top].x); };
    double     h = std::numeric_limits<double>::max(), length = 0; // of edges, between nodes and corners
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      if (const auto &nodes = slave.faces[f].nodes; std::find(nodes.begin(), nodes.end(), top) != nodes.end())
        {
          result.faces.push_back(f);
          length = std::max({length, distance(nodes.front()), distance(nodes.back())});
          for (const unsigned int i : nodes)
            if (i != top)
              h = std::min(h, distance(i));
        }
    result.grows = rises_for_ever(slave, fields, top, h);
    if (has_axis && is_on_axis(slave, top))
      {
        const double missing = missing_on_the_axis(slave, fields, top, length);
        result.error         = missing > noteworthy * peak ? missing / peak : 0;
        return result;
      }
    double near = 0, far = 0; // largest drops
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      if (const double r = distance(i); i != top && r < 3.2 * h && shown_pressure(fields, i) > 0)
        {
          double &largest = r < 1.6 * h ? near : far;
          largest         = std::max(largest, peak - shown_pressure(fields, i));
        }
    if (near > noteworthy * peak && far < std::pow(2, smooth) * near)
      result.error = part * near / peak;
    return result;
  }

  template <int dim>
  void
  add_error_of_peaks(const Discretization<dim>                &discretization,
                     const std::vector<ContactInterface<dim>> &interfaces,
                     const std::vector<SurfaceFields<dim>>    &fields,
                     ErrorEstimate<dim>                       &estimate)
  {
    estimate.quantity_indicators.reinit(discretization.geometry.triangulation.n_active_cells());
    bool any_presses = false; // where it does, tied pairs do not count
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      any_presses = any_presses || (!interfaces[i].pair->tied && fields[i].peak_pressure > 0);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto &interface = interfaces[i];
        if (any_presses && interface.pair->tied)
          continue;
        const auto peak =
            peak_error(interface, fields[i], discretization.scene.kind == ProblemType::axisymmetric);
        estimate.cusp       = std::max(estimate.cusp, peak.error);
        estimate.cusp_grows = estimate.cusp_grows || peak.grows;
        std::vector<double> of_faces(interface.slave->faces.size(), 0.);
        for (const unsigned int f : peak.faces)
          of_faces[f] = peak.error;
        indicate_at_faces(discretization, interface, of_faces, estimate.quantity_indicators);
      }
  }

  template PeakError
  peak_error(const ContactInterface<2> &, const SurfaceFields<2> &, bool);
  template PeakError
  peak_error(const ContactInterface<3> &, const SurfaceFields<3> &, bool);
  template void
  add_error_of_peaks(const Discretization<2> &,
                     const std::vector<ContactInterface<2>> &,
                     const std::vector<SurfaceFields<2>> &,
                     ErrorEstimate<2> &);
  template void
  add_error_of_peaks(const Discretization<3> &,
                     const std::vector<ContactInterface<3>> &,
                     const std::vector<SurfaceFields<3>> &,
                     ErrorEstimate<3> &);
} // namespace Amontons

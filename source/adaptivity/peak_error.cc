#include <amontons/adaptivity/peak_error.h>
#include <amontons/contact/surface_fields.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Amontons
{
  template <int dim>
  PeakError
  peak_error(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields)
  {
    constexpr double smooth = 1.5, noteworthy = 1e-4, slow = 0.25,
                     part = 0.25; // measured: n = 1.1, 1.3, 1.5
    const auto  &slave    = *interface.slave;
    unsigned int top      = 0;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      if (shown_pressure(fields, i) > shown_pressure(fields, top))
        top = i;
    const double peak = slave.nodes.empty() ? 0 : shown_pressure(fields, top);
    PeakError    result;
    if (interface.pair->tied || !(peak > 0))
      return result;
    const auto distance = [&](const unsigned int i) { return slave.nodes[i].x.distance(slave.nodes[top].x); };
    double     h        = std::numeric_limits<double>::max();
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      if (const auto &nodes = slave.faces[f].nodes; std::find(nodes.begin(), nodes.end(), top) != nodes.end())
        {
          result.faces.push_back(f);
          for (const unsigned int i : nodes)
            if (i != top)
              h = std::min(h, distance(i));
        }
    double near = 0, far = 0; // largest drops
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      if (const double r = distance(i); i != top && r < 3.2 * h && shown_pressure(fields, i) > 0)
        {
          double &largest = r < 1.6 * h ? near : far;
          largest         = std::max(largest, peak - shown_pressure(fields, i));
        }
    if (near > noteworthy * peak && far < std::pow(2, smooth) * near)
      {
        result.error = part * near / peak;
        result.grows = far < std::pow(2, slow) * near;
      }
    return result;
  }

  template <int dim>
  void
  add_error_of_peaks(const Discretization<dim>                &discretization,
                     const std::vector<ContactInterface<dim>> &interfaces,
                     const std::vector<SurfaceFields<dim>>    &fields,
                     ErrorEstimate<dim>                       &estimate)
  {
    const unsigned int me = Utilities::MPI::this_mpi_process(discretization.geometry.communicator);
    estimate.cusp_indicators.reinit(discretization.geometry.triangulation.n_active_cells());
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto  &interface = interfaces[i];
        const auto   peak      = peak_error(interface, fields[i]);
        const double error     = peak.error;
        estimate.cusp          = std::max(estimate.cusp, error);
        estimate.cusp_grows    = estimate.cusp_grows || peak.grows;
        const auto add         = [&](const ContactSurface<dim> &side, const unsigned int face) {
          if (side.faces[face].rank == me)
            estimate.cusp_indicators[side.owned[side.faces[face].owned_index].first->active_cell_index()] =
                error;
        };
        if (error == 0)
          continue;
        for (const unsigned int f : peak.faces)
          add(*interface.slave, f);
        for (const auto &point : interface.coupling.points)
          if (interface.master_surface && std::count(peak.faces.begin(), peak.faces.end(), point.slave_face))
            add(*interface.master_surface, point.master_face);
      }
  }

  template PeakError
  peak_error(const ContactInterface<2> &, const SurfaceFields<2> &);
  template PeakError
  peak_error(const ContactInterface<3> &, const SurfaceFields<3> &);
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

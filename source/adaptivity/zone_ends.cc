#include <amontons/adaptivity/zone_ends.h>

#include <cmath>

namespace Amontons
{
  namespace
  {
    // By slave face, of its nodes: those inside and those outside that have something opposite.
    struct Part
    {
      unsigned int inside = 0, outside = 0;
    };

    template <int dim>
    std::vector<Part>
    parts_of_zone(const std::string           &name,
                  const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields)
    {
      std::vector<Part> result(interface.slave->faces.size());
      if (interface.pair->tied || (name == "stick size" && !interface.pair->has_friction()))
        return result;
      for (unsigned int f = 0; f < result.size(); ++f)
        for (const unsigned int i : interface.slave->faces[f].unknowns)
          if (name == "stick size" ? fields.state[i] == ContactStatus::stick
                                   : fields.state[i] != ContactStatus::open)
            ++result[f].inside;
          else if (!std::isnan(fields.gap[i]))
            ++result[f].outside;
      return result;
    }

    bool
    is_end(const Part &part)
    {
      return part.inside > 0 && part.outside > 0;
    }
  } // namespace

  template <int dim>
  std::vector<double>
  doubts_of_sizes(const std::string                        &name,
                  const std::vector<ContactInterface<dim>> &interfaces,
                  const std::vector<SurfaceFields<dim>>    &fields)
  {
    std::vector<double> result;
    for (unsigned int i = 0; dim == 2 && i < interfaces.size(); ++i)
      {
        const auto &slave = *interfaces[i].slave;
        const auto  parts = parts_of_zone(name, interfaces[i], fields[i]);
        double      whole = 0, at_ends = 0;
        for (unsigned int f = 0; f < parts.size(); ++f)
          {
            const double length = slave.faces[f].size;
            whole += length * parts[f].inside / slave.faces[f].nodes.size();
            at_ends += is_end(parts[f]) ? length / slave.degree : 0;
          }
        const double size = name == "stick size" ? fields[i].stick_size : fields[i].contact_size;
        result.push_back(whole > 0 ? at_ends / 4 * size / whole : 0);
      }
    return result;
  }

  template <int dim>
  void
  add_ends_of_sizes(const std::string                        &name,
                    const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<SurfaceFields<dim>>    &fields,
                    const bool                                is_needed,
                    ErrorEstimate<dim>                       &estimate)
  {
    estimate.quantity_indicators.reinit(discretization.geometry.triangulation.n_active_cells());
    for (unsigned int i = 0; is_needed && i < interfaces.size(); ++i)
      {
        const auto         &slave = *interfaces[i].slave;
        const auto          parts = parts_of_zone(name, interfaces[i], fields[i]);
        std::vector<double> lengths;
        lengths.reserve(parts.size());
        for (unsigned int f = 0; f < parts.size(); ++f)
          lengths.push_back(is_end(parts[f]) ? slave.faces[f].size : 0);
        indicate_at_faces(discretization, interfaces[i], lengths, estimate.quantity_indicators);
      }
  }

  template std::vector<double>
  doubts_of_sizes(const std::string &,
                  const std::vector<ContactInterface<2>> &,
                  const std::vector<SurfaceFields<2>> &);
  template std::vector<double>
  doubts_of_sizes(const std::string &,
                  const std::vector<ContactInterface<3>> &,
                  const std::vector<SurfaceFields<3>> &);
  template void
  add_ends_of_sizes(const std::string &,
                    const Discretization<2> &,
                    const std::vector<ContactInterface<2>> &,
                    const std::vector<SurfaceFields<2>> &,
                    const bool,
                    ErrorEstimate<2> &);
  template void
  add_ends_of_sizes(const std::string &,
                    const Discretization<3> &,
                    const std::vector<ContactInterface<3>> &,
                    const std::vector<SurfaceFields<3>> &,
                    const bool,
                    ErrorEstimate<3> &);
} // namespace Amontons

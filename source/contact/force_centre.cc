#include <amontons/contact/force_centre.h>
#include <amontons/contact/surface_fields.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    ForceCentre<dim>
    centre_of(const ContactInterface<dim> &interface, const std::vector<double> &pressure, const double least)
    {
      ForceCentre<dim>    result;
      double              force = 0, spread = 0;
      std::vector<double> forces;
      for (const auto &p : interface.coupling.points)
        {
          const double value = value_on_face(*interface.slave, pressure, p.slave_face, p.xi_slave);
          forces.push_back(std::max(least, value) * p.weight);
          force += forces.back();
          result.centre += forces.back() * p.x_slave;
        }
      if (!(force > 0))
        return {};
      result.centre /= force;
      for (unsigned int q = 0; q < forces.size(); ++q)
        spread += forces[q] * result.centre.distance_square(interface.coupling.points[q].x_slave);
      result.spread = std::sqrt(std::max(0., spread / force));
      return result;
    }
  } // namespace

  template <int dim>
  ForceCentre<dim>
  force_centre(const ContactInterface<dim> &interface, const std::vector<double> &pressure)
  {
    if (!interface.pair->tied)
      if (const auto all = centre_of(interface, pressure, std::numeric_limits<double>::lowest());
          all.spread > 0)
        return all;
    return centre_of(interface, pressure, 0.);
  }

  template ForceCentre<2>
  force_centre(const ContactInterface<2> &, const std::vector<double> &);
  template ForceCentre<3>
  force_centre(const ContactInterface<3> &, const std::vector<double> &);
} // namespace Amontons

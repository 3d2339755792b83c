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
      double              spread = 0;
      std::vector<double> forces;
      for (const auto &p : interface.coupling.points)
        {
          const double value = value_on_face(*interface.slave, pressure, p.slave_face, p.xi_slave);
          forces.push_back(std::max(least, value) * p.weight);
          result.force += forces.back();
          result.centre += forces.back() * p.x_slave;
        }
      if (!(result.force > 0))
        return {};
      result.centre /= result.force;
      for (unsigned int q = 0; q < forces.size(); ++q)
        spread += forces[q] * result.centre.distance_square(interface.coupling.points[q].x_slave);
      result.spread = std::sqrt(std::max(0., spread / result.force));
      return result;
    }
  } // namespace

  template <int dim>
  ForceCentre<dim>
  force_centre(const ContactInterface<dim> &interface, const std::vector<double> &pressure)
  {
    constexpr double swings = 1.1;
    const auto       pushes = centre_of(interface, pressure, 0.);
    if (interface.pair->tied)
      return pushes;
    const auto all = centre_of(interface, pressure, std::numeric_limits<double>::lowest());
    return all.spread > 0 && pushes.force > swings * all.force ? all : pushes;
  }

  template ForceCentre<2>
  force_centre(const ContactInterface<2> &, const std::vector<double> &);
  template ForceCentre<3>
  force_centre(const ContactInterface<3> &, const std::vector<double> &);
} // namespace Amontons

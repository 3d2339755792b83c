#include <amontons/base/points.h>
#include <amontons/friction/limit_load.h>
#include <amontons/solver/contact_region.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    // By slave face: whether its tractions count.
    template <int dim>
    std::vector<bool>
    touching_faces(const ContactInterface<dim> &interface,
                   const NodalContacts<dim>    &known,
                   const ContactRegion          region)
    {
      std::vector<bool> touches(interface.slave->faces.size(), region == ContactRegion::anywhere);
      for (unsigned int f = 0; f < touches.size(); ++f)
        for (const unsigned int node : interface.slave->faces[f].unknowns)
          touches[f] = touches[f] || (known[node].has_multiplier && known[node].state != ContactStatus::open);
      return touches;
    }

    // What is covered of the touching faces: points of quadrature formulas, drawn apart from the centre of
    // their piece until they reach its ends.
    template <int dim>
    std::vector<OverlapPoint<dim>>
    corners_of_region(const ContactInterface<dim> &interface, const std::vector<bool> &touches)
    {
      // In space none of the formulas that are used has its last point farther in.
      const double stretch =
          dim == 2 ? 1 / (1 - 2 * QGauss<1>(interface.slave->degree + 3).point(0)[0]) : 1.3;
      std::vector<OverlapPoint<dim>> result;
      const auto                    &points = interface.coupling.points;
      for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end)
        {
          const auto    &first = points[begin];
          double         area  = 0;
          Tensor<1, dim> centre;
          while (end < points.size() && points[end].slave_face == first.slave_face &&
                 points[end].master_face == first.master_face)
            {
              area += points[end].weight;
              centre += points[end].weight * points[end].x_slave;
              ++end;
            }
          centre /= area;
          if (touches[first.slave_face])
            for (std::size_t i = begin; i < end; ++i)
              {
                result.push_back(points[i]);
                result.back().x_slave = Point<dim>(centre + stretch * (points[i].x_slave - centre));
              }
        }
      return result;
    }

    // What rigid motions see of the tractions of one interface.
    template <int dim>
    class RegionForces
    {
    public:
      RegionForces(const FloatingBodies<dim>              &floating,
                   const std::vector<std::vector<double>> &motions,
                   const ContactInterface<dim>            &interface,
                   const unsigned int                      n_bodies)
          : floating(floating), motions(motions), slave(interface.slave->body),
            master(interface.master.surface != nullptr ? interface.master.surface->body
                                                       : n_bodies + interface.master.carrier)
      {
      }

      RigidContact
      at(const OverlapPoint<dim> &point, const double friction) const
      {
        RigidContact contact;
        contact.friction = friction;
        contact.sliding.resize(friction > 0 ? dim : 0);
        for (const auto &motion : motions)
          {
            const auto jump = floating.velocity(motion, slave, point.x_slave) -
                              floating.velocity(motion, master, point.x_slave);
            const double closing = jump * point.normal;
            contact.closing.push_back(closing);
            for (unsigned int c = 0; c < contact.sliding.size(); ++c)
              contact.sliding[c].push_back(jump[c] - closing * point.normal[c]);
          }
        return contact;
      }

    private:
      const FloatingBodies<dim>              &floating;
      const std::vector<std::vector<double>> &motions;
      const unsigned int                      slave, master;
    };
  } // namespace

  template <int dim>
  bool
  ends_at_an_edge(const ContactEquilibrium<dim> &problem, const ContactRegion region)
  {
    for (unsigned int i = 0; i < problem.interfaces.size(); ++i)
      {
        const auto &interface = problem.interfaces[i];
        if (interface.pair->tied)
          continue;
        const auto touches = touching_faces(interface, problem.state.contact[i], region);
        for (unsigned int f = 0; f < touches.size(); ++f)
          if (touches[f] && interface.coupling.whole_faces.count(f) == 0)
            return true;
      }
    return false;
  }

  template <int dim>
  std::vector<double>
  motion_beyond_region(const ContactEquilibrium<dim> &problem,
                       const FloatingBodies<dim>     &floating,
                       const ContactRegion            region)
  {
    constexpr double   unlimited = 1e3, margin = 1e-3;
    const unsigned int n_bodies = problem.discretization.scene.bodies.size();
    const auto         motions  = floating.free_rigid_modes(holding_equations(problem.contact.nodes(), true));
    std::vector<RigidContact> forces;
    for (unsigned int i = 0; i < problem.interfaces.size(); ++i)
      {
        const auto &interface = problem.interfaces[i];
        const auto &pair      = *interface.pair;
        if (pair.tied)
          continue;
        const RegionForces<dim> force(floating, motions, interface, n_bodies);
        const bool              has_bound =
            region == ContactRegion::closed && pair.friction && pair.friction->is_constant();
        for (const auto &point :
             corners_of_region(interface, touching_faces(interface, problem.state.contact[i], region)))
          forces.push_back(force.at(point,
                                    !pair.has_friction() ? 0
                                    : has_bound ? pair.friction->value(as_3d(point.x_slave), problem.state.t)
                                                : unlimited));
      }
    return combination(motions, motion_beyond_contact(floating.relative_work(motions), forces, margin));
  }

  template bool
  ends_at_an_edge(const ContactEquilibrium<2> &, const ContactRegion);
  template bool
  ends_at_an_edge(const ContactEquilibrium<3> &, const ContactRegion);
  template std::vector<double>
  motion_beyond_region(const ContactEquilibrium<2> &, const FloatingBodies<2> &, const ContactRegion);
  template std::vector<double>
  motion_beyond_region(const ContactEquilibrium<3> &, const FloatingBodies<3> &, const ContactRegion);
} // namespace Amontons

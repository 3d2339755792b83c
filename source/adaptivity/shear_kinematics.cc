#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/shear_kinematics.h>
#include <amontons/contact/common_normal.h>
#include <amontons/contact/face_basis.h>

namespace Amontons
{
  namespace
  {
    // Integral of p^2 |n - N|^2, where the coupling has N.
    template <int dim>
    double
    square_of_turns(const Scene                 &scene,
                    const ContactInterface<dim> &interface,
                    const NodalContacts<dim>    &contact)
    {
      double square = 0;
      for (const auto &point : interface.coupling.points)
        {
          const auto &nodes = interface.slave->faces[point.slave_face].nodes;
          const auto  N     = lagrange_values<dim - 1>(interface.slave->degree, point.xi_slave);
          double      p     = 0;
          for (unsigned int i = 0; i < N.size(); ++i)
            if (contact[nodes[i]].state != ContactStatus::open)
              p += N[i] * contact[nodes[i]].pressure;
          square +=
              point.weight * p * p * (common_normal(scene, interface, point) - point.normal).norm_square();
        }
      return square;
    }
  } // namespace

  template <int dim>
  std::optional<ShearKinematics>
  shear_kinematics(const Discretization<dim>                &discretization,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const std::vector<NodalContacts<dim>>    &contact,
                   const double                              turn)
  {
    const Scene &scene    = discretization.scene;
    double       pressure = 0, shear = 0, sticking = 0, turns = 0; // squares
    double       force = 0, shear_force = 0;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto &interface = interfaces[i];
        if (!interface.pair->has_friction())
          continue;
        for (const auto &row : interface.coupling.rows)
          {
            const auto  &node   = contact[i][row.node];
            const double square = row.area * node.shear.norm_square();
            force += row.area * node.pressure;
            shear_force += row.area * node.shear.norm();
            pressure += row.area * node.pressure * node.pressure;
            shear += square;
            sticking += node.state == ContactStatus::stick ? square : 0;
          }
        if (interface.master.surface != nullptr && !has_common_normals(discretization, interface))
          turns += square_of_turns(scene, interface, contact[i]);
      }
    if (pressure <= 0)
      return {};
    constexpr double more  = 6;
    const double     least = std::max(shear, std::pow(noteworthy_shear, 2) * pressure);
    return ShearKinematics{shear > 0 ? std::sqrt(1 + (more * more - 1) * sticking / shear) : 1.,
                           std::sqrt(turns / least) +
                               turn * force / std::max(shear_force, noteworthy_shear * force)};
  }

  template std::optional<ShearKinematics>
  shear_kinematics(const Discretization<2> &,
                   const std::vector<ContactInterface<2>> &,
                   const std::vector<NodalContacts<2>> &,
                   const double);
  template std::optional<ShearKinematics>
  shear_kinematics(const Discretization<3> &,
                   const std::vector<ContactInterface<3>> &,
                   const std::vector<NodalContacts<3>> &,
                   const double);
} // namespace Amontons

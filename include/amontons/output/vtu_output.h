// Pictures for ParaView: .pvd, .pvtu and .vtu of the bodies, .pvd and .vtu of the contact surfaces.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/elasticity/stress_recovery.h>

namespace Amontons
{
  // What is written of the bodies. All on the reference configuration; `displacement` is there to warp by.
  template <int dim>
  struct BodyFields
  {
    const Discretization<dim> &discretization;
    const LA::Vector          &displacement;
    const StressRecovery<dim> &recovery;
    const Vector<float>       &indicators; // by active cell
  };

  // Keeps the list of what was written: one object serves a whole run.
  class VtuOutput
  {
  public:
    VtuOutput(const std::string &folder, const MPI_Comm communicator);

    // bodies_0000.pvtu, bodies_0000.0.vtu, ..., bodies.pvd: displacement, stress_xx, ..., von_mises,
    // error_indicator, body (its number in the scene), subdomain. Collective.
    template <int dim>
    void
    write_bodies(const BodyFields<dim> &fields, const double t);

    // contact_0000.vtu, contact.pvd, of the slave surfaces: pressure, traction (tangential), gap, state (0
    // open, 1 slip, 2 stick), slip, normal, displacement, pair. Rank 0 writes.
    template <int dim>
    void
    write_contact(const std::vector<ContactInterface<dim>> &interfaces,
                  const std::vector<SurfaceFields<dim>>    &fields,
                  const double                              t);

    // Forgets what was written: the load program starts again on a refined mesh. Files are overwritten.
    void
    restart();

    // What was written before the last restart() and not overwritten since. Not collective.
    void
    remove_earlier() const;

  private:
    using Records = std::vector<std::pair<double, std::string>>; // time and file

    void
    write_records(const std::string &name, const Records &records) const;

    const std::string folder;
    const MPI_Comm    communicator;
    Records           bodies, contacts;
  };

  // The text of a .vtu file of the slave surfaces: lines (2D) or quadrilaterals (3D), each face divided by
  // its degree.
  template <int dim>
  std::string
  contact_vtu(const std::vector<ContactInterface<dim>> &interfaces,
              const std::vector<SurfaceFields<dim>>    &fields);
} // namespace Amontons

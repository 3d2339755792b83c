// The deformed mesh of a 2D scene and the pressure on the contact surfaces of a 3D one, for the report.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/elasticity/stress_recovery.h>
#include <amontons/output/summary.h>

#include <array>

namespace Amontons
{
  struct CellPicture
  {
    std::vector<float> outline; // x0, y0, x1, y1, ...: closed, counter-clockwise, current configuration
    float              value = 0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &outline &value;
    }
  };

  using MeshPicture = std::vector<CellPicture>;

  // The cells of all bodies with their von Mises stress, on rank 0; empty on the others and in 3D. Stresses
  // below `rounding` are zero. Collective.
  template <int dim>
  MeshPicture
  gather_mesh_picture(const Discretization<dim> &discretization,
                      const StressRecovery<dim> &recovery,
                      const LA::Vector          &displacement,
                      const double               rounding);

  // The slave faces of a 3D pair that lie opposite of the other side, with the pressure in their middles, by
  // two of their coordinates X; empty in 2D.
  template <int dim>
  MeshPicture
  make_pressure_picture(const ContactInterface<dim>       &interface,
                        const SurfaceFields<dim>          &fields,
                        const std::array<unsigned int, 2> &axes);

  // What a picture shows: centre and half the width of the square; half_width = 0: everything.
  struct Window
  {
    std::array<double, 2> centre     = {{0, 0}};
    double                half_width = 0;
  };

  // Cells coloured by their values, zero among them, with a colour bar. Cells of less than a pixel are drawn
  // as pixels, each once. Empty where a window shows next to everything. axes: names of the axes to be drawn
  // with numbers (empty: none).
  std::string
  svg_mesh(const MeshPicture                &picture,
           const Window                     &window,
           const std::string                &title,
           const std::array<std::string, 2> &axes = {});
} // namespace Amontons

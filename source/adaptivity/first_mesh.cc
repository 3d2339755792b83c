#include <amontons/adaptivity/first_mesh.h>
#include <amontons/adaptivity/smallest_cells.h>
#include <amontons/contact/surface_extent.h>

#include <deal.II/base/mpi.h>

namespace Amontons
{
  namespace
  {
    // Whether it was not marked before.
    template <int dim>
    bool
    mark_behind(const Discretization<dim> &discretization,
                const ContactSurface<dim> &surface,
                const unsigned int         face)
    {
      if (surface.faces[face].rank != Utilities::MPI::this_mpi_process(discretization.geometry.communicator))
        return false;
      const auto &cell = surface.owned[surface.faces[face].owned_index].first;
      if (!may_be_refined(discretization, cell) || cell->refine_flag_set())
        return false;
      cell->set_refine_flag();
      return true;
    }
  } // namespace

  // Faces in the zone that touches first, with which the first solution sees the contact.
  template <int dim>
  constexpr unsigned int enough = dim == 2 ? 8 : 24;

  // Of a face's size: surfaces whose gaps differ by less lie on each other, and all that they share touches.
  constexpr double level = 1e-3;

  template <int dim>
  unsigned int
  mark_close_cells(const Discretization<dim>                &discretization,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const double                              distance,
                   const bool                                flat_too)
  {
    unsigned int n_marked = 0;
    const auto   mark     = [&](const ContactSurface<dim> &surface, const unsigned int face) {
      n_marked += mark_behind(discretization, surface, face);
    };
    for (const auto &interface : interfaces)
      {
        double closest = std::numeric_limits<double>::max();
        for (const auto &point : interface.coupling.points)
          closest = std::min(closest, point.gap);
        const auto is_within = [&](const OverlapPoint<dim> &point, const double part) {
          return point.gap <= closest + part * interface.slave->faces[point.slave_face].size;
        };
        std::set<unsigned int> close;
        bool                   everywhere = true, flat = true;
        for (const auto &point : interface.coupling.points)
          {
            flat = flat && is_within(point, level);
            if (is_within(point, distance))
              close.insert(point.slave_face);
            else
              everywhere = false;
          }
        // (A few large faces may all meet where a point touches.)
        if ((flat && !flat_too) || close.size() >= enough<dim> ||
            (everywhere && close.size() == interface.slave->faces.size()))
          continue;
        for (const auto &point : interface.coupling.points)
          if (is_within(point, distance))
            {
              mark(*interface.slave, point.slave_face);
              if (interface.master_surface && point.master_face != numbers::invalid_unsigned_int)
                mark(*interface.master_surface, point.master_face);
            }
      }
    return Utilities::MPI::sum(n_marked, discretization.geometry.communicator);
  }

  template <int dim>
  unsigned int
  mark_cells_at_small_surfaces(const Discretization<dim>                &discretization,
                               const std::vector<ContactInterface<dim>> &interfaces)
  {
    constexpr double too_large = 2;
    unsigned int     n_marked  = 0;
    for (const auto &interface : interfaces)
      if (const auto &slave = *interface.slave; interface.master_surface)
        {
          const auto  &master  = *interface.master_surface;
          const double slave_s = extent<dim>({&slave}), master_s = extent<dim>({&master});
          for (const auto &point : interface.coupling.points)
            {
              if (slave.faces[point.slave_face].size > too_large * master_s)
                n_marked += mark_behind(discretization, slave, point.slave_face);
              if (point.master_face != numbers::invalid_unsigned_int &&
                  master.faces[point.master_face].size > too_large * slave_s)
                n_marked += mark_behind(discretization, master, point.master_face);
            }
        }
    return Utilities::MPI::sum(n_marked, discretization.geometry.communicator);
  }

  template unsigned int
  mark_close_cells(const Discretization<2> &,
                   const std::vector<ContactInterface<2>> &,
                   const double,
                   const bool);
  template unsigned int
  mark_cells_at_small_surfaces(const Discretization<2> &, const std::vector<ContactInterface<2>> &);
  template unsigned int
  mark_close_cells(const Discretization<3> &,
                   const std::vector<ContactInterface<3>> &,
                   const double,
                   const bool);
  template unsigned int
  mark_cells_at_small_surfaces(const Discretization<3> &, const std::vector<ContactInterface<3>> &);
} // namespace Amontons

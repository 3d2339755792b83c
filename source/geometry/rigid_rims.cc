#include <amontons/geometry/rigid_rims.h>

#include <deal.II/base/mpi.h>

#include <map>
#include <set>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // Of the boundaries of rigid bodies that touch.
    template <int dim>
    std::set<types::boundary_id>
    rigid_boundaries(const Scene &scene, const Geometry<dim> &geometry)
    {
      std::set<types::boundary_id> ids;
      for (const PairData &pair : scene.pairs)
        for (const auto *name : {&pair.first, pair.second ? &*pair.second : nullptr})
          if (name != nullptr)
            if (const auto &boundary = geometry.boundary(*name, scene); scene.bodies[boundary.body].rigid)
              {
                ids.insert(boundary.id);
                for (const auto &further : name->more)
                  ids.insert(geometry.boundary({name->body, further, name->where}, scene).id);
              }
      return ids;
    }

    // The middle of an arc of angle theta lies theta/8 of its length off the chord.
    bool
    is_long(const Triangulation<3>::line_iterator &line)
    {
      constexpr double largest_angle = 0.11;
      return line->center(true).distance(line->center()) > largest_angle / 8 * line->diameter();
    }

    bool
    refine_once(Geometry<3> &geometry, const std::set<types::boundary_id> &ids)
    {
      std::map<unsigned int, std::set<types::boundary_id>> faces_at; // by line
      const auto                                           for_lines = [&](const auto &action) {
        for (const auto &cell : geometry.triangulation.active_cell_iterators())
          if (!cell->is_artificial())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                for (unsigned int l = 0; l < 4; ++l)
                  action(cell, face->boundary_id(), face->line(l));
      };
      for_lines([&](const auto &, const auto id, const auto &line) { faces_at[line->index()].insert(id); });
      bool any = false;
      for_lines([&](const auto &cell, const auto id, const auto &line) {
        if (cell->is_locally_owned() && ids.count(id) > 0 && faces_at[line->index()].size() > 1 &&
            is_long(line))
          {
            cell->set_refine_flag();
            any = true;
          }
      });
      if (Utilities::MPI::max(any ? 1 : 0, geometry.communicator) == 0)
        return false;
      geometry.triangulation.execute_coarsening_and_refinement();
      return true;
    }
  } // namespace

  template <>
  void
  refine_rims_of_rigid_bodies(const Scene &, Geometry<2> &)
  {
  }

  template <>
  void
  refine_rims_of_rigid_bodies(const Scene &scene, Geometry<3> &geometry)
  {
    constexpr unsigned int most_times = 5; // a quarter of a circle by one chord
    const auto             ids        = rigid_boundaries(scene, geometry);
    for (unsigned int i = 0; !ids.empty() && i < most_times && refine_once(geometry, ids); ++i)
      ;
  }
} // namespace Amontons

#include <amontons/base/points.h>
#include <amontons/geometry/small_obstacles.h>

#include <deal.II/base/mpi.h>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int most_times = 12; // a face that is 4,000 times as large

    // Half the extent of the surface; 0: it is unbounded, or around the body.
    double
    radius_of(const ObstacleData &obstacle)
    {
      const bool is_round =
          obstacle.type == ObstacleData::Type::sphere || obstacle.type == ObstacleData::Type::cylinder;
      return obstacle.hollow ? 0 : is_round ? obstacle.radius : obstacle.size;
    }

    template <int dim>
    double
    distance_from_centre(const ObstacleData &obstacle, const Point<dim> &x)
    {
      Tensor<1, 3> r = as_3d(x) - obstacle.centre;
      if (dim == 3 && obstacle.type == ObstacleData::Type::cylinder)
        r -= (r * obstacle.axis) * obstacle.axis;
      return r.norm();
    }

    // Calls action(cell, face, distances of its closest point: at least, at most) for the own ones of a
    // boundary.
    template <int dim, typename Action>
    void
    for_each_distance(const Geometry<dim>             &geometry,
                      const dealii::types::boundary_id id,
                      const ObstacleData              &obstacle,
                      const Action                    &action)
    {
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (const auto face = cell->face(f); face->at_boundary() && face->boundary_id() == id)
              {
                const double middle  = distance_from_centre(obstacle, face->center());
                double       closest = middle;
                for (const unsigned int v : face->vertex_indices())
                  closest = std::min(closest, distance_from_centre(obstacle, face->vertex(v)));
                action(cell, f, middle - face->diameter() / 2, closest);
              }
    }

    // Whether faces were refined.
    template <int dim>
    bool
    refine_once(Geometry<dim> &geometry, const dealii::types::boundary_id id, const ObstacleData &obstacle)
    {
      constexpr unsigned int most_faces = dim == 2 ? 4 : 16; // about a place
      const double           radius     = radius_of(obstacle);
      double                 closest    = std::numeric_limits<double>::max();
      for_each_distance(
          geometry, id, obstacle, [&](const auto &, const unsigned int, const double, const double at_most) {
            closest = std::min(closest, at_most);
          });
      closest = dealii::Utilities::MPI::min(closest, geometry.communicator);
      if (closest <= std::sqrt(2.) * radius)
        return false;
      unsigned int n_marked = 0;
      for_each_distance(geometry,
                        id,
                        obstacle,
                        [&](const auto &cell, const unsigned int f, const double at_least, const double) {
                          if (at_least <= closest && cell->face(f)->diameter() > 2 * radius)
                            {
                              cell->set_refine_flag();
                              ++n_marked;
                            }
                        });
      n_marked = dealii::Utilities::MPI::sum(n_marked, geometry.communicator);
      if (n_marked == 0 || n_marked > most_faces)
        {
          for (const auto &cell : geometry.triangulation.active_cell_iterators())
            cell->clear_refine_flag();
          return false;
        }
      geometry.triangulation.execute_coarsening_and_refinement();
      return true;
    }
  } // namespace

  template <int dim>
  void
  refine_below_small_obstacles(const Scene &scene, Geometry<dim> &geometry)
  {
    for (const PairData &pair : scene.pairs)
      for (const ObstacleData &obstacle : scene.obstacles)
        if (const auto &boundary = geometry.boundary(pair.first, scene);
            obstacle.name == pair.obstacle && radius_of(obstacle) > 0 && !scene.bodies[boundary.body].rigid)
          for (unsigned int i = 0; i < most_times && refine_once(geometry, boundary.id, obstacle); ++i)
            ;
  }

  template void
  refine_below_small_obstacles(const Scene &, Geometry<2> &);
  template void
  refine_below_small_obstacles(const Scene &, Geometry<3> &);
} // namespace Amontons

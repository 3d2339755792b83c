#include <amontons/geometry/rigid_surface.h>
#include <amontons/geometry/small_obstacles.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

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

    // Whether faces were refined.
    template <int dim>
    bool
    refine_once(Geometry<dim> &geometry, const dealii::types::boundary_id id, const ObstacleData &obstacle)
    {
      constexpr unsigned int most_faces = dim == 2 ? 4 : 16; // about a place
      const double           radius     = radius_of(obstacle);

      // The closest vertex or middle of a face; faces that are too large, by how close they are at least.
      double closest = std::numeric_limits<double>::max();
      std::vector<std::pair<double, typename dealii::Triangulation<dim>::active_cell_iterator>> large;
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->boundary_id() == id)
              {
                const double middle = distance_from_axis(obstacle, face->center());
                closest             = std::min(closest, middle);
                for (const unsigned int v : face->vertex_indices())
                  closest = std::min(closest, distance_from_axis(obstacle, face->vertex(v)));
                if (face->diameter() > 2 * radius)
                  large.emplace_back(middle - face->diameter() / 2, cell);
              }
      closest              = dealii::Utilities::MPI::min(closest, geometry.communicator);
      const auto may_be_it = [&](const auto &face) { return face.first <= closest; };
      const auto n_faces   = dealii::Utilities::MPI::sum(
          static_cast<unsigned int>(std::count_if(large.begin(), large.end(), may_be_it)),
          geometry.communicator);
      if (closest <= std::sqrt(2.) * radius || n_faces == 0 || n_faces > most_faces)
        return false;
      for (const auto &face : large)
        if (may_be_it(face))
          face.second->set_refine_flag();
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

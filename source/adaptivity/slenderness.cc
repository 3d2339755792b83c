#include <amontons/adaptivity/slenderness.h>
#include <amontons/discretization/mirror_faces.h>
#include <amontons/elasticity/kirchhoff.h>
#include <amontons/geometry/boundary_ids.h>
#include <amontons/geometry/vector_area.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/grid/grid_tools.h>

#include <numeric>

namespace Amontons
{
  namespace
  {
    // The mean of a cell.
    template <int dim>
    Tensor<2, 3>
    mean_stress(const std::vector<Voigt<dim>> &points)
    {
      Tensor<2, 3> result;
      for (const auto &stress : points)
        result += as_tensor(stress) / double(points.size());
      return result;
    }

    // Bodies that are glued together bend as one: by body, the first of those.
    std::vector<unsigned int>
    glued_bodies(const Scene &scene)
    {
      std::vector<unsigned int> first(scene.bodies.size());
      std::iota(first.begin(), first.end(), 0);
      const auto number = [&](const std::string &name) -> unsigned int {
        return std::find_if(scene.bodies.begin(),
                            scene.bodies.end(),
                            [&](const BodyData &body) { return body.name == name; }) -
               scene.bodies.begin();
      };
      for (const auto &pair : scene.pairs)
        if (pair.tied && pair.second)
          {
            const unsigned int a = first[number(pair.first.body)], b = first[number(pair.second->body)];
            std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
          }
      return first;
    }

    // What one side of glue covers is no surface.
    template <int dim>
    std::set<types::boundary_id>
    glued_boundaries(const Discretization<dim> &discretization)
    {
      std::set<types::boundary_id> ids;
      for (const auto &pair : discretization.scene.pairs)
        if (pair.tied && pair.second)
          for (const auto *side : {&pair.first, &*pair.second})
            ids.merge(boundary_ids(discretization.geometry, discretization.scene, *side));
      return ids;
    }

    // Of one body: int dV, int s dV, int (s/E)^2 dV, int (c/E)^2 dV, int (s - 2 t)_+ dA
    using Sums = std::array<double, 5>;

    template <int dim, typename IsFree>
    void
    add_cell(const typename DoFHandler<dim>::active_cell_iterator &cell,
             const Tensor<2, 3>                                   &stress,
             const double                                          young,
             const IsFree                                         &is_free,
             double *const                                         sums)
    {
      const double size = stress.norm(), volume = cell->measure(),
                   compression = std::max(0., -eigenvalues(symmetrize(stress))[2]);
      sums[0] += volume;
      sums[1] += volume * size;
      sums[2] += volume * std::pow(size / young, 2);
      sums[3] += volume * std::pow(compression / young, 2);
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary() && is_free(face))
          {
            const auto   area = vector_area<dim>(face);
            Tensor<1, 3> normal;
            for (unsigned int c = 0; c < dim; ++c)
              normal[c] = area[c] / area.norm();
            sums[4] += face->measure() * std::max(0., size - 2 * (stress * normal).norm());
          }
    }
  } // namespace

  template <int dim>
  Stiffening
  most_stiffening(const Discretization<dim> &discretization, const StressRecovery<dim> &recovery)
  {
    const auto is_mirror = planes_of_symmetry(discretization);
    const auto body_of   = glued_bodies(discretization.scene);
    const auto glued     = glued_boundaries(discretization);
    const auto is_free   = [&](const auto &face) {
      return !is_mirror(face) && glued.count(face->boundary_id()) == 0;
    };
    const unsigned int  n_sums = std::tuple_size<Sums>::value;
    std::vector<double> sums(n_sums * body_of.size(), 0.);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        add_cell<dim>(cell,
                      mean_stress<dim>(recovery.unsmoothed(cell->active_cell_index())),
                      discretization.scene.bodies[cell->material_id()].material.young,
                      is_free,
                      &sums[n_sums * body_of[cell->material_id()]]);
    const auto &communicator = discretization.geometry.communicator;
    Utilities::MPI::sum(sums, communicator, sums);
    const auto corners =
        GridTools::compute_bounding_box(discretization.geometry.triangulation).get_boundary_points();
    const double size = Utilities::MPI::max(corners.first.distance(corners.second), communicator);
    Stiffening   result;
    for (unsigned int b = 0; b < body_of.size(); ++b)
      if (const double *const sum = &sums[n_sums * b]; sum[1] > 0)
        {
          const double slenderness = size * sum[4] / (2 * sum[1]),
                       factor = 48 / std::pow(numbers::PI, 2) * std::max(0., slenderness * slenderness - 25);
          result.any          = std::max(result.any, factor * std::sqrt(sum[2] / sum[0]));
          result.by_compression = std::max(result.by_compression, factor * std::sqrt(sum[3] / sum[0]));
        }
    return result;
  }

  template Stiffening
  most_stiffening(const Discretization<2> &, const StressRecovery<2> &);
  template Stiffening
  most_stiffening(const Discretization<3> &, const StressRecovery<3> &);
} // namespace Amontons

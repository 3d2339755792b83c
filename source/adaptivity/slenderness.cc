#include <amontons/adaptivity/slenderness.h>
#include <amontons/discretization/mirror_faces.h>
#include <amontons/elasticity/kirchhoff.h>
#include <amontons/geometry/vector_area.h>

#include <deal.II/grid/grid_tools.h>

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
  } // namespace

  template <int dim>
  double
  most_stiffening(const Discretization<dim> &discretization, const StressRecovery<dim> &recovery)
  {
    const unsigned int  n         = discretization.scene.bodies.size();
    const auto          is_mirror = planes_of_symmetry(discretization);
    std::vector<double> sums(4 * n, 0.); // by body: int dV, int s dV, int s^2 dV, int (s - 2 t)_+ dA
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          double *const sum    = &sums[4 * cell->material_id()];
          const auto    stress = mean_stress<dim>(recovery.unsmoothed(cell->active_cell_index()));
          const double  size = stress.norm(), volume = cell->measure();
          sum[0] += volume;
          sum[1] += volume * size;
          sum[2] += volume * size * size;
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && !is_mirror(face))
              {
                const auto   area = vector_area<dim>(face);
                Tensor<1, 3> normal;
                for (unsigned int c = 0; c < dim; ++c)
                  normal[c] = area[c] / area.norm();
                sum[3] += face->measure() * std::max(0., size - 2 * (stress * normal).norm());
              }
        }
    const auto &communicator = discretization.geometry.communicator;
    Utilities::MPI::sum(sums, communicator, sums);
    const auto corners =
        GridTools::compute_bounding_box(discretization.geometry.triangulation).get_boundary_points();
    const double size   = Utilities::MPI::max(corners.first.distance(corners.second), communicator);
    double       result = 0;
    for (unsigned int b = 0; b < n; ++b)
      if (const double *const sum = &sums[4 * b]; sum[1] > 0)
        {
          const double strain = std::sqrt(sum[2] / sum[0]) / discretization.scene.bodies[b].material.young,
                       slenderness = size * sum[3] / (2 * sum[1]);
          result                   = std::max(
              result, 48 / std::pow(numbers::PI, 2) * strain * std::max(0., std::pow(slenderness, 2) - 25));
        }
    return result;
  }

  template double
  most_stiffening(const Discretization<2> &, const StressRecovery<2> &);
  template double
  most_stiffening(const Discretization<3> &, const StressRecovery<3> &);
} // namespace Amontons

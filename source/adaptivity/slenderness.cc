#include <amontons/adaptivity/slenderness.h>
#include <amontons/elasticity/kirchhoff.h>
#include <amontons/geometry/vector_area.h>

#include <deal.II/grid/grid_tools.h>

#include <set>

namespace Amontons
{
  namespace
  {
    // Behind planes of symmetry, and behind the axis, the body goes on: they are no surfaces of it.
    template <int dim>
    std::set<types::boundary_id>
    cuts_of_symmetry(const Discretization<dim> &discretization)
    {
      std::set<types::boundary_id> result;
      for (const auto &condition : discretization.scene.conditions)
        if (condition.type == ConditionData::Type::symmetry)
          for (const auto &name : condition.boundaries)
            result.insert(discretization.geometry.boundary(name, discretization.scene).id);
      return result;
    }

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
    const auto corners =
        GridTools::compute_bounding_box(discretization.geometry.triangulation).get_boundary_points();
    const double extent =
        Utilities::MPI::max(corners.first.distance(corners.second), discretization.geometry.communicator);
    const auto is_on_axis = [&](const Point<dim> &x) {
      return discretization.scene.kind == ProblemType::axisymmetric && x[0] < 1e-10 * extent;
    };
    const unsigned int  n    = discretization.scene.bodies.size();
    const auto          cuts = cuts_of_symmetry(discretization);
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
            if (face->at_boundary() && cuts.count(face->boundary_id()) == 0 && !is_on_axis(face->center()))
              {
                const auto   area = vector_area<dim>(face);
                Tensor<1, 3> normal;
                for (unsigned int c = 0; c < dim; ++c)
                  normal[c] = area[c] / area.norm();
                sum[3] += face->measure() * std::max(0., size - 2 * (stress * normal).norm());
              }
        }
    Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
    double result = 0;
    for (unsigned int b = 0; b < n; ++b)
      if (const double *const sum = &sums[4 * b]; sum[1] > 0)
        {
          const double strain = std::sqrt(sum[2] / sum[0]) / discretization.scene.bodies[b].material.young,
                       slenderness = extent * sum[3] / (2 * sum[1]);
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

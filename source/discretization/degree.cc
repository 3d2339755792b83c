// The degree of the elements.
#include <amontons/discretization/discretization.h>
#include <amontons/geometry/vector_area.h>

#include <deal.II/base/mpi.templates.h>

namespace Amontons
{
  namespace
  {
    // Diameter times surface over volume, with the diameter of the cuboid that has the same moments of
    // inertia, sqrt(12 int |x - centre|^2 / V), however it is turned: 8 of balls, 10.4 of cubes, 12.2 of a
    // block of 2 x 1 x 1, 23 of a plate of 10 x 10 x 2, 42 of a beam of 10 x 1 x 1.
    template <int dim>
    std::vector<double>
    slenderness_of_bodies(const Geometry<dim> &geometry)
    {
      constexpr unsigned int n_sums = dim + 3; // int dV, int x dV, int x . x dV, int dA
      const unsigned int     n      = geometry.body_sizes.size();
      std::vector<double>    sums(n_sums * n, 0.);
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() < n)
          {
            double *const sum    = &sums[n_sums * cell->material_id()];
            const double  volume = cell->measure();
            const auto    centre = cell->center();
            sum[0] += volume;
            for (unsigned int d = 0; d < dim; ++d)
              sum[1 + d] += volume * centre[d];
            sum[dim + 1] += volume * centre.square();
            for (const unsigned int v : cell->vertex_indices()) // a third is that of a cuboid
              sum[dim + 1] += volume / 3 * (cell->vertex(v) - centre).norm_square() / cell->n_vertices();
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                sum[dim + 2] += vector_area<dim>(face).norm();
          }
      dealii::Utilities::MPI::sum(sums, geometry.communicator, sums);
      std::vector<double> result;
      for (unsigned int b = 0; b < n; ++b)
        {
          const double *const sum = &sums[n_sums * b];
          Point<dim>          centre;
          for (unsigned int d = 0; d < dim; ++d)
            centre[d] = sum[1 + d] / sum[0];
          const double diameter = std::sqrt(12 * std::max(0., sum[dim + 1] / sum[0] - centre.square()));
          result.push_back(diameter * sum[dim + 2] / sum[0]);
        }
      return result;
    }
  } // namespace

  void
  DiscretizationParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Discretization");
    prm.add_parameter(
        "Degree",
        degree,
        "Polynomial degree of the displacement: 1 or 2. Quadratic elements reach a given accuracy "
        "of force and contact size with far fewer unknowns. automatic: 2; in space 1 for a 'Target error' of "
        "0.5 % or more of the contact pressure, unless a body is slender or nearly incompressible, or facets "
        "of round ones make more than half of that.",
        Patterns::Selection("automatic|1|2"));
    prm.leave_subsection();
  }

  template <>
  unsigned int
  DiscretizationParameters::degree_for(const Scene &, const Geometry<2> &) const
  {
    return degree == "1" ? 1 : 2;
  }

  template <>
  unsigned int
  DiscretizationParameters::degree_for(const Scene &scene, const Geometry<3> &geometry) const
  {
    if (degree != "automatic" || !for_pressure)
      return degree == "1" ? 1 : 2;
    constexpr double slender = 16, nearly_incompressible = 0.49;
    const auto       slenderness = slenderness_of_bodies(geometry);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (const auto &body = scene.bodies[b];
          !body.rigid && (slenderness[b] > slender || body.material.poisson >= nearly_incompressible))
        return 2;
    return 1;
  }
} // namespace Amontons

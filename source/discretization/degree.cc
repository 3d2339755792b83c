// The degree of the elements.
#include <amontons/discretization/discretization.h>

#include <deal.II/base/mpi.templates.h>

namespace Amontons
{
  namespace
  {
    // Diameter times surface over volume: 10.4 of cubes and balls, 12.2 of a block of 2 x 1 x 1, 23 of a
    // plate of 10 x 10 x 2, 42 of a beam of 10 x 1 x 1. (Faces: half of the product of their diagonals.)
    template <int dim>
    std::vector<double>
    slenderness_of_bodies(const Geometry<dim> &geometry)
    {
      const unsigned int  n = geometry.body_sizes.size();
      std::vector<double> volume(n), surface(n);
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() < n)
          {
            volume[cell->material_id()] += cell->measure();
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                surface[cell->material_id()] +=
                    cross_product_3d(face->vertex(3) - face->vertex(0), face->vertex(2) - face->vertex(1))
                        .norm() /
                    2;
          }
      dealii::Utilities::MPI::sum(volume, geometry.communicator, volume);
      dealii::Utilities::MPI::sum(surface, geometry.communicator, surface);
      std::vector<double> result;
      for (unsigned int b = 0; b < n; ++b)
        result.push_back(geometry.body_sizes[b] * surface[b] / volume[b]);
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
        "0.5 % or more of the contact pressure, unless a body is slender or nearly incompressible.",
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
    constexpr double slender = 16, nearly_incompressible = 0.45;
    const auto       slenderness = slenderness_of_bodies(geometry);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (const auto &body = scene.bodies[b];
          !body.rigid && (slenderness[b] > slender || body.material.poisson >= nearly_incompressible))
        return 2;
    return 1;
  }
} // namespace Amontons

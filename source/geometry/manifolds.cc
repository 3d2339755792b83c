#include <amontons/geometry/cad_manifold.h>
#include <amontons/geometry/manifolds.h>

#include <deal.II/grid/manifold_lib.h>

#include <set>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    Point<dim>
    in_dimension(const Point<3> &p)
    {
      Point<dim> q;
      for (unsigned int d = 0; d < dim; ++d)
        q[d] = p[d];
      return q;
    }

    // From the centre or the axis.
    template <int dim>
    double
    distance(const Point<dim> &p, const TrueGeometry &shape)
    {
      Tensor<1, dim> d = p - in_dimension<dim>(shape.centre);
      if constexpr (dim == 3)
        if (shape.type == TrueGeometry::Type::cylinder)
          d -= (d * shape.axis) / shape.axis.norm_square() * shape.axis;
      return d.norm();
    }

    template <int dim>
    void
    check_vertices(const Boundary &boundary, const Scene &scene, const Triangulation<dim> &triangulation)
    {
      std::set<unsigned int> vertices;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary.id)
            for (const unsigned int v : face->vertex_indices())
              vertices.insert(face->vertex_index(v));

      double radius = 0, worst = 0;
      for (const unsigned int v : vertices)
        radius += distance<dim>(triangulation.get_vertices()[v], boundary.geometry) / vertices.size();
      for (const unsigned int v : vertices)
        worst = std::max(
            worst, std::abs(distance<dim>(triangulation.get_vertices()[v], boundary.geometry) - radius));
      if (!(worst <= 1e-3 * radius))
        throw InputError(scene.bodies[boundary.body].where,
                         "the vertices of boundary '" + boundary.name + "' are up to " +
                             std::to_string(worst) + " away from the circle, sphere or cylinder of radius " +
                             std::to_string(radius),
                         "a centre or axis about which they all have the same distance");
    }

    template <int dim>
    std::unique_ptr<Manifold<dim>>
    make_manifold(const TrueGeometry &shape)
    {
      if constexpr (dim == 3)
        if (shape.type == TrueGeometry::Type::cylinder)
          return std::make_unique<CylindricalManifold<3>>(shape.axis / shape.axis.norm(), shape.centre);
      return std::make_unique<SphericalManifold<dim>>(in_dimension<dim>(shape.centre));
    }
  } // namespace

  template <int dim>
  types::manifold_id
  attach_manifolds(const Scene &scene, const types::manifold_id first_free_id, Geometry<dim> &geometry)
  {
    types::manifold_id next_id = first_free_id;
    for (const Boundary &boundary : geometry.boundaries)
      if (boundary.geometry.type == TrueGeometry::Type::cad)
        {
          if constexpr (dim == 3)
            attach_cad_manifolds(boundary,
                                 scene.bodies[boundary.body],
                                 geometry.body_sizes[boundary.body],
                                 next_id,
                                 geometry.triangulation);
        }
      else if (boundary.geometry.type != TrueGeometry::Type::flat)
        {
          if (dim == 3 && boundary.geometry.type == TrueGeometry::Type::cylinder &&
              !(boundary.geometry.axis.norm() > 0))
            throw InputError(scene.bodies[boundary.body].where,
                             "the cylinder axis of boundary '" + boundary.name + "' is zero",
                             "a direction");
          check_vertices(boundary, scene, geometry.triangulation);
          geometry.triangulation.set_manifold(boundary.id, *make_manifold<dim>(boundary.geometry));
          for (const auto &cell : geometry.triangulation.cell_iterators_on_level(0))
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && face->boundary_id() == boundary.id)
                face->set_all_manifold_ids(boundary.id);
        }
    return next_id;
  }

  template <int dim>
  void
  attach_polar_manifold(const types::material_id body,
                        const TrueGeometry      &shape,
                        const types::manifold_id id,
                        Triangulation<dim>      &triangulation)
  {
    triangulation.set_manifold(id, *make_manifold<dim>(shape));
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (cell->material_id() == body)
        cell->set_all_manifold_ids(id);
  }

  template types::manifold_id
  attach_manifolds<2>(const Scene &, const types::manifold_id, Geometry<2> &);
  template types::manifold_id
  attach_manifolds<3>(const Scene &, const types::manifold_id, Geometry<3> &);
  template void
  attach_polar_manifold<2>(const types::material_id,
                           const TrueGeometry &,
                           const types::manifold_id,
                           Triangulation<2> &);
  template void
  attach_polar_manifold<3>(const types::material_id,
                           const TrueGeometry &,
                           const types::manifold_id,
                           Triangulation<3> &);
} // namespace Amontons

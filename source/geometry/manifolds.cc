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

    // Returns the radius.
    template <int dim>
    double
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
      return radius;
    }

    // deal.II's sphere takes points nearer than 1e-10 for one: here in units of its size, a power of two, so
    // that nothing is rounded by that.
    template <int dim>
    class SphereInUnits : public Manifold<dim>
    {
    public:
      SphereInUnits(const Point<dim> &centre, const double size) : centre(centre), size(size) {}

      std::unique_ptr<Manifold<dim>>
      clone() const override
      {
        return std::make_unique<SphereInUnits>(centre, size);
      }
      Point<dim>
      get_intermediate_point(const Point<dim> &p, const Point<dim> &q, const double w) const override
      {
        return back(unit.get_intermediate_point(in_units(p), in_units(q), w));
      }
      Tensor<1, dim>
      get_tangent_vector(const Point<dim> &p, const Point<dim> &q) const override
      {
        return size * unit.get_tangent_vector(in_units(p), in_units(q));
      }
      Point<dim>
      get_new_point(const ArrayView<const Point<dim>> &points,
                    const ArrayView<const double>     &weights) const override
      {
        const auto from = in_units(points);
        return back(unit.get_new_point(make_array_view(from), weights));
      }
      void
      get_new_points(const ArrayView<const Point<dim>> &points,
                     const Table<2, double>            &weights,
                     ArrayView<Point<dim>>              new_points) const override
      {
        const auto from = in_units(points);
        unit.get_new_points(make_array_view(from), weights, new_points);
        for (auto &p : new_points)
          p = back(p);
      }

    private:
      Point<dim>
      in_units(const Point<dim> &p) const
      {
        return Point<dim>((p - centre) / size);
      }
      std::vector<Point<dim>>
      in_units(const ArrayView<const Point<dim>> &points) const
      {
        std::vector<Point<dim>> result;
        for (const auto &p : points)
          result.push_back(in_units(p));
        return result;
      }
      Point<dim>
      back(const Point<dim> &p) const
      {
        return centre + size * Tensor<1, dim>(p);
      }

      const Point<dim>             centre;
      const double                 size;
      const SphericalManifold<dim> unit;
    };

    // radius: of a point on it, or in the body that follows it.
    template <int dim>
    std::unique_ptr<Manifold<dim>>
    make_manifold(const TrueGeometry &shape, const double radius)
    {
      if constexpr (dim == 3)
        if (shape.type == TrueGeometry::Type::cylinder)
          return std::make_unique<CylindricalManifold<3>>(
              shape.axis / shape.axis.norm(), shape.centre, 1e-10 * radius);
      return std::make_unique<SphereInUnits<dim>>(in_dimension<dim>(shape.centre),
                                                  std::ldexp(1., std::ilogb(radius)));
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
          const double radius = check_vertices(boundary, scene, geometry.triangulation);
          geometry.triangulation.set_manifold(boundary.id, *make_manifold<dim>(boundary.geometry, radius));
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
    double radius = 0;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (cell->material_id() == body)
        {
          cell->set_all_manifold_ids(id);
          radius = std::max(radius, distance<dim>(cell->vertex(0), shape));
        }
    triangulation.set_manifold(id, *make_manifold<dim>(shape, radius));
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

#include <amontons/adaptivity/pollution_error.h>
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/elasticity/kinematics.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/boost_adaptors/point.h>
#include <deal.II/numerics/rtree.h>

namespace Amontons
{
  namespace
  {
    // Sets of closed nodes that faces connect.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    closed_zones(const ContactSurface<dim> &slave, const SurfaceFields<dim> &fields)
    {
      std::vector<std::vector<unsigned int>> faces_at(slave.nodes.size()), zones;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        for (const unsigned int i : slave.faces[f].nodes)
          faces_at[i].push_back(f);
      std::vector<bool> seen; // or open
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        seen.push_back(!(shown_pressure(fields, i) > 0));
      for (unsigned int first = 0; first < seen.size(); ++first)
        if (!seen[first])
          {
            std::vector<unsigned int> zone = {first};
            seen[first]                    = true;
            for (unsigned int k = 0; k < zone.size(); ++k)
              for (const unsigned int f : faces_at[zone[k]])
                for (const unsigned int i : slave.faces[f].nodes)
                  if (!seen[i])
                    {
                      seen[i] = true;
                      zone.push_back(i);
                    }
            zones.push_back(zone);
          }
      return zones;
    }

    // Normals of the symmetry planes, with a point in each.
    template <int dim>
    std::vector<std::pair<Tensor<1, dim>, Point<dim>>>
    planes_through(const ContactSurface<dim> &slave, const std::vector<unsigned int> &zone)
    {
      std::vector<std::pair<Tensor<1, dim>, Point<dim>>> planes;
      for (const unsigned int i : zone)
        for (const auto &plane : slave.nodes[i].symmetry_planes)
          if (std::none_of(planes.begin(), planes.end(), [&](const auto &other) {
                return std::abs(other.first * plane) > 0.5;
              }))
            planes.emplace_back(plane, slave.nodes[i].x);
      return planes;
    }

    // From second moments about the centre: half the axes of the ellipse, of the interval or of the disc
    // around the axis that has the same.
    std::vector<double>
    half_axes(const SymmetricTensor<2, 3> &moments, const bool)
    {
      const auto of_axes = eigenvalues(moments);
      return {2 * std::sqrt(std::max(0., of_axes[1])), 2 * std::sqrt(std::max(0., of_axes[0]))};
    }
    std::vector<double>
    half_axes(const SymmetricTensor<2, 2> &moments, const bool is_disc)
    {
      const double square = std::max(0., eigenvalues(moments)[0]);
      return is_disc ? std::vector<double>(2, std::sqrt(2 * square))
                     : std::vector<double>(1, std::sqrt(3 * square));
    }

    // Half the lengths of a zone along its axes, least first; symmetry planes cut it. No less than half a
    // face: a node alone is as wide as those.
    template <int dim>
    std::vector<double>
    extents(const ContactSurface<dim>       &slave,
            const SurfaceFields<dim>        &fields,
            const std::vector<unsigned int> &zone,
            const ProblemType                kind,
            const double                     face)
    {
      const auto planes = planes_through(slave, zone);
      double     area   = 0;
      Point<dim> centre;
      const auto weight = [&](const unsigned int i) { return std::max(fields.area[i], 1e-300); };
      for (const unsigned int i : zone)
        area += weight(i);
      for (const unsigned int i : zone)
        centre += weight(i) / area * Tensor<1, dim>(slave.nodes[i].x);
      for (const auto &[plane, point] : planes)
        centre += ((point - centre) * plane) * plane;
      Tensor<2, dim> moments;
      for (const unsigned int i : zone)
        moments += weight(i) / area * outer_product(slave.nodes[i].x - centre, slave.nodes[i].x - centre);
      for (const auto &[plane, point] : planes) // the image has what is mixed with the other sign
        {
          const Tensor<2, dim> across = outer_product(plane, plane),
                               along  = unit_symmetric_tensor<dim>() - across;
          moments                     = across * moments * across + along * moments * along;
        }
      auto result = half_axes(symmetrize(moments), kind == ProblemType::axisymmetric && !planes.empty());
      for (double &length : result)
        length = std::max(length, face / 2);
      return result;
    }

    template <int dim>
    class Zones
    {
    public:
      Zones(const ContactSurface<dim> &slave, const SurfaceFields<dim> &fields, const ProblemType kind)
      {
        std::vector<double> face_at(slave.nodes.size(), 0.); // largest
        for (const auto &face : slave.faces)
          for (const unsigned int i : face.nodes)
            face_at[i] = std::max(face_at[i], face.size);
        std::vector<std::pair<Point<dim>, unsigned int>> closed;
        for (const auto &zone : closed_zones(slave, fields))
          {
            for (const unsigned int i : zone)
              closed.emplace_back(slave.nodes[i].x, half_lengths.size());
            half_lengths.push_back(extents(slave, fields, zone, kind, face_at[zone[0]]));
          }
        tree = pack_rtree(closed);
      }

      // (h/s)^(2 degree) / s min(1, b/s)^2 prod_i min(1, b_i/s) of a cell of length h; 0 less than its height
      // from the contact, where recovery sees its error, and without contact.
      double
      share(const Point<dim> &place, const double h, const double height, const unsigned int degree) const
      {
        std::vector<std::pair<Point<dim>, unsigned int>> nearest;
        tree.query(boost::geometry::index::nearest(place, 1), std::back_inserter(nearest));
        const double s = nearest.empty() ? 0 : place.distance(nearest[0].first);
        if (s <= height)
          return 0;
        constexpr double longest = 1.5; // measured: layers of cells up to 200 times as long as high
        const auto      &b       = half_lengths[nearest[0].second];
        double           result =
            std::pow(std::min(longest, h / s), 2 * degree) / s * std::pow(std::min(1., b[0] / s), 2);
        for (const double half_length : b)
          result *= std::min(1., half_length / s);
        return result;
      }

    private:
      RTree<std::pair<Point<dim>, unsigned int>> tree;         // nodes that press, with the zones they are in
      std::vector<std::vector<double>>           half_lengths; // of zones, least first
    };

    template <int dim>
    Point<dim>
    place_of(const Discretization<dim>                            &discretization,
             const typename DoFHandler<dim>::active_cell_iterator &cell,
             const LA::Vector                                     *displacement)
    {
      Point<dim> place = cell->center();
      if (displacement == nullptr)
        return place;
      const auto                          &fe = discretization.fe;
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        place[fe.system_to_component_index(i).first] += (*displacement)(dofs[i]) * dim / dofs.size();
      return place;
    }
  } // namespace

  template <int dim>
  PollutionError
  pollution_error(const Discretization<dim>   &discretization,
                  const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const double                 modulus,
                  const std::vector<double>   &bulk_squares,
                  const LA::Vector            *displacement)
  {
    // Measured, by degree: Hertz on a block and on a cantilever; spheres.
    constexpr std::array<double, 2> constants =
        dim == 2 ? std::array<double, 2>{{0.05, 0.5}} : std::array<double, 2>{{0.02, 0.2}};
    const unsigned int degree = discretization.fe.degree;
    PollutionError     result;
    if (interface.pair->tied)
      return result;
    const Zones<dim> zones(*interface.slave, fields, discretization.scene.kind);
    result.by_cell.resize(bulk_squares.size(), 0.);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && bulk_squares[cell->active_cell_index()] > 0 &&
          (cell->material_id() == interface.slave->body ||
           (interface.master_surface && cell->material_id() == interface.master_surface->body)))
        {
          const double young = discretization.scene.bodies[cell->material_id()].material.young,
                       size = std::pow(cell->measure(), 1. / dim), length = cell->diameter() / std::sqrt(dim),
                       height = cell->measure() / std::pow(length, dim - 1),
                       flat   = std::max(1., std::pow(length / size, 2) / 2.5),
                       share  = zones.share(place_of(discretization, cell, displacement),
                                           std::min(length, size * flat),
                                           std::max(height, size / flat),
                                           degree);
          auto &part          = result.by_cell[cell->active_cell_index()];
          part                = constants[degree - 1] * modulus * modulus / young * share *
                 bulk_squares[cell->active_cell_index()];
          result.square += part;
        }
    result.square = Utilities::MPI::sum(result.square, discretization.geometry.communicator);
    return result;
  }

  template PollutionError
  pollution_error(const Discretization<2> &,
                  const ContactInterface<2> &,
                  const SurfaceFields<2> &,
                  const double,
                  const std::vector<double> &,
                  const LA::Vector *);
  template PollutionError
  pollution_error(const Discretization<3> &,
                  const ContactInterface<3> &,
                  const SurfaceFields<3> &,
                  const double,
                  const std::vector<double> &,
                  const LA::Vector *);
} // namespace Amontons

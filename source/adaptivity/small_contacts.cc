#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/small_contacts.h>
#include <amontons/adaptivity/smallest_cells.h>
#include <amontons/base/directions.h>
#include <amontons/contact/surface_fields.h>

#include <deal.II/lac/householder.h>

#include <set>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int n_terms = 4; // of a fitted gap: 1, x_1, x_2, |x|^2/2

    // By slave face: of the pressure, and which points it has.
    struct FaceLoad
    {
      double              force = 0;
      std::vector<size_t> points;
    };

    std::vector<FaceLoad>
    loads_of_faces(const ContactInterface<3> &interface, const SurfaceFields<3> &fields)
    {
      std::vector<FaceLoad> result(interface.slave->faces.size());
      const auto           &points = interface.coupling.points;
      for (size_t q = 0; q < points.size(); ++q)
        {
          auto &face = result[points[q].slave_face];
          face.points.push_back(q);
          face.force +=
              points[q].weight *
              value_on_face(*interface.slave, fields.pressure, points[q].slave_face, points[q].xi_slave);
        }
      for (auto &face : result)
        face.force *= fields.symmetry_factor;
      return result;
    }

    // By slave face: with those that share a node with it.
    std::vector<double>
    forces_around(const ContactSurface<3> &slave, const std::vector<FaceLoad> &loads)
    {
      std::vector<std::set<unsigned int>> faces_of(slave.nodes.size());
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        for (const unsigned int i : slave.faces[f].nodes)
          faces_of[i].insert(f);
      std::vector<double> result(loads.size(), 0.);
      for (unsigned int f = 0; f < loads.size(); ++f)
        {
          std::set<unsigned int> around;
          for (const unsigned int i : slave.faces[f].nodes)
            around.insert(faces_of[i].begin(), faces_of[i].end());
          for (const unsigned int g : around)
            result[f] += std::max(0., loads[g].force);
        }
      return result;
    }

    struct Paraboloid
    {
      double radius;
      size_t apex; // the point nearest to it
    };

    // Fitted to the gaps of a face; none if that is not convex, or has its apex elsewhere.
    std::optional<Paraboloid>
    fit(const ContactInterface<3> &interface, const unsigned int face, const std::vector<size_t> &points)
    {
      if (points.size() < 2 * n_terms)
        return {};
      const auto         &all      = interface.coupling.points;
      const auto          tangents = directions_left<3>({all[points[0]].normal});
      const auto         &centre   = interface.slave->faces[face].centre;
      const double        size     = interface.slave->faces[face].size;
      FullMatrix<double>  matrix(points.size(), n_terms);
      Vector<double>      gaps(points.size()), c(n_terms);
      std::vector<double> x1, x2;
      for (unsigned int k = 0; k < points.size(); ++k)
        {
          const auto &p = all[points[k]];
          x1.push_back((p.x_slave - centre) * tangents[0] / size);
          x2.push_back((p.x_slave - centre) * tangents[1] / size);
          matrix(k, 0) = 1;
          matrix(k, 1) = x1[k];
          matrix(k, 2) = x2[k];
          matrix(k, 3) = (x1[k] * x1[k] + x2[k] * x2[k]) / 2;
          gaps[k]      = p.gap / size;
        }
      Householder<double>(matrix).least_squares(c, gaps);
      const auto distance = [&](const unsigned int k) {
        return std::hypot(c[3] * x1[k] + c[1], c[3] * x2[k] + c[2]) / c[3];
      };
      if (!(c[3] > 0))
        return {};
      unsigned int nearest = 0;
      for (unsigned int k = 1; k < points.size(); ++k)
        if (distance(k) < distance(nearest))
          nearest = k;
      constexpr double beside = 0.25;
      if (distance(nearest) > beside)
        return {};
      return Paraboloid{size / c[3], points[nearest]};
    }
  } // namespace

  template <>
  std::vector<SmallContact<2>>
  small_contacts(const Discretization<2> &,
                 const std::vector<ContactInterface<2>> &,
                 const std::vector<SurfaceFields<2>> &)
  {
    return {};
  }

  namespace
  {
    constexpr double noteworthy = 0.05; // of the largest force

    struct Spot
    {
      double                       force;
      std::vector<SmallContact<3>> sides;
    };

    // Of a pair; largest: force so far.
    void
    add_spots(const ContactInterface<3> &interface,
              const SurfaceFields<3>    &fields,
              const double               modulus,
              double                    &largest,
              std::vector<Spot>         &spots)
    {
      constexpr double small  = 0.5;
      const auto      &slave  = *interface.slave;
      const auto       loads  = loads_of_faces(interface, fields);
      const auto       forces = forces_around(slave, loads);
      for (unsigned int f = 0; f < loads.size(); ++f)
        {
          largest = std::max(largest, forces[f]);
          if (loads[f].force <= noteworthy * forces[f])
            continue;
          const auto paraboloid = fit(interface, f, loads[f].points);
          if (!paraboloid)
            continue;
          const double size = std::cbrt(0.75 * forces[f] * paraboloid->radius / modulus);
          if (size > small * slave.faces[f].size)
            continue;
          const auto &apex = interface.coupling.points[paraboloid->apex];
          Spot        spot{forces[f], {{slave.body, slave.reference_position(f, apex.xi_slave), size}}};
          if (const auto *master = interface.master_surface.get();
              master != nullptr && apex.master_face != numbers::invalid_unsigned_int)
            spot.sides.push_back(
                {master->body, master->reference_position(apex.master_face, apex.xi_master), size});
          spots.push_back(std::move(spot));
        }
    }
  } // namespace

  template <>
  std::vector<SmallContact<3>>
  small_contacts(const Discretization<3>                &discretization,
                 const std::vector<ContactInterface<3>> &interfaces,
                 const std::vector<SurfaceFields<3>>    &fields)
  {
    std::vector<Spot> spots;
    double            largest = 0;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (!interfaces[i].pair->tied)
        add_spots(
            interfaces[i], fields[i], combined_modulus(discretization.scene, interfaces[i]), largest, spots);
    std::vector<SmallContact<3>> result;
    for (const auto &spot : spots)
      if (spot.force > noteworthy * largest)
        result.insert(result.end(), spot.sides.begin(), spot.sides.end());
    return result;
  }

  template <int dim>
  unsigned int
  mark_cells_at(const Discretization<dim> &discretization, const std::vector<SmallContact<dim>> &contacts)
  {
    // The boundary of a cell on a round body is outside of its vertices' box.
    constexpr double bulge = 0.2, nearby = 0.5;
    unsigned int     n_marked = 0;
    for (const auto &cell : discretization.geometry.triangulation.active_cell_iterators())
      if (may_be_refined(discretization, cell))
        {
          const double size = cell->diameter() / std::sqrt(dim);
          const auto   box  = cell->bounding_box().get_boundary_points();
          if (std::any_of(contacts.begin(), contacts.end(), [&](const SmallContact<dim> &contact) {
                if (contact.body != cell->material_id() || size <= contact.size)
                  return false;
                Tensor<1, dim> away;
                for (unsigned int d = 0; d < dim; ++d)
                  away[d] = std::max({0., box.first[d] - contact.place[d], contact.place[d] - box.second[d]});
                return away.norm() <= std::max(nearby * contact.size, bulge * size);
              }))
            {
              cell->set_refine_flag();
              ++n_marked;
            }
        }
    return Utilities::MPI::sum(n_marked, discretization.geometry.communicator);
  }

  template unsigned int
  mark_cells_at(const Discretization<2> &, const std::vector<SmallContact<2>> &);
  template unsigned int
  mark_cells_at(const Discretization<3> &, const std::vector<SmallContact<3>> &);
} // namespace Amontons

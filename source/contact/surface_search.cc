#include <amontons/contact/declared_gap.h>
#include <amontons/contact/surface_extent.h>
#include <amontons/contact/surface_search.h>
#include <amontons/geometry/rigid_surface.h>

#include <deal.II/numerics/rtree.h>

#include <set>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // Beyond the closest distance, gaps matter up to this: half the size of the smaller surface; obstacles
    // have none.
    template <int dim>
    double
    depth_of_search(const ContactInterface<dim> &interface)
    {
      const double slave = extent<dim>({interface.slave.get()});
      return interface.master.surface == nullptr
                 ? 1e3 * slave
                 : 0.5 * std::min(slave, extent<dim>({interface.master.surface}));
    }

    // Bodies may be brought together across an initial gap.
    template <int dim>
    double
    closest_distance(const ContactInterface<dim> &interface, const MPI_Comm communicator)
    {
      if (interface.master.surface == nullptr)
        return 0;
      std::vector<std::pair<Point<dim>, unsigned int>> centres;
      for (const auto &face : interface.master.surface->faces)
        centres.emplace_back(face.centre, centres.size());
      const auto tree    = pack_rtree(centres);
      double     closest = std::numeric_limits<double>::max();
      for (const auto &face : interface.slave->faces)
        if (face.rank == Utilities::MPI::this_mpi_process(communicator))
          closest = std::min(
              closest,
              tree.qbegin(boost::geometry::index::nearest(face.centre, 1))->first.distance(face.centre));
      return Utilities::MPI::min(closest, communicator);
    }

    template <int dim>
    std::vector<OverlapPoint<dim>>
    overlaps_within(const double                 search_distance,
                    const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const bool                   moved)
    {
      return find_overlaps(*interface.pair,
                           *interface.slave,
                           interface.master,
                           search_distance,
                           discretization.scene.kind == ProblemType::axisymmetric,
                           discretization.geometry.communicator,
                           moved,
                           interface.wanted_faces);
    }

    // Where nothing is opposite within the search distance, surfaces may face each other farther away, as a
    // piston and the end of its cylinder do, whose walls are near. Then the search goes on from there.
    template <int dim>
    std::vector<OverlapPoint<dim>>
    look_farther(const Discretization<dim> &discretization, ContactInterface<dim> &interface)
    {
      const double farthest = interface.master.surface == nullptr
                                  ? std::numeric_limits<double>::max()
                                  : extent<dim>({interface.slave.get(), interface.master.surface});
      double       closest  = std::numeric_limits<double>::max();
      for (const auto &p : overlaps_within(farthest, discretization, interface, false))
        if (p.gap >= 0)
          closest = std::min(closest, p.gap);
      if (closest == std::numeric_limits<double>::max())
        return {};
      interface.search_distance = depth_of_search(interface) + 2 * closest;
      return overlaps_within(interface.search_distance, discretization, interface, false);
    }

    template <int dim>
    BoundingBox<dim>
    box_of_body(const Discretization<dim> &discretization, const unsigned int body)
    {
      std::vector<double> lower(dim, std::numeric_limits<double>::max()), upper = lower;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                lower[d] = std::min(lower[d], cell->vertex(v)[d]);
                upper[d] = std::min(upper[d], -cell->vertex(v)[d]);
              }
      Utilities::MPI::min(lower, discretization.geometry.communicator, lower);
      Utilities::MPI::min(upper, discretization.geometry.communicator, upper);
      std::pair<Point<dim>, Point<dim>> corners;
      for (unsigned int d = 0; d < dim; ++d)
        {
          corners.first[d]  = lower[d];
          corners.second[d] = -upper[d];
        }
      return BoundingBox<dim>(corners);
    }

    std::string
    name_of(const BoundaryName &boundary)
    {
      std::string name = "'" + boundary.body + "/" + boundary.boundary;
      for (const std::string &further : boundary.more)
        name += ", " + boundary.body + "/" + further;
      return name + "'";
    }

    std::string
    sides_of(const PairData &pair)
    {
      return name_of(pair.first) + " and " +
             (pair.second ? name_of(*pair.second) : "the obstacle '" + pair.obstacle + "'");
    }

    // What the user can mend.
    template <int dim>
    std::string
    sides_that_face(const ContactInterface<dim> &interface)
    {
      using Type                 = ObstacleData::Type;
      const auto *const obstacle = interface.master.obstacle;
      if (obstacle == nullptr)
        return "boundaries of two bodies that look at each other";
      if (obstacle->type == Type::sphere || obstacle->type == Type::cylinder)
        return "an obstacle that looks at the boundary: see its Centre, Radius and Hollow (true: the body is "
               "inside)";
      return "an obstacle that looks at the boundary: see its Centre and Normal (from the obstacle towards "
             "the "
             "body)";
    }

    // A surface that lies behind the other one, farther away than the body there is thick, does not overlap
    // it: the two look away from each other.
    template <int dim>
    void
    refuse_backs(const Discretization<dim>            &discretization,
                 const ContactInterface<dim>          &interface,
                 const std::vector<OverlapPoint<dim>> &points)
    {
      const auto is_behind = [&](const OverlapPoint<dim> &p) {
        return p.gap < -1e-4 * interface.slave->faces[p.slave_face].size;
      };
      if (std::none_of(points.begin(), points.end(), is_behind))
        return;
      auto box = box_of_body(discretization, interface.slave->body);
      box.extend(interface.slave->mean_size); // curvature between the vertices
      for (const auto &p : points)
        if (is_behind(p) && !box.point_inside(p.x_master))
          {
            std::ostringstream found;
            found << sides_of(*interface.pair) << " look away from each other: near (" << p.x_slave
                  << ") the other side is " << -p.gap << " behind the surface, on the far side of its body";
            throw InputError(interface.pair->where, found.str(), sides_that_face(interface));
          }
    }
    // The part of the line from a to b that lies in the box, as fractions of its length; nothing if empty.
    template <int dim>
    std::optional<std::pair<double, double>>
    part_in_box(const BoundingBox<dim> &box, const Point<dim> &a, const Point<dim> &b)
    {
      double     begin = 0, end = 1;
      const auto corners = box.get_boundary_points();
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double length = b[d] - a[d];
          double       low = corners.first[d] - a[d], high = corners.second[d] - a[d];
          if (length == 0 && (low > 0 || high < 0))
            return {};
          if (length == 0)
            continue;
          if (length < 0)
            std::swap(low, high);
          begin = std::max(begin, low / length);
          end   = std::min(end, high / length);
        }
      return begin < end ? std::make_optional(std::make_pair(begin, end)) : std::nullopt;
    }

    // Whether the line meets a cell of one of the bodies.
    template <int dim>
    bool
    meets_bodies(const Discretization<dim>       &discretization,
                 const std::set<unsigned int>    &bodies,
                 const std::array<Point<dim>, 2> &line)
    {
      bool meets = false;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (!meets && cell->is_locally_owned() && bodies.count(cell->material_id()) > 0)
          if (const auto part = part_in_box(cell->bounding_box(), line[0], line[1]))
            for (const double x : {0.25, 0.5, 0.75})
              {
                const double at = part->first + x * (part->second - part->first);
                meets           = meets || cell->point_inside(line[0] + at * (line[1] - line[0]));
              }
      return Utilities::MPI::max(static_cast<unsigned int>(meets), discretization.geometry.communicator) > 0;
    }

    // Whether nothing lies between a point and what is opposite. Near the ends, where cells are not as curved
    // as the surfaces, nothing is looked for; nor across gaps of about a face.
    template <int dim>
    bool
    sees_other_side(const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const OverlapPoint<dim>     &p)
    {
      const double               gap      = p.normal * (p.x_master - p.x_slave);
      const double               slave    = interface.slave->faces[p.slave_face].size;
      const ContactSurface<dim> *other    = interface.master.surface;
      const double               master   = other == nullptr ? 0 : other->faces[p.master_face].size;
      const ObstacleData *const  obstacle = interface.master.obstacle;
      if (obstacle != nullptr && obstacle->hollow && gap > 1e-3 * slave &&
          distance_from_axis(*obstacle, p.x_slave) > obstacle->radius)
        return false;
      if (gap < std::max(slave, master))
        return true;
      std::set<unsigned int> bodies = {interface.slave->body};
      if (other != nullptr)
        bodies.insert(other->body);
      return !meets_bodies<dim>(
          discretization,
          bodies,
          {{p.x_slave + 0.25 * slave * p.normal, p.x_master - 0.25 * master * p.normal}});
    }

    bool
    stays(const MotionData &motion)
    {
      const auto is_zero = [](const auto &value) { return !value || value->is_zero(); };
      return std::all_of(motion.displacement.begin(), motion.displacement.end(), is_zero) &&
             std::all_of(motion.rotation.begin(), motion.rotation.end(), is_zero) &&
             std::all_of(motion.force.begin(), motion.force.end(), [](const auto &f) { return f.is_zero(); });
    }

    // Within what an endless plane bounds: there nothing ever comes to face it.
    template <int dim>
    bool
    lies_behind(const Discretization<dim> &discretization, const ContactInterface<dim> &interface)
    {
      const auto *const plane = interface.master.obstacle;
      if (!discretization.finite_strain || plane == nullptr || plane->type != ObstacleData::Type::plane ||
          plane->size > 0)
        return false;
      const unsigned int body   = interface.slave->body;
      const auto        &centre = discretization.geometry.body_centres[body];
      double             height = 0, length = 0;
      for (unsigned int d = 0; d < dim; ++d)
        {
          height += (centre[d] - plane->centre[d]) * plane->normal[d];
          length += plane->normal[d] * plane->normal[d];
        }
      return height < -0.1 * std::sqrt(length) * discretization.geometry.body_sizes[body];
    }
  } // namespace

  template <int dim>
  void
  refuse_hidden_sides(const Discretization<dim>                &discretization,
                      const std::vector<ContactInterface<dim>> &interfaces)
  {
    for (const auto &interface : interfaces)
      {
        if (lies_behind(discretization, interface))
          throw InputError(interface.pair->where,
                           sides_of(*interface.pair) +
                               " do not face each other: the body lies behind the plane",
                           sides_that_face(interface));
        if (!must_face(discretization, *interface.pair))
          continue;
        bool         sees = false;
        unsigned int face = numbers::invalid_unsigned_int;
        for (const auto &p : interface.coupling.points) // one of each face, until one sees the other side
          if (!sees && p.slave_face != face)
            {
              face = p.slave_face;
              sees = sees_other_side(discretization, interface, p);
            }
        if (!sees)
          throw not_facing(interface,
                           interface.master.surface == nullptr
                               ? "the boundary lies on the back of the obstacle"
                               : "one of the two bodies lies between them everywhere");
      }
  }

  template <int dim>
  std::set<std::string>
  walls_beside(const Geometry<dim> &geometry, const std::vector<ContactInterface<dim>> &interfaces)
  {
    constexpr double      some_way = 0.02; // of the body
    std::set<std::string> result;
    for (const auto &interface : interfaces)
      if (const auto *obstacle = interface.master.obstacle;
          obstacle != nullptr && !interface.pair->initial_gap && stays(obstacle->motion))
        {
          double closest = std::numeric_limits<double>::max();
          for (const auto &p : interface.coupling.points)
            closest = std::min(closest, p.gap);
          if (closest > some_way * geometry.body_sizes[interface.slave->body])
            result.insert(interface.pair->name);
        }
    return result;
  }

  template <int dim>
  std::vector<const OverlapPoint<dim> *>
  nearest_points(const ContactInterface<dim> &interface)
  {
    const auto                            &slave = *interface.slave;
    std::vector<double>                    distance(slave.nodes.size(), std::numeric_limits<double>::max());
    std::vector<const OverlapPoint<dim> *> result(slave.nodes.size(), nullptr);
    for (const auto &p : interface.coupling.points)
      for (const unsigned int n : slave.faces[p.slave_face].unknowns)
        if (const double d = p.x_slave.distance_square(slave.nodes[n].x); d < distance[n])
          {
            distance[n] = d;
            result[n]   = &p;
          }
    return result;
  }

  template <int dim>
  bool
  must_face(const Discretization<dim> &discretization, const PairData &pair)
  {
    return pair.tied || !discretization.finite_strain;
  }

  template <int dim>
  InputError
  not_facing(const ContactInterface<dim> &interface, const std::string &why)
  {
    const PairData &pair = *interface.pair;
    return InputError(pair.where,
                      sides_of(pair) + " do not face each other: " + why,
                      sides_that_face(interface) +
                          (pair.tied ? ""
                                     : "; those that come to face each other only as they move need "
                                       "'Kinematics = finite strain'"));
  }

  template <int dim>
  std::vector<OverlapPoint<dim>>
  find_partners(const Discretization<dim> &discretization, ContactInterface<dim> &interface, const bool moved)
  {
    const PairData &pair = *interface.pair;
    if (interface.search_distance == 0)
      interface.search_distance =
          depth_of_search(interface) + 2 * closest_distance(interface, discretization.geometry.communicator);
    auto points = overlaps_within(interface.search_distance, discretization, interface, moved);
    if (!moved)
      {
        if (points.empty())
          points = look_farther(discretization, interface);
        if (points.empty() && must_face(discretization, pair))
          throw not_facing(interface, "along the normals nothing of one is opposite of the other");
        refuse_backs(discretization, interface, points);
      }
    declare_gaps(pair, *interface.slave, interface.t, moved, points);
    return points;
  }

  template std::vector<OverlapPoint<2>>
  find_partners(const Discretization<2> &, ContactInterface<2> &, const bool);
  template void
  refuse_hidden_sides(const Discretization<2> &, const std::vector<ContactInterface<2>> &);
  template void
  refuse_hidden_sides(const Discretization<3> &, const std::vector<ContactInterface<3>> &);
  template std::set<std::string>
  walls_beside(const Geometry<2> &, const std::vector<ContactInterface<2>> &);
  template std::set<std::string>
  walls_beside(const Geometry<3> &, const std::vector<ContactInterface<3>> &);
  template std::vector<const OverlapPoint<2> *>
  nearest_points(const ContactInterface<2> &);
  template bool
  must_face(const Discretization<2> &, const PairData &);
  template std::vector<const OverlapPoint<3> *>
  nearest_points(const ContactInterface<3> &);
  template bool
  must_face(const Discretization<3> &, const PairData &);
  template InputError
  not_facing(const ContactInterface<2> &, const std::string &);
  template std::vector<OverlapPoint<3>>
  find_partners(const Discretization<3> &, ContactInterface<3> &, const bool);
  template InputError
  not_facing(const ContactInterface<3> &, const std::string &);
} // namespace Amontons

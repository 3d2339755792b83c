#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/elasticity/kinematics.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    template <int dim>
    bool
    has_closed_node(const SurfaceFace<dim> &face, const SurfaceFields<dim> &fields)
    {
      return std::any_of(face.unknowns.begin(), face.unknowns.end(), [&](const unsigned int node) {
        return fields.state[node] != ContactStatus::open;
      });
    }

    // Of the gaps on each slave face that has a row. is_seen: nothing is looked for between the points.
    template <int dim>
    std::vector<FaceGaps>
    gaps_on_faces(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const SurfaceApproach<dim>  &approach,
                  const std::vector<bool>     &is_seen)
    {
      const auto &slave  = *interface.slave;
      auto        result = gaps_by_face(slave, interface.coupling.points, approach);
      for (unsigned int f = 0; f < result.size(); ++f)
        {
          auto       &gaps  = result[f];
          const auto &nodes = slave.faces[f].unknowns;
          if (std::all_of(
                  nodes.begin(), nodes.end(), [&](const auto i) { return std::isnan(fields.gap[i]); }))
            gaps = {};
          constexpr double may_be_near = 0.3; // of what the gap varies by
          if (gaps.range() >= 0 && !is_seen[f] && gaps.smallest < may_be_near * gaps.range())
            gaps.smallest = smallest_gap(interface, f, gaps, approach, interface.slave->moved);
        }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<dim> &interface,
                          const SurfaceFields<dim>    &fields,
                          const SurfaceApproach<dim>  &approach,
                          const std::vector<double>   &gap_errors,
                          const std::vector<bool>     &near,
                          const double                 modulus,
                          const ProblemType            kind)
  {
    const auto       &slave = *interface.slave;
    std::vector<bool> unseen(slave.faces.size(), false);
    if (interface.pair->tied)
      return unseen;
    const bool   is_off     = n_closed_nodes(fields) == 0;
    const auto   gaps       = gaps_on_faces(interface, fields, approach, near);
    const double noteworthy = 0.01 * fields.normal_force.norm();
    for (unsigned int f = 0; f < unseen.size(); ++f)
      {
        const auto  &face      = slave.faces[f];
        const double range     = gaps[f].range();
        const bool   may_touch = range > 1e-6 * face.size && gaps[f].smallest < 0.01 * range;
        // What overlaps so far from there would press with E* d, in space along the width of the face.
        const double force =
            -gaps[f].smallest * modulus * measure<dim>(kind, face.centre) * (dim == 3 ? face.size : 1);
        unseen[f] = is_off ? gap_errors[f] > 0 || may_touch : !near[f] && may_touch && force > noteworthy;
      }
    return unseen;
  }

  template <int dim>
  std::vector<bool>
  faces_that_press(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields)
  {
    std::vector<bool> result;
    for (const auto &face : interface.slave->faces)
      result.push_back(has_closed_node(face, fields));
    return result;
  }

  template <int dim>
  std::vector<bool>
  faces_near_contact(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields)
  {
    const ContactSurface<dim> &slave = *interface.slave;
    std::vector<bool>          near(slave.faces.size(), interface.pair->tied), marked;
    for (const double p : fields.pressure)
      marked.push_back(p != 0);
    for (unsigned int layer = 0; layer < 3; ++layer)
      {
        for (unsigned int f = 0; f < near.size(); ++f)
          near[f] = near[f] || std::any_of(slave.faces[f].nodes.begin(),
                                           slave.faces[f].nodes.end(),
                                           [&](const unsigned int i) { return marked[i]; });
        for (unsigned int f = 0; f < near.size(); ++f)
          for (const unsigned int i : slave.faces[f].nodes)
            marked[i] = marked[i] || near[f];
      }
    return near;
  }

  namespace
  {
    // Where a line ends other than on a plane that may be one of symmetry, or on the axis: in a corner of the
    // body. Of a line with few faces, all are at its ends: there are none.
    std::vector<Point<2>>
    ends_of(const ContactSurface<2> &surface)
    {
      constexpr unsigned int    few = 8;
      std::vector<unsigned int> n_faces(surface.nodes.size(), 0);
      for (const auto &face : surface.faces)
        for (const unsigned int i : {face.nodes.front(), face.nodes.back()})
          ++n_faces[i];
      double length = 0, largest_end = 0;
      for (const auto &face : surface.faces)
        {
          length += face.size;
          if (n_faces[face.nodes.front()] == 1 || n_faces[face.nodes.back()] == 1)
            largest_end = std::max(largest_end, face.size);
        }
      if (few * largest_end > length)
        return {};
      std::vector<Point<2>> ends;
      for (unsigned int i = 0; i < n_faces.size(); ++i)
        if (n_faces[i] == 1 && !surface.nodes[i].is_on_plane)
          ends.push_back(surface.nodes[i].X);
      return ends;
    }

    // In space not asked for: beside a hanging node lines of a surface have one face, too.
    std::vector<Point<3>>
    ends_of(const ContactSurface<3> &)
    {
      return {};
    }

    // Sharp edges of either side, where a contact is as small as any mesh.
    template <int dim>
    std::vector<Point<dim>>
    edges_of(const ContactInterface<dim> &interface)
    {
      constexpr double        sharp = 30; // degrees
      std::vector<Point<dim>> edges;
      for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
        if (surface != nullptr)
          {
            if (surface->sharpest_edge > sharp)
              edges.push_back(surface->sharpest_at);
            const auto ends = ends_of(*surface);
            edges.insert(edges.end(), ends.begin(), ends.end());
          }
      return edges;
    }
  } // namespace

  template <int dim>
  unsigned int
  n_closed_nodes(const SurfaceFields<dim> &fields)
  {
    return std::count_if(fields.state.begin(), fields.state.end(), [](const auto state) {
      return state != ContactStatus::open;
    });
  }

  template <int dim>
  double
  smallest_gap_of(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const SurfaceApproach<dim>  &approach)
  {
    const std::vector<bool> none(interface.slave->faces.size(), false);
    double                  smallest = std::numeric_limits<double>::max();
    for (const auto &gaps : gaps_on_faces(interface, fields, approach, none))
      smallest = std::min(smallest, gaps.smallest);
    return smallest;
  }

  template <int dim>
  double
  smallest_gap_of_untouched(const std::vector<ContactInterface<dim>> &interfaces,
                            const std::vector<SurfaceFields<dim>>    &fields)
  {
    double smallest = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (!interfaces[i].pair->tied && n_closed_nodes(fields[i]) == 0)
        for (const auto &row : interfaces[i].coupling.rows)
          smallest = std::min(smallest, fields[i].gap[row.node]); // not a NaN
    return smallest;
  }

  namespace
  {
    // Of the faces with a node in such a state; 0 if there are none.
    template <int dim, typename Predicate>
    double
    smallest_face(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const Predicate             &is_wanted)
    {
      double smallest = std::numeric_limits<double>::max();
      for (const auto &face : interface.slave->faces)
        if (std::any_of(face.unknowns.begin(), face.unknowns.end(), [&](const unsigned int node) {
              return is_wanted(fields.state[node]);
            }))
          smallest = std::min(smallest, face.size);
      return smallest < std::numeric_limits<double>::max() ? smallest : 0;
    }
  } // namespace

  template <int dim>
  double
  smallest_closed_face(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields)
  {
    return smallest_face(
        interface, fields, [](const ContactStatus state) { return state != ContactStatus::open; });
  }

  template <int dim>
  bool
  contact_is_resolved(const ContactInterface<dim> &interface,
                      const SurfaceFields<dim>    &fields,
                      const double                 enough)
  {
    const auto edges = edges_of(interface);
    double     area  = 0;
    for (const auto &face : interface.slave->faces)
      {
        area += std::pow(face.size, dim - 1);
        if (!has_closed_node(face, fields))
          continue;
        Point<dim> centre; // at rest, as edges are
        for (const unsigned int n : face.nodes)
          centre += interface.slave->nodes[n].X / double(face.nodes.size());
        if (std::any_of(edges.begin(), edges.end(), [&](const auto &edge) {
              return centre.distance(edge) < 2 * face.size;
            }))
          return true;
      }
    constexpr double point    = 1e-5; // of the surface
    const double     smallest = smallest_closed_face(interface, fields);
    return n_closed_nodes(fields) >= enough ||
           (smallest > 0 && smallest < point * std::pow(area, 1. / (dim - 1)));
  }

  namespace
  {
    // With more than a millionth of the largest force.
    template <int dim>
    std::vector<bool>
    pairs_that_press(const std::vector<ContactInterface<dim>> &interfaces,
                     const std::vector<SurfaceFields<dim>>    &fields)
    {
      std::vector<double> forces;
      forces.reserve(interfaces.size());
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        forces.push_back(
            interfaces[i].pair->tied ? 0. : (fields[i].normal_force + fields[i].tangential_force).norm());
      const double      largest = forces.empty() ? 0. : *std::max_element(forces.begin(), forces.end());
      std::vector<bool> result;
      result.reserve(forces.size());
      for (const double force : forces)
        result.push_back(force > 1e-6 * largest);
      return result;
    }
  } // namespace

  template <int dim>
  double
  height_in_doubt(const std::vector<ContactInterface<dim>> &interfaces,
                  const std::vector<SurfaceFields<dim>>    &fields)
  {
    const auto presses = pairs_that_press(interfaces, fields);
    double     doubt   = 0;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (!presses[i] || n_closed_nodes(fields[i]) >= enough_closed_nodes<dim>)
          continue;
        const auto &faces = interfaces[i].slave->faces;
        const auto  gaps  = gaps_by_face(
            *interfaces[i].slave, interfaces[i].coupling.points, SurfaceApproach<dim>(interfaces[i]));
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (has_closed_node(faces[f], fields[i]))
            doubt = std::max(doubt, gaps[f].range());
      }
    return doubt;
  }

  template <int dim>
  std::vector<bool>
  unresolved_pairs(const std::vector<ContactInterface<dim>> &interfaces,
                   const std::vector<SurfaceFields<dim>>    &fields)
  {
    const auto        presses   = pairs_that_press(interfaces, fields);
    const bool        is_single = std::count(presses.begin(), presses.end(), true) < 2;
    std::vector<bool> result;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      result.push_back(!is_single && presses[i] && !contact_is_resolved(interfaces[i], fields[i]));
    return result;
  }

  template <int dim>
  bool
  small_contacts_are_resolved(const std::vector<ContactInterface<dim>> &interfaces,
                              const std::vector<SurfaceFields<dim>>    &fields)
  {
    const auto is_unresolved = unresolved_pairs(interfaces, fields);
    return std::none_of(
        is_unresolved.begin(), is_unresolved.end(), [](const bool unresolved) { return unresolved; });
  }

  template <int dim>
  bool
  sizes_are_seen(const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<SurfaceFields<dim>>    &fields,
                 const double                              enough_to_stick)
  {
    const auto presses = pairs_that_press(interfaces, fields);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (!presses[i])
          continue;
        // (Of few nodes it may be none; around a ring there is none.)
        const bool has_size =
            fields[i].contact_size > 0 || n_closed_nodes(fields[i]) < enough_closed_nodes<dim>;
        if (has_size && fields[i].contact_size < smallest_closed_face(interfaces[i], fields[i]) / 2 &&
            !contact_is_resolved(interfaces[i], fields[i], std::numeric_limits<double>::infinity()))
          return false;
        const double sticking =
            interfaces[i].pair->has_friction()
                ? smallest_face(interfaces[i],
                                fields[i],
                                [](const ContactStatus state) { return state == ContactStatus::stick; })
                : 0;
        if (sticking > enough_to_stick && fields[i].stick_size < sticking / 2)
          return false;
      }
    return true;
  }

  template <>
  bool
  sizes_are_resolved(const std::vector<ContactInterface<2>> &interfaces,
                     const std::vector<SurfaceFields<2>>    &fields,
                     const double                            target)
  {
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const double n_of_half = std::sqrt(0.5 / target), n = fields[i].symmetry_planes.empty() ? 2 : 1;
        if (!interfaces[i].pair->tied && fields[i].normal_force.norm() > 0 &&
            !contact_is_resolved(interfaces[i], fields[i], n * n_of_half))
          return false;
      }
    return true;
  }

  template <>
  bool
  sizes_are_resolved(const std::vector<ContactInterface<3>> &,
                     const std::vector<SurfaceFields<3>> &,
                     const double)
  {
    return true;
  }

  template std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<2> &,
                          const SurfaceFields<2> &,
                          const SurfaceApproach<2> &,
                          const std::vector<double> &,
                          const std::vector<bool> &,
                          const double,
                          const ProblemType);
  template std::vector<bool>
  faces_of_unseen_contact(const ContactInterface<3> &,
                          const SurfaceFields<3> &,
                          const SurfaceApproach<3> &,
                          const std::vector<double> &,
                          const std::vector<bool> &,
                          const double,
                          const ProblemType);
  template double
  smallest_gap_of(const ContactInterface<2> &, const SurfaceFields<2> &, const SurfaceApproach<2> &);
  template double
  smallest_gap_of(const ContactInterface<3> &, const SurfaceFields<3> &, const SurfaceApproach<3> &);
  template std::vector<bool>
  faces_that_press(const ContactInterface<2> &, const SurfaceFields<2> &);
  template std::vector<bool>
  faces_that_press(const ContactInterface<3> &, const SurfaceFields<3> &);
  template std::vector<bool>
  unresolved_pairs(const std::vector<ContactInterface<2>> &, const std::vector<SurfaceFields<2>> &);
  template std::vector<bool>
  unresolved_pairs(const std::vector<ContactInterface<3>> &, const std::vector<SurfaceFields<3>> &);
  template std::vector<bool>
  faces_near_contact(const ContactInterface<2> &, const SurfaceFields<2> &);
  template std::vector<bool>
  faces_near_contact(const ContactInterface<3> &, const SurfaceFields<3> &);
  template double
  smallest_gap_of_untouched(const std::vector<ContactInterface<2>> &, const std::vector<SurfaceFields<2>> &);
  template double
  smallest_gap_of_untouched(const std::vector<ContactInterface<3>> &, const std::vector<SurfaceFields<3>> &);
  template double
  height_in_doubt(const std::vector<ContactInterface<2>> &, const std::vector<SurfaceFields<2>> &);
  template double
  height_in_doubt(const std::vector<ContactInterface<3>> &, const std::vector<SurfaceFields<3>> &);
  template unsigned int
  n_closed_nodes(const SurfaceFields<2> &);
  template unsigned int
  n_closed_nodes(const SurfaceFields<3> &);
  template bool
  contact_is_resolved(const ContactInterface<2> &, const SurfaceFields<2> &, const double);
  template bool
  contact_is_resolved(const ContactInterface<3> &, const SurfaceFields<3> &, const double);
  template double
  smallest_closed_face(const ContactInterface<2> &, const SurfaceFields<2> &);
  template double
  smallest_closed_face(const ContactInterface<3> &, const SurfaceFields<3> &);
  template bool
  sizes_are_seen(const std::vector<ContactInterface<2>> &,
                 const std::vector<SurfaceFields<2>> &,
                 const double);
  template bool
  sizes_are_seen(const std::vector<ContactInterface<3>> &,
                 const std::vector<SurfaceFields<3>> &,
                 const double);
  template bool
  small_contacts_are_resolved(const std::vector<ContactInterface<2>> &,
                              const std::vector<SurfaceFields<2>> &);
  template bool
  small_contacts_are_resolved(const std::vector<ContactInterface<3>> &,
                              const std::vector<SurfaceFields<3>> &);
} // namespace Amontons

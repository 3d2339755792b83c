#include <amontons/base/gather.h>
#include <amontons/base/points.h>
#include <amontons/contact/covered_shares.h>
#include <amontons/contact/face_overlap.h>
#include <amontons/contact/mortar_integrator.h>
#include <amontons/geometry/rigid_surface.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    // What the lines along the normals meet within `reach`.
    template <int dim>
    BoundingBox<dim>
    swept_box(const ContactSurface<dim> &slave, const unsigned int face, const double search_distance)
    {
      std::vector<Point<dim>> points;
      for (const unsigned int node : slave.faces[face].nodes)
        for (const double sign : {-1., 1.})
          points.push_back(slave.nodes[node].x + sign * search_distance * slave.nodes[node].normal);
      BoundingBox<dim> box(points);
      box.extend(0.1 * slave.faces[face].size); // curvature between the nodes
      return box;
    }

    // A round obstacle that the line along the normal meets on the other side of the body: the point, outside
    // of it, faces away.
    template <int dim>
    bool
    lies_behind(const MasterSide<dim> &master, const OverlapPoint<dim> &p)
    {
      const auto &obstacle = *master.obstacle;
      const bool  is_round =
          obstacle.type == ObstacleData::Type::sphere || obstacle.type == ObstacleData::Type::cylinder;
      return is_round && !obstacle.hollow && p.gap < 0 &&
             distance_from_axis(obstacle, master.motion.origin_of(p.x_slave)) > (1 + 1e-9) * obstacle.radius;
    }
  } // namespace

  namespace
  {
    // Points of one slave face above one master face.
    template <int dim>
    struct Piece
    {
      std::size_t  begin, end;
      unsigned int slave_face, master_face;
      double       gap; // the smallest
      bool         kept;
    };

    template <int dim>
    std::vector<Piece<dim>>
    pieces_of(const std::vector<OverlapPoint<dim>> &points)
    {
      std::vector<Piece<dim>> pieces;
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          const auto &p = points[i];
          if (pieces.empty() || pieces.back().slave_face != p.slave_face ||
              pieces.back().master_face != p.master_face)
            pieces.push_back({i, i, p.slave_face, p.master_face, p.gap, false});
          pieces.back().end = i + 1;
          pieces.back().gap = std::min(pieces.back().gap, p.gap);
        }
      return pieces;
    }

    // Keeps also what hangs together with kept pieces: those above master faces that share nodes, from one to
    // the next.
    template <int dim>
    void
    keep_connected(const ContactSurface<dim> &master, std::vector<Piece<dim>> &pieces)
    {
      std::vector<bool> is_reached(master.nodes.size(), false);
      for (bool any = true; any;)
        {
          any = false;
          for (auto &piece : pieces)
            {
              const auto &nodes   = master.faces[piece.master_face].nodes;
              const auto  reached = [&](const unsigned int n) { return is_reached[n]; };
              if (!piece.kept && !std::any_of(nodes.begin(), nodes.end(), reached))
                continue;
              piece.kept = true;
              for (const unsigned int n : nodes)
                {
                  any           = any || !is_reached[n];
                  is_reached[n] = true;
                }
            }
        }
    }

    // Where the other side has a step, a node sees both of its levels; psi changes sign, so the far one would
    // count for as much as the near one. What lies farther from a face, by more than half its size, than what
    // is opposite of it or of the faces beside it cannot close with it: the strain would be too large. (Of
    // the sizes that of the largest: beside a large face a small one sees gaps that a slope has made on the
    // way along the large one.) What hangs together with what is near counts as well: round bodies are as
    // steep as that where they touch over a sixth of their radius, and a part of a face would have gaps and
    // weights of its own. Of obstacles that is not known.
    template <int dim>
    std::vector<OverlapPoint<dim>>
    without_steps(const ContactSurface<dim>     &slave,
                  const ContactSurface<dim>     *master,
                  std::vector<OverlapPoint<dim>> points)
    {
      std::vector<double> closest(slave.nodes.size(), std::numeric_limits<double>::max()),
          largest(slave.nodes.size(), 0.);
      for (const auto &face : slave.faces)
        for (const unsigned int node : face.unknowns)
          largest[node] = std::max(largest[node], face.size);
      for (const auto &p : points)
        for (const unsigned int node : slave.faces[p.slave_face].unknowns)
          closest[node] = std::min(closest[node], p.gap);
      auto pieces = pieces_of(points);
      for (auto &piece : pieces)
        {
          const auto &face   = slave.faces[piece.slave_face];
          double      beside = std::numeric_limits<double>::max(), size = 0;
          for (const unsigned int node : face.unknowns)
            {
              beside = std::min(beside, closest[node]);
              size   = std::max(size, largest[node]);
            }
          piece.kept = piece.gap <= beside + 0.5 * size;
        }
      if (master != nullptr)
        keep_connected(*master, pieces);
      std::size_t n = 0;
      for (const auto &piece : pieces)
        for (std::size_t i = piece.begin; piece.kept && i < piece.end; ++i)
          points[n++] = points[i];
      points.resize(n);
      return points;
    }
  } // namespace

  template <int dim>
  std::vector<OverlapPoint<dim>>
  find_overlaps(const PairData            &pair,
                const ContactSurface<dim> &slave,
                const MasterSide<dim>     &master,
                const double               search_distance,
                const bool                 axisymmetric,
                const MPI_Comm             communicator,
                const bool                 moved,
                const std::vector<bool>   &wanted)
  {
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    if (master.surface != nullptr)
      for (unsigned int m = 0; m < master.surface->faces.size(); ++m)
        boxes.emplace_back(BoundingBox<dim>(master.surface->faces[m].geometry), m);
    const auto tree = pack_rtree(boxes);
    // Of 84 degrees; moved surfaces, of 72: the flank of a punch comes into the sight of the faces beside it
    // as these lean towards it, and gaps along normals that graze it change with the lean as with the
    // distance.
    const double least_opposed = moved ? 0.3 : 0.1;

    std::vector<unsigned int> candidates;
    const auto                find = [&](const unsigned int s) {
      std::vector<OverlapPoint<dim>> points;
      if (!wanted.empty() && !wanted[s])
        return points;
      if (master.surface == nullptr)
        {
          overlap_obstacle(slave, s, *master.obstacle, master.motion, search_distance, points);
          points.erase(std::remove_if(points.begin(),
                                      points.end(),
                                      [&](const auto &p) { return lies_behind(master, p); }),
                       points.end());
          return points;
        }
      candidates.clear();
      const auto box = swept_box(slave, s, search_distance);
      for (auto it = tree.qbegin(boost::geometry::index::intersects(box)); it != tree.qend(); ++it)
        candidates.push_back(it->second);
      std::sort(candidates.begin(), candidates.end());
      overlap_faces(slave, s, *master.surface, candidates, search_distance, least_opposed, points);
      return points;
    };
    std::vector<OverlapPoint<dim>> points;
    for (const auto &of_face : compute_in_turn(communicator, slave.faces.size(), find))
      points.insert(points.end(), of_face.begin(), of_face.end());
    if (!pair.initial_gap)
      points = without_steps(slave, master.surface, std::move(points));
    for (auto &p : points)
      p.weight *= area_factor(axisymmetric, p.x_slave);
    return points;
  }

  template std::vector<OverlapPoint<2>>
  find_overlaps(const PairData &,
                const ContactSurface<2> &,
                const MasterSide<2> &,
                const double,
                const bool,
                const MPI_Comm,
                const bool,
                const std::vector<bool> &);
  template std::vector<OverlapPoint<3>>
  find_overlaps(const PairData &,
                const ContactSurface<3> &,
                const MasterSide<3> &,
                const double,
                const bool,
                const MPI_Comm,
                const bool,
                const std::vector<bool> &);
} // namespace Amontons

#include <amontons/geometry/facets.h>

#include <deal.II/grid/manifold.h>

#include <array>
#include <cmath>
#include <map>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // A face of the surface. Its ridges are its ends in the plane, its edges in space; ridge k lies opposite
    // of ridge k ^ 1.
    template <int dim>
    struct CoarseFace
    {
      static constexpr unsigned int n_ridges = Facet<dim>::n_ridges;

      Point<dim>                           centre;
      double                               radius;
      bool                                 is_curved;
      std::array<unsigned int, n_ridges>   ridges;          // their numbers in the triangulation
      std::array<Point<dim>, n_ridges>     places;          // their middles
      std::array<Tensor<1, dim>, n_ridges> normals;         // outward, at the ridges
      std::array<double, n_ridges>         sizes;           // from a ridge to the opposite one
      std::array<double, n_ridges>         curvatures = {}; // there, in the plane; > 0: convex
    };

    // By nodes of its own: a chart that its neighbours do not share.
    template <typename Face>
    bool
    is_curved(const Face &face)
    {
      constexpr int dim = Face::AccessorType::dimension;
      return dynamic_cast<const ChartManifold<dim, dim, dim - 1> *>(&face->get_manifold()) != nullptr;
    }

    CoarseFace<2>
    make_face(const Triangulation<2>::face_iterator &face, const Point<2> &inside)
    {
      CoarseFace<2> result;
      result.centre    = face->center();
      result.radius    = 0.5 * face->vertex(0).distance(face->vertex(1));
      result.is_curved = is_curved(face);
      for (unsigned int k = 0; k < 2; ++k)
        {
          const Point<2> &here = face->vertex(k), &there = face->vertex(1 - k);
          const auto      t = face->get_manifold().get_tangent_vector(here, there);
          auto            n = cross_product_2d(t) / t.norm();
          if (n * (result.centre - inside) < 0)
            n = -n;
          result.ridges[k]  = face->vertex_index(k);
          result.places[k]  = here;
          result.normals[k] = n;
          result.sizes[k]   = here.distance(there);
          if (result.is_curved) // x(t) = here + a t + b t^2 through the middle
            {
              const auto middle    = face->get_manifold().get_new_point_on_line(face);
              const auto b         = 2 * (here - 2 * middle + there);
              const auto a         = there - here - b;
              result.curvatures[k] = -2 * (b * n) / a.norm_square();
            }
        }
      return result;
    }

    CoarseFace<3>
    make_face(const Triangulation<3>::face_iterator &face, const Point<3> &inside)
    {
      CoarseFace<3> result;
      result.centre    = face->center();
      result.radius    = 0;
      result.is_curved = is_curved(face);
      for (const unsigned int v : face->vertex_indices())
        result.radius = std::max(result.radius, face->vertex(v).distance(result.centre));
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto     edge = face->line(k);
          const Point<3> here = edge->center(true), there = face->line(k ^ 1)->center(true);
          const auto    &manifold = face->get_manifold();
          auto           n        = cross_product_3d(manifold.get_tangent_vector(here, edge->vertex(1)),
                                    manifold.get_tangent_vector(here, there));
          n /= n.norm();
          if (n * (result.centre - inside) < 0)
            n = -n;
          result.ridges[k]  = face->line_index(k);
          result.places[k]  = here;
          result.normals[k] = n;
          result.sizes[k]   = here.distance(there);
        }
      return result;
    }

    template <int dim>
    class Kinks
    {
    public:
      Kinks(const Triangulation<dim>           &triangulation,
            const std::set<types::boundary_id> &ids,
            const IsMirror<dim>                &is_mirror)
      {
        for (const auto &cell : triangulation.cell_iterators_on_level(0))
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && is_mirror(face))
              {
                const auto mirror = make_face(face, cell->center());
                for (unsigned int k = 0; k < mirror.ridges.size(); ++k)
                  planes[mirror.ridges[k]] = mirror.normals[k];
              }
            else if (face->at_boundary() && ids.count(face->boundary_id()) > 0 &&
                     (face->manifold_id() == numbers::flat_manifold_id || is_curved(face)))
              faces.push_back(make_face(face, cell->center()));
        for (unsigned int f = 0; f < faces.size(); ++f)
          for (unsigned int k = 0; k < faces[f].ridges.size(); ++k)
            at[faces[f].ridges[k]].push_back({f, k});
      }

      std::vector<Facet<dim>>
      facets() const
      {
        std::vector<Facet<dim>> result;
        for (unsigned int f = 0; f < faces.size(); ++f)
          {
            Facet<dim> facet;
            facet.centre    = faces[f].centre;
            facet.radius    = faces[f].radius;
            facet.is_curved = faces[f].is_curved;
            facet.ridges    = faces[f].places;
            for (unsigned int k = 0; k < faces[f].ridges.size(); ++k)
              if (const double angle = kink(f, k);
                  angle != 0 &&
                  1 + row(f, k, angle, &Kinks::kink) + row_beyond(f, k, angle, &Kinks::kink) >= 3)
                {
                  facet.kinks[k] = angle;
                  facet.mean_square += 0.5 * angle * angle;
                  if (std::abs(angle) > std::abs(facet.angle))
                    {
                      facet.angle = angle;
                      facet.size  = faces[f].sizes[k];
                    }
                }
            for (unsigned int k = 0; k < faces[f].ridges.size(); ++k)
              if (const double by = step(f, k);
                  by != 0 && 1 + row(f, k, -by, &Kinks::step) + row_beyond(f, k, by, &Kinks::step) >= 3)
                {
                  facet.steps[k] = by;
                  facet.size     = std::max(facet.size, faces[f].sizes[k]);
                }
            if (facet.angle != 0 || facet.steps != decltype(facet.steps)())
              result.push_back(facet);
          }
        return result;
      }

    private:
      struct Place
      {
        unsigned int face, ridge;
      };

      // The other face at a ridge.
      const Place *
      beyond(const unsigned int f, const unsigned int k) const
      {
        const auto &places = at.at(faces[f].ridges[k]);
        if (places.size() != 2)
          return nullptr;
        return &places[places[0].face == f ? 1 : 0];
      }

      // 0: none that a facet may have.
      double
      kink(const unsigned int f, const unsigned int k) const
      {
        constexpr double      smallest = 1e-6, corner = 40 * numbers::PI / 180;
        const Tensor<1, dim> &n     = faces[f].normals[k];
        const Place          *other = beyond(f, k);
        Tensor<1, dim>        m, way;
        if (other != nullptr)
          {
            m   = faces[other->face].normals[other->ridge];
            way = faces[other->face].centre - faces[f].centre;
          }
        else if (const auto plane = planes.find(faces[f].ridges[k]); plane != planes.end()) // its image
          {
            m   = n - 2 * (n * plane->second) * plane->second;
            way = plane->second;
          }
        else
          return 0;
        const double angle = 2 * std::asin(std::min(1., 0.5 * (m - n).norm()));
        if (angle < smallest || angle > corner)
          return 0;
        return way * (m - n) > 0 ? angle : -angle;
      }

      // 0: none, or less than the length of the face makes of an angle that counts.
      double
      step(const unsigned int f, const unsigned int k) const
      {
        constexpr double smallest = 1e-6;
        const Place     *other    = beyond(f, k);
        if (other == nullptr || !faces[f].is_curved || !faces[other->face].is_curved)
          return 0;
        const double by = faces[other->face].curvatures[other->ridge] - faces[f].curvatures[k];
        return std::abs(by) * faces[f].sizes[k] < smallest ? 0 : by;
      }

      // How many kinks or steps like the last one, by which the way comes through ridge k into the face,
      // follow in a row across it, up to 2.
      using Value = double (Kinks::*)(const unsigned int, const unsigned int) const;
      unsigned int
      row(const unsigned int f, const unsigned int k, double last, const Value value) const
      {
        unsigned int count = 0;
        for (Place here{f, k}; count < 2; ++count)
          {
            const double next = (this->*value)(here.face, here.ridge ^ 1);
            if (next * last <= 0 || std::abs(next) > 4 * std::abs(last) ||
                std::abs(last) > 4 * std::abs(next))
              break;
            const Place *there = beyond(here.face, here.ridge ^ 1);
            here               = there != nullptr ? *there : Place{here.face, here.ridge ^ 1}; // or its image
            last               = next;
          }
        return count;
      }

      unsigned int
      row_beyond(const unsigned int f, const unsigned int k, const double last, const Value value) const
      {
        const Place *other = beyond(f, k);
        return other != nullptr ? row(other->face, other->ridge, last, value) : row(f, k, last, value);
      }

      std::vector<CoarseFace<dim>>               faces;
      std::map<unsigned int, std::vector<Place>> at;     // by ridge
      std::map<unsigned int, Tensor<1, dim>>     planes; // normals of mirrors that end there
    };
  } // namespace

  template <int dim>
  std::vector<Facet<dim>>
  find_facets(const Triangulation<dim>           &triangulation,
              const std::set<types::boundary_id> &ids,
              const IsMirror<dim>                &is_mirror)
  {
    return Kinks<dim>(triangulation, ids, is_mirror).facets();
  }

  template std::vector<Facet<2>>
  find_facets(const Triangulation<2> &, const std::set<types::boundary_id> &, const IsMirror<2> &);
  template std::vector<Facet<3>>
  find_facets(const Triangulation<3> &, const std::set<types::boundary_id> &, const IsMirror<3> &);
} // namespace Amontons

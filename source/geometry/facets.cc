#include <amontons/geometry/facets.h>

#include <array>
#include <cmath>
#include <map>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // A flat face of the surface. Its ridges are its ends in the plane, its edges in space; ridge k lies
    // opposite of ridge k ^ 1.
    template <int dim>
    struct FlatFace
    {
      static constexpr unsigned int n_ridges = 2 * (dim - 1);

      Point<dim>                           centre;
      double                               radius;
      std::array<unsigned int, n_ridges>   ridges;  // their numbers in the triangulation
      std::array<Tensor<1, dim>, n_ridges> normals; // outward, at the ridges
      std::array<double, n_ridges>         sizes;   // from a ridge to the opposite one
    };

    FlatFace<2>
    make_face(const Triangulation<2>::face_iterator &face, const Point<2> &inside)
    {
      FlatFace<2> result;
      const auto  t = face->vertex(1) - face->vertex(0);
      result.centre = face->center();
      result.radius = 0.5 * t.norm();
      auto n        = cross_product_2d(t) / t.norm();
      if (n * (result.centre - inside) < 0)
        n = -n;
      for (unsigned int k = 0; k < 2; ++k)
        {
          result.ridges[k]  = face->vertex_index(k);
          result.normals[k] = n;
          result.sizes[k]   = t.norm();
        }
      return result;
    }

    FlatFace<3>
    make_face(const Triangulation<3>::face_iterator &face, const Point<3> &inside)
    {
      FlatFace<3> result;
      result.centre = face->center();
      result.radius = 0;
      for (const unsigned int v : face->vertex_indices())
        result.radius = std::max(result.radius, face->vertex(v).distance(result.centre));
      for (unsigned int k = 0; k < 4; ++k)
        {
          const auto         edge   = face->line(k);
          const Tensor<1, 3> across = face->line(k ^ 1)->center() - edge->center();
          auto               n      = cross_product_3d(edge->vertex(1) - edge->vertex(0), across);
          n /= n.norm();
          if (n * (result.centre - inside) < 0)
            n = -n;
          result.ridges[k]  = face->line_index(k);
          result.normals[k] = n;
          result.sizes[k]   = across.norm();
        }
      return result;
    }

    template <int dim>
    class Kinks
    {
    public:
      Kinks(const Triangulation<dim> &triangulation, const std::set<types::boundary_id> &ids)
      {
        for (const auto &cell : triangulation.cell_iterators_on_level(0))
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && face->manifold_id() == numbers::flat_manifold_id &&
                ids.count(face->boundary_id()) > 0)
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
            Facet<dim> facet{faces[f].centre, faces[f].radius, 0, 0, 0};
            for (unsigned int k = 0; k < faces[f].ridges.size(); ++k)
              if (const double angle = kink(f, k);
                  angle != 0 && 1 + row(f, k, angle) + row_beyond(f, k, angle) >= 3)
                {
                  facet.mean_square += 0.5 * angle * angle;
                  if (std::abs(angle) > std::abs(facet.angle))
                    {
                      facet.angle = angle;
                      facet.size  = faces[f].sizes[k];
                    }
                }
            if (facet.angle != 0)
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
        constexpr double smallest = 1e-6, corner = 40 * numbers::PI / 180;
        const Place     *other = beyond(f, k);
        if (other == nullptr)
          return 0;
        const Tensor<1, dim> &n = faces[f].normals[k], &m = faces[other->face].normals[other->ridge];
        const double          angle = 2 * std::asin(std::min(1., 0.5 * (m - n).norm()));
        if (angle < smallest || angle > corner)
          return 0;
        return (faces[other->face].centre - faces[f].centre) * (m - n) > 0 ? angle : -angle;
      }

      // How many kinks like this one follow in a row across the face, up to 2.
      unsigned int
      row(const unsigned int f, const unsigned int k, const double angle) const
      {
        unsigned int count = 0;
        Place        here{f, k};
        for (double last = angle; count < 2; ++count)
          {
            const double next = kink(here.face, here.ridge ^ 1);
            if (next * last <= 0 || std::abs(next) > 4 * std::abs(last) ||
                std::abs(last) > 4 * std::abs(next))
              break;
            here = *beyond(here.face, here.ridge ^ 1);
            last = next;
          }
        return count;
      }

      unsigned int
      row_beyond(const unsigned int f, const unsigned int k, const double angle) const
      {
        const Place other = *beyond(f, k);
        return row(other.face, other.ridge, angle);
      }

      std::vector<FlatFace<dim>>                 faces;
      std::map<unsigned int, std::vector<Place>> at; // by ridge
    };
  } // namespace

  template <int dim>
  std::vector<Facet<dim>>
  find_facets(const Triangulation<dim> &triangulation, const std::set<types::boundary_id> &ids)
  {
    return Kinks<dim>(triangulation, ids).facets();
  }

  template std::vector<Facet<2>>
  find_facets(const Triangulation<2> &, const std::set<types::boundary_id> &);
  template std::vector<Facet<3>>
  find_facets(const Triangulation<3> &, const std::set<types::boundary_id> &);
} // namespace Amontons

#include <amontons/geometry/body_parts.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // Of coarse cells, which are known on all ranks: those that share faces. (Nodes alone are hinges.)
    template <int dim>
    class Parts
    {
    public:
      Parts(const Geometry<dim> &geometry, const types::material_id body)
          : vertices(geometry.triangulation.get_vertices()), rank(geometry.triangulation.n_cells(0)),
            parent(rank.size()), sets(rank.data(), parent.data())
      {
        const auto cells = geometry.triangulation.cell_iterators_on_level(0);
        for (const auto &cell : cells)
          if (cell->material_id() == body)
            sets.make_set(cell->index());
        for (const auto &cell : cells)
          if (cell->material_id() == body)
            for (const unsigned int f : cell->face_indices())
              if (!cell->at_boundary(f) && cell->neighbor(f)->material_id() == body)
                sets.union_set(cell->index(), cell->neighbor(f)->index());
        for (const auto &cell : cells)
          if (cell->material_id() == body)
            for (const unsigned int v : cell->vertex_indices())
              of_vertex[cell->vertex_index(v)].insert(sets.find_set(cell->index()));
      }

      // A vertex of each.
      std::vector<Point<dim>>
      places() const
      {
        std::set<unsigned int>  known;
        std::vector<Point<dim>> result;
        for (const auto &[vertex, parts] : of_vertex)
          for (const unsigned int part : parts)
            if (known.insert(part).second)
              result.push_back(vertices[vertex]);
        return result;
      }

      // Vertices that several parts share.
      std::vector<Point<dim>>
      hinges() const
      {
        std::vector<Point<dim>> result;
        for (const auto &[vertex, parts] : of_vertex)
          if (parts.size() > 1)
            result.push_back(vertices[vertex]);
        return result;
      }

      // Vertices of different parts that are in the same place, but for `tolerance`.
      std::vector<Point<dim>>
      seam(const double tolerance) const
      {
        std::map<std::array<long long, dim>, unsigned int> known;
        std::vector<Point<dim>>                            result;
        for (const auto &[vertex, parts] : of_vertex)
          {
            std::array<long long, dim> place;
            for (unsigned int c = 0; c < dim; ++c)
              place[c] = std::llround(vertices[vertex][c] / tolerance);
            const auto [other, is_new] = known.emplace(place, vertex);
            if (!is_new && of_vertex.at(other->second) != parts)
              result.push_back(vertices[vertex]);
          }
        return result;
      }

    private:
      const std::vector<Point<dim>>                       &vertices;
      std::vector<unsigned int>                            rank, parent; // by cell
      boost::disjoint_sets<unsigned int *, unsigned int *> sets;
      std::map<unsigned int, std::set<unsigned int>>       of_vertex;
    };
  } // namespace

  template <int dim>
  std::vector<std::string>
  bodies_in_parts(const Scene &scene, const Geometry<dim> &geometry)
  {
    std::vector<std::string> sentences;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const Parts<dim> parts(geometry, b);
        const auto       all = parts.places();
        if (scene.bodies[b].rigid || all.size() < 2)
          continue;
        std::ostringstream text;
        const auto         hinges = parts.hinges();
        text << "the mesh is in " << all.size() << " parts that share no "
             << (dim == 2 ? "edge of a cell" : "face of a cell");
        if (const auto seam = parts.seam(1e-9 * geometry.body_sizes[b]); !seam.empty())
          {
            text << ", though " << seam.size() << " of one are where another has one, too, as at (" << seam[0]
                 << ")";
            throw InputError(
                scene.bodies[b].where,
                text.str(),
                "parts whose common nodes are merged (gmsh: 'Coherence' or 'BooleanFragments' in "
                "the geometry, 'Coherence Mesh'), or a body for each");
          }
        const auto &examples = hinges.empty() ? all : hinges;
        text << (hinges.empty() ? ", as at" : ", but single nodes, which are hinges, as at");
        for (unsigned int k = 0; k < std::min<std::size_t>(examples.size(), 3); ++k)
          text << " (" << examples[k] << ")";
        text << (hinges.empty() ? ": nothing holds them together" : ": nothing else holds them together");
        sentences.push_back("body '" + scene.bodies[b].name + "': " + text.str() +
                            "; if that is not meant, merge them, or make each a body of its own ('Part')");
      }
    return sentences;
  }

  template std::vector<std::string>
  bodies_in_parts(const Scene &, const Geometry<2> &);
  template std::vector<std::string>
  bodies_in_parts(const Scene &, const Geometry<3> &);
} // namespace Amontons

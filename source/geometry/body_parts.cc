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
    // Coarse cells are known on all ranks.
    template <int dim>
    class Parts
    {
    public:
      Parts(const Geometry<dim> &geometry, const types::material_id body)
          : vertices(geometry.triangulation.get_vertices()), rank(vertices.size()), parent(vertices.size()),
            sets(rank.data(), parent.data())
      {
        for (const auto &cell : geometry.triangulation.cell_iterators_on_level(0))
          if (cell->material_id() == body)
            for (const unsigned int v : cell->vertex_indices())
              if (used.insert(cell->vertex_index(v)).second)
                sets.make_set(cell->vertex_index(v));
        for (const auto &cell : geometry.triangulation.cell_iterators_on_level(0))
          if (cell->material_id() == body)
            for (const unsigned int v : cell->vertex_indices())
              sets.union_set(cell->vertex_index(0), cell->vertex_index(v));
      }

      // A vertex of each.
      std::vector<Point<dim>>
      places()
      {
        std::set<unsigned int> representatives;
        for (const unsigned int v : used)
          representatives.insert(sets.find_set(v));
        std::vector<Point<dim>> result;
        for (const unsigned int v : representatives)
          result.push_back(vertices[v]);
        return result;
      }

      // Vertices of different parts that are in the same place, but for `tolerance`.
      std::vector<Point<dim>>
      seam(const double tolerance)
      {
        std::map<std::array<long long, dim>, unsigned int> known;
        std::vector<Point<dim>>                            result;
        for (const unsigned int v : used)
          {
            std::array<long long, dim> place;
            for (unsigned int c = 0; c < dim; ++c)
              place[c] = std::llround(vertices[v][c] / tolerance);
            const auto [other, is_new] = known.emplace(place, v);
            if (!is_new && sets.find_set(other->second) != sets.find_set(v))
              result.push_back(vertices[v]);
          }
        return result;
      }

    private:
      const std::vector<Point<dim>>                       &vertices;
      std::vector<unsigned int>                            rank, parent;
      boost::disjoint_sets<unsigned int *, unsigned int *> sets;
      std::set<unsigned int>                               used;
    };
  } // namespace

  template <int dim>
  std::vector<std::string>
  bodies_in_parts(const Scene &scene, const Geometry<dim> &geometry)
  {
    std::vector<std::string> sentences;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        Parts<dim> parts(geometry, b);
        const auto all = parts.places();
        if (scene.bodies[b].rigid || all.size() < 2)
          continue;
        std::ostringstream text;
        text << "the mesh is in " << all.size() << " parts that share no node";
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
        text << ", as at";
        for (unsigned int k = 0; k < std::min<std::size_t>(all.size(), 3); ++k)
          text << " (" << all[k] << ")";
        sentences.push_back("body '" + scene.bodies[b].name + "': " + text.str() +
                            ": nothing holds them together; if that is not meant, merge them, or make each a "
                            "body of its own, with a mesh file of its own");
      }
    return sentences;
  }

  template std::vector<std::string>
  bodies_in_parts(const Scene &, const Geometry<2> &);
  template std::vector<std::string>
  bodies_in_parts(const Scene &, const Geometry<3> &);
} // namespace Amontons

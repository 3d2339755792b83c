#include <amontons/geometry/cad_manifold.h>
#include <amontons/geometry/cad_model.h>

#include <deal.II/grid/manifold.h>

#include <limits>
#include <set>
#include <sstream>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // A point near all `faces`, moved to where they meet by turns. CAD edges are on their faces within 1e-7
    // only.
    Point<3>
    on_all(const std::vector<CadShape> &faces, Point<3> p)
    {
      for (unsigned int i = 0; i < (faces.size() > 1 ? 10 : 1); ++i)
        for (const CadShape &face : faces)
          p = face.closest_point(p);
      return p;
    }

    // New points are averages, moved to the closest point of a CAD face or edge; on an edge also on the faces
    // that meet there.
    class CadManifold : public FlatManifold<3>
    {
    public:
      CadManifold(const CadShape &shape, const std::vector<CadShape> &faces) : shape(shape), faces(faces) {}

      std::unique_ptr<Manifold<3>>
      clone() const override
      {
        return std::make_unique<CadManifold>(shape, faces);
      }

      Point<3>
      project_to_manifold(const ArrayView<const Point<3>> &, const Point<3> &candidate) const override
      {
        return on_all(faces, shape.closest_point(candidate));
      }

    private:
      const CadShape              shape;
      const std::vector<CadShape> faces;
    };

    template <typename Iterator>
    std::vector<Point<3>>
    vertices_of(const Iterator &object)
    {
      std::vector<Point<3>> vertices;
      for (const unsigned int v : object->vertex_indices())
        vertices.push_back(object->vertex(v));
      return vertices;
    }

    struct Nearest
    {
      unsigned int index    = numbers::invalid_unsigned_int;
      double       distance = std::numeric_limits<double>::infinity();
    };

    Nearest
    nearest(const std::vector<CadShape> &shapes, const std::vector<Point<3>> &points, const double tolerance)
    {
      Nearest result;
      for (unsigned int i = 0; i < shapes.size(); ++i)
        if (const double distance = shapes[i].largest_distance(points, tolerance); distance < result.distance)
          result = {i, distance};
      return result;
    }

    std::vector<CadShape>
    shapes_of(const std::set<unsigned int> &indices, const std::vector<CadShape> &all)
    {
      std::vector<CadShape> shapes;
      for (const unsigned int i : indices)
        if (i < all.size())
          shapes.push_back(all[i]);
      return shapes;
    }

    [[noreturn]] void
    fail(const Boundary &boundary, const BodyData &body, const Point<3> &p, const double distance)
    {
      std::ostringstream found;
      found << "boundary '" << boundary.name << "' has a face with the vertex (" << p
            << ") that lies on no single face of '" << boundary.geometry.file << "'";
      if (distance < std::numeric_limits<double>::infinity())
        found << ": the nearest is " << distance << " away";
      throw InputError(
          body.where, found.str(), "vertices within 1e-3 of the body's size; CAD lengths are in mm");
    }
    // The CAD faces at the lines of a boundary; `elsewhere` stands for a neighbour on none.
    using CadFacesAtLines        = std::map<Triangulation<3>::line_iterator, std::set<unsigned int>>;
    const unsigned int elsewhere = numbers::invalid_unsigned_int;

    CadFacesAtLines
    attach_faces(const Boundary     &boundary,
                 const BodyData     &body,
                 const CadModel     &model,
                 const double        tolerance,
                 types::manifold_id &next_id,
                 Triangulation<3>   &triangulation)
    {
      CadFacesAtLines                            at_lines;
      std::map<unsigned int, types::manifold_id> ids;
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary.id)
            {
              const Nearest found = nearest(model.faces, vertices_of(face), tolerance);
              if (!(found.distance <= tolerance))
                fail(boundary, body, face->vertex(0), found.distance);
              const auto [entry, is_new] = ids.emplace(found.index, next_id);
              if (is_new)
                triangulation.set_manifold(next_id++, CadManifold(model.faces[found.index], {}));
              face->set_all_manifold_ids(entry->second);
              for (unsigned int l = 0; l < face->n_lines(); ++l)
                at_lines[face->line(l)].insert(found.index);
            }

      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() != boundary.id)
            for (unsigned int l = 0; l < face->n_lines(); ++l)
              if (const auto line = at_lines.find(face->line(l)); line != at_lines.end())
                {
                  const Nearest found = nearest(model.faces, vertices_of(face), tolerance);
                  line->second.insert(found.distance <= tolerance ? found.index : elsewhere);
                }
      return at_lines;
    }

    void
    attach_edges(const CadFacesAtLines &at_lines,
                 const CadModel        &model,
                 const double           tolerance,
                 types::manifold_id    &next_id,
                 Triangulation<3>      &triangulation)
    {
      std::map<std::pair<unsigned int, std::set<unsigned int>>, types::manifold_id> ids;
      for (const auto &[line, cad_faces] : at_lines)
        if (cad_faces.size() > 1)
          {
            const double  close = std::min(tolerance, 0.01 * line->diameter());
            const Nearest edge  = nearest(model.edges, vertices_of(line), close);
            if (!(edge.distance <= close))
              continue;
            const auto [entry, is_new] = ids.emplace(std::make_pair(edge.index, cad_faces), next_id);
            if (is_new)
              triangulation.set_manifold(
                  next_id++, CadManifold(model.edges[edge.index], shapes_of(cad_faces, model.faces)));
            line->set_manifold_id(entry->second);
          }
    }

    // Exact vertices stay as they are.
    void
    move_vertices(const CadFacesAtLines &at_lines,
                  const CadModel        &model,
                  const double           rounding,
                  Triangulation<3>      &triangulation)
    {
      std::map<unsigned int, std::set<unsigned int>> at_vertices;
      for (const auto &[line, cad_faces] : at_lines)
        for (const unsigned int v : line->vertex_indices())
          at_vertices[line->vertex_index(v)].insert(cad_faces.begin(), cad_faces.end());
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          if (const auto found = at_vertices.find(cell->vertex_index(v)); found != at_vertices.end())
            {
              const Point<3> p = on_all(shapes_of(found->second, model.faces), cell->vertex(v));
              if (p.distance(cell->vertex(v)) > rounding)
                cell->vertex(v) = p;
            }
    }
  } // namespace

  void
  attach_cad_manifolds(const Boundary     &boundary,
                       const BodyData     &body,
                       const double        body_size,
                       types::manifold_id &next_id,
                       Triangulation<3>   &triangulation)
  {
    const CadModel        model     = read_cad_model(boundary.geometry, body);
    const double          tolerance = 1e-3 * body_size;
    const CadFacesAtLines at_lines  = attach_faces(boundary, body, model, tolerance, next_id, triangulation);
    attach_edges(at_lines, model, tolerance, next_id, triangulation);
    move_vertices(at_lines, model, 1e-12 * body_size, triangulation);
  }
} // namespace Amontons

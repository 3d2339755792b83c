#include <amontons/geometry/grid_reader.h>
#include <amontons/geometry/mesh_file.h>
#include <amontons/scene/text.h>

#include <deal.II/base/geometry_info.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    void
    check_cell_kinds(const FileMesh &mesh, const unsigned int dim, const SourceLocation &where)
    {
      const std::string wanted = dim == 2 ? "quadrilaterals" : "hexahedra";
      const std::string how =
          wanted + " only; from gmsh, with these lines at the end of the .geo file: " +
          (dim == 2 ? "Recombine Surface{:}; Mesh.RecombinationAlgorithm = 1; Mesh.SubdivisionAlgorithm = 1;"
                    : "Mesh.SubdivisionAlgorithm = 2; (or transfinite volumes with recombined surfaces)");
      if (mesh.n_others > 0)
        throw InputError({where.file, mesh.other_line, where.entry},
                         "the mesh has " + std::to_string(mesh.n_others) + " " + mesh.other_cells,
                         how);
      if (mesh.cells.empty())
        throw InputError({where.file, 0, where.entry},
                         "the mesh has no " + wanted,
                         how + " (gmsh saves only what is in a physical group, if there is one)");
    }

    // Where no cell was read: the part that is asked for is not in the file, or none is, of several.
    void
    check_part(const FileMesh &mesh, const BodyData &body)
    {
      const bool is_asked = !body.part.empty();
      if (!mesh.cells.empty() || mesh.n_others > 0 || (!is_asked && mesh.parts.empty()))
        return;
      const std::vector<std::string> parts(mesh.parts.begin(), mesh.parts.end());
      throw InputError(body.where,
                       is_asked
                           ? "the mesh file has no part '" + body.part + "'" + suggestion(body.part, parts)
                           : "the mesh file has " + std::to_string(parts.size()) + " parts",
                       parts.empty() ? "no 'Part', as no cells of the file are in a physical group, or an "
                                       "element set"
                                     : (is_asked ? "" : "'Part', one of them: ") + join(parts, ", "));
    }

    // From the determinants of the map at the corners: 1 if all are positive, -1 if all are negative, else 0.
    template <int dim>
    int
    orientation(const CoarseMesh<dim> &mesh, const CellData<dim> &cell)
    {
      int n_positive = 0, n_negative = 0;
      for (unsigned int v = 0; v < cell.vertices.size(); ++v)
        {
          Tensor<2, dim> edges;
          double         product = 1;
          for (unsigned int d = 0; d < dim; ++d)
            {
              edges[d] =
                  mesh.vertices[cell.vertices[v | (1u << d)]] - mesh.vertices[cell.vertices[v & ~(1u << d)]];
              product *= edges[d].norm();
            }
          const double size = determinant(edges);
          n_positive += size > 1e-6 * product;
          n_negative += size < -1e-6 * product;
        }
      const int n = cell.vertices.size();
      return (n_positive == n) - (n_negative == n);
    }

    // Whether the face runs from its lowest vertex to the lower one of that vertex's neighbours, seen from
    // outside the cell: the two cells of a face see it run either way.
    template <int dim>
    bool
    runs_upwards(const CellData<dim> &cell, const unsigned int face)
    {
      const auto vertex = [&](const unsigned int v) {
        return cell.vertices[GeometryInfo<dim>::face_to_cell_vertices(face, v)];
      };
      if (dim == 2)
        return (vertex(0) < vertex(1)) == (face == 1 || face == 2);
      const std::array<unsigned int, 4> loop{{vertex(0), vertex(1), vertex(3), vertex(2)}};
      const unsigned int                at = std::min_element(loop.begin(), loop.end()) - loop.begin();
      return (loop[(at + 1) % 4] < loop[(at + 3) % 4]) == (face % 2 == 1);
    }

    // Of convex cells, two at most share a face, one on each side of it. lines: of the cells.
    template <int dim>
    void
    check_neighbours(const CoarseMesh<dim> &mesh, const std::vector<int> &lines, const SourceLocation &where)
    {
      std::map<FaceKey<dim>, std::array<std::optional<unsigned int>, 2>> cells_at; // by the way it runs
      for (unsigned int c = 0; c < mesh.cells.size(); ++c)
        for (const unsigned int f : GeometryInfo<dim>::face_indices())
          {
            auto &other = cells_at[face_key(mesh.cells[c], f)][runs_upwards(mesh.cells[c], f)];
            if (other)
              {
                std::ostringstream found;
                found << "the cell lies on the same side of a face as that of line " << lines[*other]
                      << ": they overlap near ("
                      << mesh.vertices[mesh.cells[c].vertices[GeometryInfo<dim>::face_to_cell_vertices(f, 0)]]
                      << ")";
                throw InputError({where.file, lines[c], where.entry},
                                 found.str(),
                                 "one cell on each side of a face (gmsh: a finer mesh, another algorithm)");
              }
            other = c;
          }
    }

    template <int dim>
    void
    add_cells(const FileMesh &file, const SourceLocation &where, CoarseMesh<dim> &mesh)
    {
      double smallest = 0, largest = 0;
      for (const auto &p : file.nodes)
        {
          mesh.vertices.emplace_back();
          for (unsigned int d = 0; d < dim; ++d)
            mesh.vertices.back()[d] = p[d];
          smallest = std::min(smallest, p[2] - file.nodes[0][2]);
          largest  = std::max(largest, std::max(p[2] - file.nodes[0][2], std::abs(p[0]) + std::abs(p[1])));
        }
      for (const auto &p : file.nodes)
        if (dim == 2 && std::abs(p[2] - file.nodes[0][2]) > 1e-8 * largest)
          throw InputError({where.file, 0, where.entry},
                           "nodes with different z in a two-dimensional scene",
                           "a mesh in the x-y plane");

      // gmsh writes a cell once for every group that it belongs to
      std::set<std::array<unsigned int, 8>> known;
      std::vector<int>                      lines;
      for (const auto &c : file.cells)
        {
          std::array<unsigned int, 8> sorted = c.nodes;
          std::sort(sorted.begin(), sorted.begin() + (1 << dim));
          if (!known.insert(sorted).second)
            continue;
          std::vector<CellData<dim>> cell(1);
          for (unsigned int v = 0; v < (1 << dim); ++v)
            cell[0].vertices[GeometryInfo<dim>::ucd_to_deal[v]] = c.nodes[v];
          const bool is_convex = orientation(mesh, cell[0]) != 0;
          if (is_convex) // deal.II knows no way of turning others
            GridTools::invert_cells_with_negative_measure(mesh.vertices, cell);
          if (!is_convex || orientation(mesh, cell[0]) != 1)
            throw InputError(
                {where.file, c.line, where.entry}, "the cell is degenerate or folded", "convex cells");
          mesh.cells.push_back(cell[0]);
          lines.push_back(c.line);
        }
      check_neighbours(mesh, lines, where);
    }

    // The named faces, of those on the boundary; names without any are dropped.
    template <int dim>
    void
    add_boundaries(const FileMesh &file, CoarseMesh<dim> &mesh)
    {
      const auto                          all = boundary_faces(mesh);
      std::map<std::string, unsigned int> index;
      for (const auto &face : file.faces)
        {
          FaceKey<dim> key;
          std::copy_n(face.nodes.begin(), key.size(), key.begin());
          std::sort(key.begin(), key.end());
          if (!std::binary_search(all.begin(), all.end(), key) || mesh.boundaries.count(key) > 0)
            continue;
          const auto [entry, is_new] = index.emplace(file.names[face.name], mesh.names.size());
          if (is_new)
            mesh.names.push_back(file.names[face.name]);
          mesh.boundaries[key] = entry->second;
        }
    }

    // Those of edges and faces on the boundary.
    template <int dim>
    void
    add_middle_nodes(const FileMesh &file, CoarseMesh<dim> &mesh)
    {
      if (file.edge_nodes.empty())
        return;
      for (const auto &face : boundary_faces(mesh))
        {
          for (unsigned int k = 0; k < face.size(); ++k)
            for (unsigned int l = k + 1; l < face.size(); ++l)
              if (const auto node = file.edge_nodes.find({{face[k], face[l]}}); node != file.edge_nodes.end())
                mesh.middle_nodes.of_edges[node->first] = mesh.vertices[node->second];
          if constexpr (dim == 3)
            if (const auto node = file.face_nodes.find(face); node != file.face_nodes.end())
              mesh.middle_nodes.of_faces[face] = mesh.vertices[node->second];
        }
    }

    template <typename Nodes>
    Nodes
    renumbered(const Nodes &nodes, const std::vector<unsigned int> &number)
    {
      Nodes result;
      for (const auto &[old_key, p] : nodes)
        {
          auto key = old_key;
          for (unsigned int &v : key)
            v = number[v];
          std::sort(key.begin(), key.end());
          result[key] = p;
        }
      return result;
    }

    template <int dim>
    void
    delete_unused_vertices(CoarseMesh<dim> &mesh)
    {
      std::vector<unsigned int> number(mesh.vertices.size(), numbers::invalid_unsigned_int);
      std::vector<Point<dim>>   vertices;
      for (auto &cell : mesh.cells)
        for (unsigned int &v : cell.vertices)
          {
            if (number[v] == numbers::invalid_unsigned_int)
              {
                number[v] = vertices.size();
                vertices.push_back(mesh.vertices[v]);
              }
            v = number[v];
          }
      mesh.vertices              = vertices;
      mesh.boundaries            = renumbered(mesh.boundaries, number);
      mesh.middle_nodes.of_edges = renumbered(mesh.middle_nodes.of_edges, number);
      mesh.middle_nodes.of_faces = renumbered(mesh.middle_nodes.of_faces, number);
    }
  } // namespace

  template <int dim>
  CoarseMesh<dim>
  read_grid(const BodyData &body, MPI_Comm communicator)
  {
    // lines of what gmsh made of a .geo file are not lines of that file
    const SourceLocation where{body.mesh_file +
                                   (file_ending(body.mesh_file) == ".geo" ? " (meshed by gmsh)" : ""),
                               0,
                               body.where.entry};
    MeshText             text(read_mesh_text(body, dim, communicator), where);
    const FileMesh       file = file_ending(body.mesh_file) == ".inp" ? parse_abaqus(text, dim, body.part)
                                                                      : parse_gmsh(text, dim, body.part);
    check_part(file, body);
    check_cell_kinds(file, dim, where);

    CoarseMesh<dim> mesh;
    add_cells(file, where, mesh);
    add_boundaries(file, mesh);
    add_middle_nodes(file, mesh);
    delete_unused_vertices(mesh);
    orient_cells(mesh);
    return mesh;
  }

  template CoarseMesh<2>
  read_grid<2>(const BodyData &, MPI_Comm);
  template CoarseMesh<3>
  read_grid<3>(const BodyData &, MPI_Comm);
} // namespace Amontons

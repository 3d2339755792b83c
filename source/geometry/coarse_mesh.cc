#include <amontons/geometry/coarse_mesh.h>

#include <deal.II/base/geometry_info.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Amontons
{
  using namespace dealii;

  template <int dim>
  FaceKey<dim>
  face_key(const CellData<dim> &cell, const unsigned int face)
  {
    FaceKey<dim> key;
    for (unsigned int v = 0; v < key.size(); ++v)
      key[v] = cell.vertices[GeometryInfo<dim>::face_to_cell_vertices(face, v)];
    std::sort(key.begin(), key.end());
    return key;
  }

  template <int dim>
  std::vector<FaceKey<dim>>
  boundary_faces(const CoarseMesh<dim> &mesh)
  {
    std::map<FaceKey<dim>, unsigned int> n_cells_at;
    for (const auto &cell : mesh.cells)
      for (const unsigned int f : GeometryInfo<dim>::face_indices())
        ++n_cells_at[face_key(cell, f)];

    std::vector<FaceKey<dim>> faces;
    for (const auto &[key, n_cells] : n_cells_at)
      if (n_cells == 1)
        faces.push_back(key);
    return faces;
  }

  template <int dim>
  void
  name_boundary(CoarseMesh<dim>                               &mesh,
                const std::string                             &name,
                const std::function<bool(const Point<dim> &)> &inside)
  {
    const unsigned int index = mesh.names.size();
    bool               found = false;
    for (const auto &key : boundary_faces(mesh))
      if (std::all_of(key.begin(), key.end(), [&](const unsigned int v) { return inside(mesh.vertices[v]); }))
        found |= mesh.boundaries.emplace(key, index).second;
    if (found)
      mesh.names.push_back(name);
  }

  template <int dim>
  void
  check_cell_count(const BodyData &body, const double n_coarse_cells)
  {
    const double       n = n_coarse_cells * std::pow(1 << dim, body.refinements);
    std::ostringstream found;
    found << "this body would have " << n << " cells";
    if (n > 5e7)
      throw InputError(body.where, found.str(), "at most 5e7: fewer Cells or Refinements, a thicker ring");
    if (n_coarse_cells > 2e6)
      throw InputError(body.where,
                       found.str() + " before refinement",
                       "at most 2e6, since every process holds these: fewer Cells and more Refinements");
  }

  template <int dim>
  void
  orient_cells(CoarseMesh<dim> &mesh)
  {
    GridTools::invert_cells_with_negative_measure(mesh.vertices, mesh.cells);
    GridTools::consistently_order_cells(mesh.cells);
  }

#define INSTANTIATE(dim)                                                                                             \
  template FaceKey<dim>              face_key(const CellData<dim> &, const unsigned int);                            \
  template std::vector<FaceKey<dim>> boundary_faces(const CoarseMesh<dim> &);                                        \
  template void                      name_boundary(                                                                  \
                           CoarseMesh<dim> &, const std::string &, const std::function<bool(const Point<dim> &)> &); \
  template void orient_cells(CoarseMesh<dim> &);                                                                     \
  template void check_cell_count<dim>(const BodyData &, const double);

  INSTANTIATE(2)
  INSTANTIATE(3)
} // namespace Amontons

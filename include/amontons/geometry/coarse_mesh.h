// The coarse mesh of one body, before it becomes part of the triangulation.
#pragma once

#include <amontons/geometry/quadratic_faces.h>
#include <amontons/scene/scene.h>

#include <deal.II/grid/tria_description.h>

#include <functional>

namespace Amontons
{
  // The vertices of a face in ascending order: equal for the two cells that share it.
  template <int dim>
  using FaceKey = std::array<unsigned int, (1 << (dim - 1))>;

  template <int dim>
  struct CoarseMesh
  {
    std::vector<Point<dim>>            vertices;
    std::vector<dealii::CellData<dim>> cells; // deal.II's (lexicographic) order

    std::vector<std::string>             names;      // of the boundaries
    std::map<FaceKey<dim>, unsigned int> boundaries; // named boundary faces -> index into `names`
    std::map<std::string, TrueGeometry>  geometry;   // of curved boundaries, by name

    MiddleNodes<dim> middle_nodes; // of meshes of second order, by vertex

    // All cells, not only the boundary, follow polar coordinates about this point or axis.
    std::optional<TrueGeometry> polar;
  };

  template <int dim>
  FaceKey<dim>
  face_key(const dealii::CellData<dim> &cell, const unsigned int face);

  // Faces that belong to one cell only.
  template <int dim>
  std::vector<FaceKey<dim>>
  boundary_faces(const CoarseMesh<dim> &mesh);

  // Gives `name` to those boundary faces without a name all of whose vertices are `inside`.
  // If there are none, the name does not enter `names`.
  template <int dim>
  void
  name_boundary(CoarseMesh<dim>                               &mesh,
                const std::string                             &name,
                const std::function<bool(const Point<dim> &)> &inside);

  // Throws InputError for more cells than any machine holds, before they are made. Every rank holds the
  // coarse mesh.
  template <int dim>
  void
  check_cell_count(const BodyData &body, const double n_coarse_cells);

  // Positive measure of all cells and a consistent direction of all edges, as deal.II wants them.
  template <int dim>
  void
  orient_cells(CoarseMesh<dim> &mesh);
} // namespace Amontons

// Boundary faces of meshes of second order, as curved as their nodes say.
#pragma once

#include <deal.II/grid/tria.h>

#include <array>
#include <map>

namespace Amontons
{
  // The nodes of a mesh between its vertices: in the middle of edges, by the vertices at their ends in
  // ascending order, and in 3D of faces, by the four vertices in ascending order (missing ones follow from
  // the edges).
  template <int dim>
  struct MiddleNodes
  {
    std::map<std::array<unsigned int, 2>, dealii::Point<dim>> of_edges;
    std::map<std::array<unsigned int, 4>, dealii::Point<dim>> of_faces;
  };

  // Gives the boundary faces of the coarse mesh that have no manifold, and are not flat with these nodes, the
  // quadratic geometry through their vertices and nodes; vertices by their number in the triangulation. Ids
  // of manifolds begin with first_id; returns the next free one. Refinement and mappings follow the nodes.
  // Throws std::invalid_argument, with a place, for nodes so far from the middle that an edge turns back.
  template <int dim>
  dealii::types::manifold_id
  attach_quadratic_faces(const MiddleNodes<dim>          &nodes,
                         const dealii::types::manifold_id first_id,
                         dealii::Triangulation<dim>      &triangulation);
} // namespace Amontons

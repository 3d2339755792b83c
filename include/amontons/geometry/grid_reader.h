// Meshes from files: gmsh (.msh in ASCII, versions 2.2 and 4.1, and .geo through the gmsh program) and Abaqus
// (.inp).
#pragma once

#include <amontons/geometry/coarse_mesh.h>

#include <mpi.h>

namespace Amontons
{
  // The mesh of body.mesh_file. Boundary names are gmsh's physical groups of dimension dim-1 (the number, if
  // a group has no name), or Abaqus' surfaces, element sets of dim-1 elements and node sets, in this order; a
  // face in two of them belongs to the first. Collective: rank 0 reads the file and runs gmsh, all ranks get
  // the same text, and all throw InputError if there is none.
  template <int dim>
  CoarseMesh<dim>
  read_grid(const BodyData &body, MPI_Comm communicator);

  // The text of body.mesh_file, or of what gmsh makes of it if it is a .geo file or binary. Collective.
  std::string
  read_mesh_text(const BodyData &body, const unsigned int dim, MPI_Comm communicator);
} // namespace Amontons

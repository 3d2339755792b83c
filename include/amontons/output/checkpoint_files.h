/// The files of a checkpoint: what is in them, written and read.
#pragma once

#include <amontons/solver/newton_report.h>

#include <deal.II/base/types.h>

#include <array>
#include <string>

namespace Amontons
{
  using namespace dealii;

  /// What is resumed.
  struct StoredRun
  {
    std::string              id;    // of no other run
    std::string              scene; // file
    std::vector<std::string> overrides;
    std::vector<std::string> entries; // of the scene that change its answer
  };

  /// One converged solve.
  struct StoredSolve
  {
    unsigned int                     number    = 0; // in the run
    double                           t         = 0;
    unsigned long long               mesh      = 0;          // whatever the ranks are
    unsigned long long               numbering = 0;          // of its DoFs, on so many ranks
    NewtonReport                     report;                 // without the failure
    std::vector<double>              displacement;           // by global DoF
    std::vector<std::vector<double>> contact;                // by pair; of each node a NodalContact's numbers
    std::vector<std::vector<types::global_dof_index>> nodes; // the first DoF of each
  };

  /// Successive ones, in one file.
  struct StoredPart
  {
    std::string              run;        // its id
    unsigned int             before = 0; // the last solve of the part before it
    std::vector<StoredSolve> solves;
  };

  struct StoredMesh
  {
    std::vector<std::array<unsigned int, 4>> cells; // CellId
    std::vector<types::global_dof_index>     dofs;  // of each cell
  };

  /// Of a run, a part or a mesh. One line (format, version, bytes, checksum), then the object; by
  /// write_file().
  template <typename T>
  void
  write_object(const std::string &file, const T &object);

  /// Of a file that a scene reads: its name, length and checksum.
  std::string
  describe_contents(const std::string &file);

  /// Throws InputError: another version, damaged, no such file.
  template <typename T>
  T
  read_object(const std::string &file);
} // namespace Amontons

namespace boost
{
  namespace serialization
  {
    // Ranks send it to each other.
    template <typename Archive>
    void
    serialize(Archive &archive, Amontons::StoredMesh &mesh, const unsigned int)
    {
      archive &mesh.cells &mesh.dofs;
    }
  } // namespace serialization
} // namespace boost

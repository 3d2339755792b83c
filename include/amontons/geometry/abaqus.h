// Names in Abaqus input: element types, faces of elements, and sets. Upper and lower case are the same.
#pragma once

#include <amontons/geometry/mesh_file.h>

namespace Amontons
{
  std::string
  upper_case(const std::string_view s);

  struct AbaqusElementType
  {
    const char  *name; // what follows is an option (R, I, H, T, P, ...), not a digit
    unsigned int dim, n_corners, n_nodes;
    const char  *kind; // other than line, quadrilateral, hexahedron
  };

  const AbaqusElementType &
  abaqus_element_type(const std::string &name, const MeshText &text);

  // The corners of faces S1, S2, ... of quadrilaterals (dim = 2) or hexahedra.
  const std::vector<std::vector<unsigned int>> &
  abaqus_faces(const unsigned int dim);

  struct AbaqusSet
  {
    std::string                   name; // as first written
    std::vector<long>             ids;
    std::vector<std::string_view> sets;               // names of other sets
    bool                          of_element = false; // made by *ELEMENT, ELSET=...
  };

  struct AbaqusSets
  {
    // The set of this name, new if there is none.
    AbaqusSet &
    at(const std::string &name, const bool of_element = false);

    // The numbers in the set `name`, with those of the sets in it.
    std::vector<long>
    members(const std::string_view name, const MeshText &text, const unsigned int depth = 0) const;

    std::vector<AbaqusSet> all; // in the order of the file
  };
} // namespace Amontons

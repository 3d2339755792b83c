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

  // Parts number their nodes and elements each for itself; instances put them into places of an assembly. Of
  // several one is read. All names that are asked for are in upper case.
  struct AbaqusAssembly
  {
    // The part or the instance of this name, or what there is only one of; false: that is left open.
    bool
    choose(const std::string &name);
    // than the one that is read
    bool
    is_of_another_part(const std::string &name) const;
    bool
    is_of_another_instance(const std::string_view name) const;
    // What may be chosen, as it is written.
    std::set<std::string>
    names() const;

    std::map<std::string, std::string> parts; // with elements, as they are written
    std::map<std::string, std::string> instances;
    std::map<std::string, std::string> part_of; // instances
    std::string                        part, instance;
  };

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

// From a .prm or .json file, with overrides from the command line, to a checked Scene.
#pragma once

#include <amontons/base/parameters.h>
#include <amontons/scene/scene.h>

#include <ostream>

namespace Amontons
{
  // Reads `file`, applies `overrides` ("Section/Name = value"), fills the groups, and checks all that can be
  // checked without a mesh. `fields` are those that boundary conditions may name. Throws InputError.
  Scene
  read_scene(const std::string              &file,
             const std::vector<std::string> &overrides,
             const ParameterGroups          &groups,
             const BoundaryFields           &fields = {});

  // Every parameter, its default and its meaning, as a .prm text that can be edited into a scene.
  void
  print_parameters(std::ostream &out, const ParameterGroups &groups);
} // namespace Amontons

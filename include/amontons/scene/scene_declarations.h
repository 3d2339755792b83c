// The entries of a scene with their defaults, patterns and meanings.
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Amontons
{
  // A section "PREFIX NAME" that may stand any number of times.
  struct NamedSection
  {
    std::string prefix;
    void (*declare)(dealii::ParameterHandler &prm); // declares the entries in the current subsection
  };

  const std::vector<NamedSection> &
  named_sections();

  // The section's kind if `path` is "PREFIX NAME" (or PREFIX alone), else nullptr.
  const NamedSection *
  find_named_section(const std::string &path);

  // Title, Kind, the load program (End time, Increments, ...), and the section Reference.
  void
  declare_top_level(dealii::ParameterHandler &prm);

  const std::vector<std::string> &
  built_in_shapes(const int dim);
  const std::vector<std::string> &
  motion_entries();
} // namespace Amontons

// What stands in an input file, before any of it is understood: sections and entries with their places.
#pragma once

#include <amontons/base/input_error.h>

#include <string>
#include <vector>

namespace Amontons
{
  constexpr std::size_t largest_scene_file = std::size_t(1) << 24; // bytes

  struct OutlineSection
  {
    std::string    path; // "Body lower", nested ones "Solver/Linear solver"
    SourceLocation where;
  };

  struct OutlineEntry
  {
    std::string    section; // path, empty at the top level
    std::string    name, value;
    SourceLocation where;
  };

  struct Outline
  {
    std::vector<OutlineSection> sections;
    std::vector<OutlineEntry>   entries;

    // Throw InputError if the same file has the section or the entry already; a later file adds to sections
    // and replaces entries.
    void
    add(const OutlineSection &section);
    void
    add(const OutlineEntry &entry);

    const OutlineSection *
    find_section(const std::string &path) const;
    const OutlineEntry *
    find_entry(const std::string &section, const std::string &name) const;
  };

  // "Body lower" + "Radius" -> "Body lower/Radius"; empty parts are left out.
  std::string
  path_of(const std::string &section, const std::string &name);

  // By the ending of the file: .json, else the .prm syntax of deal.II with `include FILE` (relative to the
  // including file), comments and continued lines. Throws InputError.
  Outline
  read_outline(const std::string &file);
  void
  read_prm(const std::string &file, Outline &outline, const SourceLocation &included_from = {});
  void
  read_json(const std::string &file, Outline &outline);

  // "Section/Name = value" from the command line.
  OutlineEntry
  parse_override(const std::string &text);
} // namespace Amontons

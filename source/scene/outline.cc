#include <amontons/scene/outline.h>
#include <amontons/scene/text.h>

namespace Amontons
{
  namespace
  {
    std::string
    first_place(const SourceLocation &where)
    {
      return where.line > 0 ? " (first in line " + std::to_string(where.line) + ")" : "";
    }

    const std::string command_line = "--set";
  } // namespace

  std::string
  path_of(const std::string &section, const std::string &name)
  {
    return section + (section.empty() || name.empty() ? "" : "/") + name;
  }

  const OutlineSection *
  Outline::find_section(const std::string &path) const
  {
    for (const OutlineSection &section : sections)
      if (section.path == path)
        return &section;
    return nullptr;
  }

  const OutlineEntry *
  Outline::find_entry(const std::string &section, const std::string &name) const
  {
    for (const OutlineEntry &entry : entries)
      if (entry.section == section && entry.name == name)
        return &entry;
    return nullptr;
  }

  void
  Outline::add(const OutlineSection &section)
  {
    const OutlineSection *const present = find_section(section.path);
    if (present == nullptr)
      sections.push_back(section);
    else if (present->where.file == section.where.file)
      throw InputError(section.where,
                       "this section stands here a second time" + first_place(present->where),
                       "each section once in a file, with a name of its own");
  }

  void
  Outline::add(const OutlineEntry &entry)
  {
    auto *const present = const_cast<OutlineEntry *>(find_entry(entry.section, entry.name));
    if (present == nullptr)
      entries.push_back(entry);
    else if (present->where.file == entry.where.file && entry.where.file != command_line)
      throw InputError(entry.where,
                       "this entry is set a second time" + first_place(present->where),
                       "each entry once in a section");
    else
      *present = entry;
  }

  Outline
  read_outline(const std::string &file)
  {
    Outline           outline;
    const std::string ending = ".json";
    if (file.size() > ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0)
      read_json(file, outline);
    else
      read_prm(file, outline);
    return outline;
  }

  OutlineEntry
  parse_override(const std::string &text)
  {
    const auto        equals = text.find('=');
    const std::string path   = with_single_blanks(text.substr(0, equals));
    if (equals == std::string::npos || path.empty())
      throw InputError({command_line, 0, ""}, "found '" + text + "'", "Section/Name = value");
    const auto        slash   = path.rfind('/');
    const std::string section = slash == std::string::npos ? "" : trim(path.substr(0, slash));
    const std::string name    = trim(slash == std::string::npos ? path : path.substr(slash + 1));
    return {section, name, trim(text.substr(equals + 1)), {command_line, 0, path_of(section, name)}};
  }
} // namespace Amontons

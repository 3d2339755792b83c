#include <amontons/verification/study_entries.h>
#include <amontons/scene/text.h>

#include <algorithm>
#include <filesystem>

namespace Amontons
{
  namespace
  {
    const std::vector<std::string> kinds = {"convergence", "work precision", "stability"};

    Outline
    read(const std::string &file)
    {
      Outline outline;
      read_prm(file, outline);
      return outline;
    }

    StudyKind
    kind_of(const Outline &outline)
    {
      const OutlineEntry *const entry = outline.find_entry("", "Kind");
      if (entry == nullptr || entry->value.empty())
        return StudyKind::convergence;
      const auto found = std::find(kinds.begin(), kinds.end(), entry->value);
      if (found == kinds.end())
        throw InputError(entry->where,
                         "found '" + entry->value + "'" + suggestion(entry->value, kinds),
                         join(kinds, ", "));
      return static_cast<StudyKind>(found - kinds.begin());
    }

    std::vector<std::string>
    top_entries(const StudyKind kind)
    {
      std::vector<std::string> names = {"Kind", "Scene", "Title", "Output", "Overrides", "Quantities"};
      const auto               add   = [&](const std::vector<std::string> &more) {
        names.insert(names.end(), more.begin(), more.end());
      };
      if (kind == StudyKind::convergence)
        add({"Columns", "Against", "Per mesh", "Vary"});
      else
        add({"Expected", "Time limit"});
      if (kind == StudyKind::work_precision)
        add({"Targets", "Vary"});
      if (kind == StudyKind::stability)
        add({"Wrong above", "Threshold", "No solution where"});
      return names;
    }

    bool
    is_series(const std::string &section)
    {
      return section.rfind("Series ", 0) == 0;
    }

    std::vector<std::string>
    entries_of(const std::string &section, const StudyKind kind)
    {
      if (section.empty())
        return top_entries(kind);
      if (is_series(section))
        return {"Overrides"};
      std::vector<std::string> names;
      for (unsigned int i = 1; i <= StudyEntries::max_swept; ++i)
        names.push_back(std::to_string(i));
      for (unsigned int i = 1; kind != StudyKind::convergence && i <= StudyEntries::max_swept; ++i)
        names.push_back("Label " + std::to_string(i));
      return names;
    }

    bool
    is_entry_of_another_kind(const std::string &name, const StudyKind kind)
    {
      for (const StudyKind other : {StudyKind::convergence, StudyKind::work_precision, StudyKind::stability})
        if (const auto names = top_entries(other);
            other != kind && std::find(names.begin(), names.end(), name) != names.end())
          return true;
      return false;
    }

    void
    refuse_unknown(const Outline &outline, const StudyKind kind)
    {
      const bool has_series = kind != StudyKind::convergence;
      for (const OutlineSection &section : outline.sections)
        if (section.path != "Sweep" && !(has_series && is_series(section.path)))
          throw InputError(section.where,
                           "found the section '" + section.path + "'",
                           has_series ? "Sweep, Series NAME" : "Sweep");
      for (const OutlineEntry &entry : outline.entries)
        {
          const auto allowed = entries_of(entry.section, kind);
          if (std::find(allowed.begin(), allowed.end(), entry.name) != allowed.end())
            continue;
          const bool elsewhere = entry.section.empty() && is_entry_of_another_kind(entry.name, kind);
          throw InputError(entry.where,
                           elsewhere ? "it has no meaning in a study of the kind " + kinds[unsigned(kind)]
                                     : "there is no such entry" + suggestion(entry.name, allowed),
                           join(allowed, ", "));
        }
    }

    SweptParameter
    swept_parameter(const std::string &text, const SourceLocation &where)
    {
      const std::string allowed =
          "Section/Name [& Section/Name]: value, value, ... (or values separated by |)";
      int         depth = 0;
      std::size_t colon = 0;
      while (colon < text.size() && (text[colon] != ':' || depth > 0))
        {
          depth += (text[colon] == '(') - (text[colon] == ')');
          ++colon;
        }
      if (colon == text.size())
        throw InputError(where, "found '" + text + "' without ':'", allowed);
      SweptParameter    parameter;
      const std::string values = text.substr(colon + 1);
      parameter.names          = split(text.substr(0, colon), '&');
      parameter.values         = split(values, values.find('|') == std::string::npos ? ',' : '|');
      const auto is_empty      = [](const std::string &piece) { return piece.empty(); };
      if (parameter.names.empty() || parameter.values.empty() ||
          std::any_of(parameter.names.begin(), parameter.names.end(), is_empty) ||
          std::any_of(parameter.values.begin(), parameter.values.end(), is_empty))
        throw InputError(where, "found '" + text + "'", allowed);
      for (const std::string &name : parameter.names)
        if (name.find('=') != std::string::npos && name.find("{}") == std::string::npos)
          throw InputError(where,
                           "found '" + name + "', which does not say where the value stands",
                           "Section/Name = TEXT with {} for the value");
      const std::string first = trim(parameter.names[0].substr(0, parameter.names[0].find('=')));
      parameter.label         = first.substr(first.find_last_of('/') + 1);
      return parameter;
    }
  } // namespace

  std::vector<std::string>
  SweptParameter::overrides(const unsigned int value) const
  {
    std::vector<std::string> result;
    for (std::string name : names)
      {
        const auto place = name.find("{}");
        if (place == std::string::npos)
          name += " = " + values[value];
        for (auto at = place; at != std::string::npos; at = name.find("{}", at + values[value].size()))
          name.replace(at, 2, values[value]);
        result.push_back(name);
      }
    return result;
  }

  StudyEntries::StudyEntries(const std::string &file)
      : file(file), outline(read(file)), kind(kind_of(outline))
  {
    refuse_unknown(outline, kind);
  }

  SourceLocation
  StudyEntries::where(const std::string &section, const std::string &name) const
  {
    const OutlineEntry *const entry = outline.find_entry(section, name);
    return entry != nullptr ? entry->where : SourceLocation{file, 0, path_of(section, name)};
  }

  std::string
  StudyEntries::text(const std::string &name, const std::string &otherwise) const
  {
    const OutlineEntry *const entry = outline.find_entry("", name);
    return entry != nullptr && !entry->value.empty() ? entry->value : otherwise;
  }

  bool
  StudyEntries::is_true(const std::string &name) const
  {
    return choice(name, {"false", "true"}) == "true";
  }

  double
  StudyEntries::positive_number(const std::string &name, const double otherwise) const
  {
    if (text(name).empty())
      return otherwise;
    const auto number = as_number(text(name));
    if (!number || *number <= 0)
      throw InputError(where("", name), "found '" + text(name) + "'", "a positive number");
    return *number;
  }

  unsigned int
  StudyEntries::number_up_to(const std::string &name, const unsigned int most) const
  {
    for (unsigned int number = 0; number <= most; ++number)
      if (text(name, "0") == std::to_string(number))
        return number;
    throw InputError(
        where("", name), "found '" + text(name) + "'", "a number from 0 to " + std::to_string(most));
  }

  std::string
  StudyEntries::choice(const std::string &name, const std::vector<std::string> &allowed) const
  {
    std::string value = text(name, allowed[0]);
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
      throw InputError(where("", name), "found '" + value + "'", join(allowed, ", "));
    return value;
  }

  // Labels are the last components of the paths, as long as these differ.
  std::vector<SummaryPath>
  StudyEntries::paths(const std::string &name, const std::string &otherwise) const
  {
    const std::string        all = text(name, otherwise);
    std::vector<SummaryPath> result;
    for (const std::string &path : split(all, ','))
      {
        if (path.empty())
          throw InputError(where("", name),
                           "found an empty path in '" + all + "'",
                           "paths in summary.json, separated by commas");
        const std::string last = path.substr(path.find_last_of('.') + 1);
        const bool        taken =
            std::any_of(result.begin(), result.end(), [&](const SummaryPath &p) { return p.label == last; });
        result.push_back({path, taken ? path : last});
      }
    return result;
  }

  std::vector<std::string>
  StudyEntries::overrides(const std::string &section) const
  {
    const OutlineEntry *const entry = outline.find_entry(section, "Overrides");
    if (entry == nullptr)
      return {};
    std::vector<std::string> result = split(entry->value, '|');
    for (const std::string &text : result)
      if (text.find('=') == std::string::npos)
        throw InputError(entry->where, "found '" + text + "'", "Section/Name = value | ...");
    return result;
  }

  std::string
  StudyEntries::or_stem(const std::string &name) const
  {
    return text(name, std::filesystem::path(file).stem().string());
  }

  std::string
  StudyEntries::scene() const
  {
    if (text("Scene").empty())
      throw InputError({file, 0, "Scene"}, "no scene is given", "a scene file, relative to the study file");
    return (std::filesystem::path(file).parent_path() / text("Scene")).lexically_normal().string();
  }

  std::vector<SweptParameter>
  StudyEntries::sweep(const unsigned int last) const
  {
    std::vector<SweptParameter> result, at_the_end;
    for (unsigned int i = 1; i <= max_swept; ++i)
      {
        const OutlineEntry *const entry = outline.find_entry("Sweep", std::to_string(i));
        const bool                empty = entry == nullptr || entry->value.empty();
        if (empty && i == last)
          throw InputError(where("", "Vary"),
                           "found " + std::to_string(last) + ", which is not swept",
                           "the number of an entry of Sweep, or 0 for the last");
        const OutlineEntry *const label = outline.find_entry("Sweep", "Label " + std::to_string(i));
        if (empty && label != nullptr)
          throw InputError(label->where,
                           "found a label of what is not swept",
                           "entry '" + label->name.substr(6) + "' with it");
        if (empty)
          continue;
        SweptParameter parameter = swept_parameter(entry->value, entry->where);
        if (label != nullptr && !label->value.empty())
          parameter.label = label->value;
        (i == last ? at_the_end : result).push_back(parameter);
      }
    result.insert(result.end(), at_the_end.begin(), at_the_end.end());
    return result;
  }
} // namespace Amontons

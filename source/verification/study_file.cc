#include <amontons/verification/study_file.h>
#include <amontons/scene/outline.h>
#include <amontons/scene/text.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <filesystem>

namespace Amontons
{
  namespace
  {
    using namespace dealii;

    const unsigned int max_swept = 4;

    const std::vector<std::string> &
    names_of_top_entries()
    {
      static const std::vector<std::string> names = {
          "Scene", "Title", "Output", "Overrides", "Quantities", "Columns", "Against", "Per mesh", "Vary"};
      return names;
    }

    void
    declare(ParameterHandler &prm)
    {
      const Patterns::Anything anything;
      prm.declare_entry("Scene", "", anything, "The scene, relative to the study file.");
      prm.declare_entry(
          "Title", "", anything, "Over the tables and the chart; empty: the name of the study file.");
      prm.declare_entry(
          "Output", "", anything, "Directory for CSV and chart; empty: the name of the study file.");
      prm.declare_entry("Overrides", "", anything, "'Section/Name = value | ...' of all runs.");
      prm.declare_entry(
          "Quantities", "", anything, "Paths in summary.json of the errors, separated by commas.");
      prm.declare_entry(
          "Columns", "", anything, "Other numbers to show, among them 'dofs'; empty: cells, dofs, seconds.");
      prm.declare_entry(
          "Against", "closed form", Patterns::Selection("closed form|finest"), "What the errors refer to.");
      prm.declare_entry(
          "Per mesh", "false", Patterns::Bool(), "One row for each entry of the summary's 'meshes'.");
      prm.declare_entry(
          "Vary", "0", Patterns::Integer(0, max_swept), "The swept parameter of the rows; 0: the last.");
      prm.enter_subsection("Sweep");
      for (unsigned int i = 1; i <= max_swept; ++i)
        prm.declare_entry(std::to_string(i), "", anything, "'Section/Name [& Section/Name]: value, ...'");
      prm.leave_subsection();
    }

    // Passes the entries to the ParameterHandler, so that each message knows its line.
    void
    fill(ParameterHandler &prm, const Outline &outline)
    {
      for (const OutlineSection &section : outline.sections)
        if (section.path != "Sweep")
          throw InputError(section.where, "found the section '" + section.path + "'", "Sweep");
      for (const OutlineEntry &entry : outline.entries)
        {
          std::vector<std::string> allowed = names_of_top_entries();
          if (!entry.section.empty())
            {
              allowed.clear();
              for (unsigned int i = 1; i <= max_swept; ++i)
                allowed.push_back(std::to_string(i));
            }
          if (std::find(allowed.begin(), allowed.end(), entry.name) == allowed.end())
            throw InputError(
                entry.where, "there is no such entry" + suggestion(entry.name, allowed), join(allowed, ", "));
          if (!entry.section.empty())
            prm.enter_subsection(entry.section);
          try
            {
              prm.set(entry.name, entry.value);
            }
          catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
            {
              throw InputError(entry.where,
                               "found '" + entry.value + "'",
                               entry.name == "Against" ? "closed form, finest"
                               : entry.name == "Per mesh"
                                   ? "true, false"
                                   : "a number from 0 to " + std::to_string(max_swept));
            }
          if (!entry.section.empty())
            prm.leave_subsection();
        }
    }

    SourceLocation
    where_of(const Outline     &outline,
             const std::string &file,
             const std::string &section,
             const std::string &name)
    {
      const OutlineEntry *const entry = outline.find_entry(section, name);
      return entry != nullptr ? entry->where : SourceLocation{file, 0, path_of(section, name)};
    }

    // Labels are the last components of the paths, as long as these differ.
    std::vector<SummaryPath>
    paths(const std::string &text, const SourceLocation &where)
    {
      std::vector<SummaryPath> result;
      for (const std::string &path : split(text, ','))
        {
          if (path.empty())
            throw InputError(
                where, "found an empty path in '" + text + "'", "paths in summary.json, separated by commas");
          const std::string last  = path.substr(path.find_last_of('.') + 1);
          const bool        taken = std::any_of(
              result.begin(), result.end(), [&](const SummaryPath &p) { return p.label == last; });
          result.push_back({path, taken ? path : last});
        }
      return result;
    }

    // Values are separated by commas, or by | if there is one.
    SweptParameter
    swept_parameter(const std::string &text, const SourceLocation &where)
    {
      const std::string allowed =
          "Section/Name [& Section/Name]: value, value, ... (or values separated by |)";
      const auto colon = text.find(':');
      if (colon == std::string::npos)
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
      parameter.label = parameter.names[0].substr(parameter.names[0].find_last_of('/') + 1);
      return parameter;
    }

    void
    read_sweep(ParameterHandler &prm, const Outline &outline, Study &study)
    {
      const unsigned int          vary = prm.get_integer("Vary");
      std::vector<SweptParameter> last;
      for (unsigned int i = 1; i <= max_swept; ++i)
        {
          prm.enter_subsection("Sweep");
          const std::string text = prm.get(std::to_string(i));
          prm.leave_subsection();
          if (text.empty() && i == vary)
            throw InputError(where_of(outline, study.file, "", "Vary"),
                             "found " + std::to_string(vary) + ", which is not swept",
                             "the number of an entry of Sweep, or 0 for the last");
          if (!text.empty())
            (i == vary ? last : study.sweep)
                .push_back(swept_parameter(text, where_of(outline, study.file, "Sweep", std::to_string(i))));
        }
      study.sweep.insert(study.sweep.end(), last.begin(), last.end());
      if (study.sweep.empty() && !study.per_mesh)
        throw InputError(
            {study.file, 0, "Sweep"}, "nothing is swept", "entries '1' to '4', or Per mesh = true");
    }
  } // namespace

  Study
  read_study(const std::string &file)
  {
    Outline outline;
    read_prm(file, outline);
    ParameterHandler prm;
    declare(prm);
    fill(prm, outline);

    Study                       study;
    const std::filesystem::path path(file);
    const auto or_stem = [&](const std::string &text) { return text.empty() ? path.stem().string() : text; };
    study.file         = file;
    study.title        = or_stem(prm.get("Title"));
    study.output_directory = or_stem(prm.get("Output"));
    study.against_finest   = prm.get("Against") == "finest";
    study.per_mesh         = prm.get_bool("Per mesh");
    study.overrides        = split(prm.get("Overrides"), '|');
    study.quantities_where = where_of(outline, file, "", "Quantities");
    study.columns_where    = where_of(outline, file, "", "Columns");
    study.quantities       = paths(prm.get("Quantities"), study.quantities_where);
    study.columns          = paths(prm.get("Columns"), study.columns_where);
    if (study.columns.empty())
      study.columns =
          paths(study.per_mesh ? "cells, dofs, seconds" : "cells, dofs, finest_mesh_seconds, wall_seconds",
                study.columns_where);
    if (study.quantities.empty())
      throw InputError(
          study.quantities_where, "no quantity is given", "paths in summary.json, separated by commas");
    if (std::none_of(
            study.columns.begin(), study.columns.end(), [](const auto &c) { return c.label == "dofs"; }))
      throw InputError(
          study.columns_where, "the column 'dofs' is missing", "columns among which are the dofs");
    if (prm.get("Scene").empty())
      throw InputError({file, 0, "Scene"}, "no scene is given", "a scene file, relative to the study file");
    study.scene = (path.parent_path() / prm.get("Scene")).lexically_normal().string();
    for (const std::string &text : study.overrides)
      if (text.find('=') == std::string::npos)
        throw InputError(
            where_of(outline, file, "", "Overrides"), "found '" + text + "'", "Section/Name = value | ...");
    read_sweep(prm, outline, study);
    return study;
  }
} // namespace Amontons

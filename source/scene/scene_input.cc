#include <amontons/scene/scene_input.h>
#include <amontons/scene/scene_declarations.h>
#include <amontons/scene/text.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <functional>
#include <regex>
#include <sstream>

namespace Amontons
{
  using dealii::ParameterHandler;

  namespace
  {
    // The words of deal.II's patterns, without its infinities.
    std::string
    in_words(const std::string &pattern)
    {
      using std::regex;
      std::string text =
          dealii::Patterns::pattern_factory(pattern)->description(dealii::Patterns::PatternBase::Text);
      text = std::regex_replace(text, regex("A floating point number"), "a number");
      text = std::regex_replace(text, regex("An integer"), "an integer");
      text = std::regex_replace(text, regex("Any one of"), "one of");
      text = std::regex_replace(text, regex(" v such that -MAX_DOUBLE <= v <= MAX_DOUBLE"), "");
      text = std::regex_replace(
          text, regex("([vn]) such that (\\S+) <= [vn] <= (MAX_DOUBLE|2147483647)"), "$1 >= $2");
      return trim(std::regex_replace(
          text, regex("A list( of \\S+ to \\S+ elements)"), "a list$1, separated by commas,"));
    }

    std::string
    list_if_short(const std::vector<std::string> &names)
    {
      return names.size() <= 40 ? join(names, ", ") : "see --parameters";
    }

    std::vector<std::string>
    path_parts(const std::string &path)
    {
      return split(path, '/');
    }
  } // namespace

  SceneInput::SceneInput(const std::string              &file,
                         const std::vector<std::string> &overrides,
                         const ParameterGroups          &groups)
      : file(file), outline(read_outline(file))
  {
    for (const std::string &text : overrides)
      outline.add(parse_override(text));

    ParameterHandler prm;
    declare(prm, groups);
    collect_declarations(prm);
    for (const OutlineSection &section : outline.sections)
      check_section(section.path, section.where);
    for (const OutlineEntry &entry : outline.entries)
      {
        // JSON's {}, a section without entries, is read as an empty text.
        if (entry.value.empty() && is_declared(path_of(entry.section, entry.name)))
          continue;
        check_entry(entry);
        set(entry, prm);
      }

    const std::string name = prm.get("Kind");
    kind                   = name == "plane strain"   ? ProblemType::plane_strain
                             : name == "plane stress" ? ProblemType::plane_stress
                             : name == "axisymmetric" ? ProblemType::axisymmetric
                                                      : ProblemType::three_dimensional;
  }

  // The groups come first: a section that a group declares is never taken for a named one.
  void
  SceneInput::declare(ParameterHandler &prm, const ParameterGroups &groups)
  {
    declare_top_level(prm);
    for (ParameterGroup *const group : groups)
      group->declare(prm);
    for (const OutlineSection &section : outline.sections)
      {
        const NamedSection *const named = find_named_section(section.path);
        if (named == nullptr || section.path.find('/') != std::string::npos ||
            prm.subsection_path_exists({section.path}))
          continue;
        if (section.path == named->prefix)
          throw InputError(section.where, "this section has no name", named->prefix + " NAME");
        const std::string name = section.path.substr(named->prefix.size() + 1);
        if (!is_printable(name))
          throw InputError(section.where, "found the name '" + name + "'", "names in UTF-8");
        if (name.find_first_of(",;=()") != std::string::npos)
          throw InputError(section.where, "found the name '" + name + "'", "names without , ; = ( )");
        prm.enter_subsection(section.path);
        named->declare(prm);
        prm.leave_subsection();
        named_paths.push_back(section.path);
      }
  }

  // ParameterHandler lists its entries only in print.
  void
  SceneInput::collect_declarations(const ParameterHandler &prm)
  {
    using Tree = boost::property_tree::ptree;
    std::stringstream json;
    prm.print_parameters(json, ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
    Tree tree;
    boost::property_tree::read_json(json, tree);

    const std::function<void(const Tree &, const std::string &)> collect = [&](const Tree        &section,
                                                                               const std::string &path) {
      for (const auto &[name, child] : section)
        if (child.count("pattern_description") > 0)
          declarations.push_back({path,
                                  name,
                                  child.get<std::string>("default_value"),
                                  child.get<std::string>("pattern_description")});
        else if (child.count("alias") == 0)
          {
            declared_sections.push_back(path_of(path, name));
            collect(child, path_of(path, name));
          }
    };
    collect(tree, "");
  }

  const SceneInput::Declaration &
  SceneInput::declaration(const std::string &section, const std::string &name) const
  {
    const auto found = std::find_if(declarations.begin(), declarations.end(), [&](const Declaration &d) {
      return d.section == section && d.name == name;
    });
    Assert(found != declarations.end(), dealii::ExcMessage("No entry '" + path_of(section, name) + "'."));
    return *found;
  }

  bool
  SceneInput::is_declared(const std::string &section) const
  {
    return std::find(declared_sections.begin(), declared_sections.end(), section) != declared_sections.end();
  }

  void
  SceneInput::check_section(const std::string &path, const SourceLocation &where) const
  {
    if (path.empty() || is_declared(path))
      return;

    // Siblings of the unknown section; a misspelt prefix is compared with the name that follows it.
    const auto               slash  = path.rfind('/');
    const std::string        parent = slash == std::string::npos ? "" : path.substr(0, slash);
    const std::string        name   = slash == std::string::npos ? path : path.substr(slash + 1);
    std::vector<std::string> candidates, allowed;
    if (parent.empty())
      for (const NamedSection &section : named_sections())
        {
          auto end = std::string::npos;
          for (const char c : section.prefix + " ")
            if (c == ' ' && (end = name.find(' ', end + 1)) == std::string::npos)
              break;
          const bool is_misspelt = end != std::string::npos && name.substr(0, end) != section.prefix &&
                                   !suggestion(name.substr(0, end), {section.prefix}).empty();
          if (is_misspelt)
            candidates.push_back(section.prefix + name.substr(end));
          allowed.push_back(section.prefix + " NAME");
        }
    for (const std::string &section : declared_sections)
      {
        const auto last = section.rfind('/');
        if ((last == std::string::npos ? "" : section.substr(0, last)) != parent)
          continue;
        const std::string sibling = last == std::string::npos ? section : section.substr(last + 1);
        candidates.push_back(sibling);
        if (!is_named(section) || where.file == "--set")
          allowed.push_back(sibling);
      }
    throw InputError(where,
                     "unknown section '" + name + "'" + suggestion(name, candidates),
                     allowed.empty() ? "no sections here" : list_if_short(allowed));
  }

  void
  SceneInput::check_entry(const OutlineEntry &entry) const
  {
    check_section(entry.section, entry.where);
    std::vector<std::string> names;
    for (const Declaration &declaration : declarations)
      if (declaration.section == entry.section)
        names.push_back(declaration.name);
    if (std::find(names.begin(), names.end(), entry.name) == names.end())
      throw InputError(entry.where,
                       "unknown entry '" + entry.name + "'" + suggestion(entry.name, names),
                       names.empty() ? "no entries here" : list_if_short(names));
  }

  void
  SceneInput::set(const OutlineEntry &entry, ParameterHandler &prm) const
  {
    const std::vector<std::string> path = path_parts(entry.section);
    for (const std::string &part : path)
      prm.enter_subsection(part);
    try
      {
        prm.set(entry.name, entry.value);
      }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
      {
        throw InputError(entry.where,
                         "found '" + entry.value + "'",
                         in_words(declaration(entry.section, entry.name).pattern));
      }
    for (std::size_t i = 0; i < path.size(); ++i)
      prm.leave_subsection();
  }

  bool
  SceneInput::is_named(const std::string &path) const
  {
    return std::find(named_paths.begin(), named_paths.end(), path) != named_paths.end();
  }

  std::vector<SectionInput>
  SceneInput::sections(const std::string &prefix) const
  {
    std::vector<SectionInput> result;
    for (const std::string &path : named_paths)
      if (find_named_section(path)->prefix == prefix)
        result.emplace_back(*this, path, trim(path.substr(prefix.size())));
    return result;
  }
} // namespace Amontons

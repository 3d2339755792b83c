#include <amontons/base/text_file.h>
#include <amontons/scene/outline.h>
#include <amontons/scene/text.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <sstream>

namespace Amontons
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    bool
    is_array(const Tree &tree)
    {
      return !tree.empty() &&
             std::all_of(tree.begin(), tree.end(), [](const auto &child) { return child.first.empty(); });
    }

    // Arrays of numbers and names are written with commas in a .prm file, components (expressions) with
    // semicolons.
    std::string
    value_of(const std::string &name, const Tree &tree)
    {
      static const std::vector<std::string> components = {
          "Displacement", "Force", "Rotation", "Moment", "Value", "Body force", "Curved boundaries"};
      if (tree.empty())
        return trim(tree.data());
      const bool  semicolons = std::find(components.begin(), components.end(), name) != components.end();
      std::string text;
      for (auto child = tree.begin(); child != tree.end(); ++child)
        text += (child == tree.begin() ? "" : semicolons ? "; " : ", ") + trim(child->second.data());
      return text;
    }

    void
    flatten(const Tree &tree, const std::string &file, const std::string &section, Outline &outline)
    {
      for (const auto &[key, child] : tree)
        {
          const std::string name = with_single_blanks(key), path = path_of(section, name);
          if (name.empty())
            throw InputError({file, 0, section}, "found an array of sections", "an object {\"NAME\": ...}");
          if (child.empty() || is_array(child))
            outline.add(OutlineEntry{section, name, value_of(name, child), {file, 0, path}});
          else
            {
              if (name.find('/') != std::string::npos)
                throw InputError(
                    {file, 0, path}, "found a section named '" + name + "'", "a name without '/'");
              outline.add(OutlineSection{path, {file, 0, path}});
              flatten(child, file, path, outline);
            }
        }
    }

    // The parser calls itself for each level.
    void
    refuse_deep_nesting(const std::string &text, const std::string &file)
    {
      constexpr int most  = 100;
      int           depth = 0, line = 1;
      bool          in_text = false;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          const char c = text[i];
          line += c == '\n' ? 1 : 0;
          if (c == '\\' && in_text)
            ++i;
          else if (c == '"')
            in_text = !in_text;
          else if (!in_text && (c == '{' || c == '['))
            ++depth;
          else if (!in_text && (c == '}' || c == ']'))
            --depth;
          if (depth > most)
            throw InputError({file, line, ""},
                             "nested more than " + std::to_string(most) + " levels deep",
                             "{\"Section\": {\"Name\": value, ...}, ...}");
        }
    }
  } // namespace

  void
  read_json(const std::string &file, Outline &outline)
  {
    std::istringstream stream(
        read_text_file(file, {file, 0, ""}, "the file", "a readable .prm or .json file", largest_scene_file));
    refuse_deep_nesting(stream.str(), file);
    Tree tree;
    try
      {
        boost::property_tree::read_json(stream, tree);
      }
    catch (const boost::property_tree::json_parser_error &error)
      {
        throw InputError({file, static_cast<int>(error.line()), ""},
                         "this is no JSON: " + error.message(),
                         "{\"Section\": {\"Name\": value, ...}, ...}");
      }
    flatten(tree, file, "", outline);
  }
} // namespace Amontons

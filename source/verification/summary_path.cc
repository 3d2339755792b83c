#include <amontons/scene/text.h>
#include <amontons/verification/summary_path.h>

#include <limits>

namespace Amontons
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    void
    collect_paths(const Tree &tree, const std::string &prefix, std::vector<std::string> &paths)
    {
      for (const auto &[key, child] : tree)
        if (!key.empty())
          {
            const std::string path = prefix.empty() ? key : prefix + "." + key;
            if (child.empty())
              paths.push_back(path);
            collect_paths(child, path, paths);
          }
    }

    // The node at "pairs.0.normal_force"; numbers count the elements of arrays. nullptr if there is none.
    const Tree *
    find(const Tree &summary, const std::string &path)
    {
      const Tree *node = &summary;
      for (const std::string &key : split(path, '.'))
        {
          const bool is_index = key.find_first_not_of("0123456789") == std::string::npos && key.size() < 9;
          if (is_index && !key.empty() && std::stoul(key) < node->size())
            node = &std::next(node->begin(), std::stoul(key))->second;
          else if (node->find(key) != node->not_found())
            node = &node->find(key)->second;
          else
            return nullptr;
        }
      return node;
    }
  } // namespace

  double
  number_at(const Tree &summary, const SummaryPath &path, const SourceLocation &where)
  {
    const Tree *const child = find(summary, path.path);
    if (child != nullptr)
      return child->get_value_optional<double>().value_or(std::numeric_limits<double>::quiet_NaN());
    std::vector<std::string> paths;
    collect_paths(summary, "", paths);
    std::string allowed;
    for (const std::string &p : paths)
      allowed += (allowed.empty() ? "" : ", ") + p;
    throw InputError(where,
                     "found '" + path.path + "', which the summary does not have" +
                         suggestion(path.path, paths),
                     allowed);
  }
} // namespace Amontons

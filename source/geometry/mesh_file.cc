#include <amontons/geometry/mesh_file.h>

#include <algorithm>
#include <charconv>

namespace Amontons
{
  namespace
  {
    std::string_view
    trim(std::string_view s)
    {
      const char *const white_space = " \t\r\n";
      const std::size_t first       = s.find_first_not_of(white_space);
      if (first == std::string_view::npos)
        return {};
      return s.substr(first, s.find_last_not_of(white_space) - first + 1);
    }
  } // namespace

  MeshText::MeshText(std::string text, const SourceLocation &where) : text(std::move(text)), where(where)
  {
    this->where.line = 0;
  }

  bool
  MeshText::next_line()
  {
    if (position >= text.size())
      return false;
    previous              = position;
    const std::size_t end = std::min(text.find('\n', position), text.size());
    current               = trim(std::string_view(text).substr(position, end - position));
    position              = end + 1;
    ++where.line;
    return true;
  }

  void
  MeshText::need_line(const std::string &what)
  {
    if (!next_line())
      fail("the file ends within " + what, "a complete mesh file");
  }

  void
  MeshText::unread_line()
  {
    position = previous;
    --where.line;
  }

  void
  MeshText::rewind()
  {
    position = previous = 0;
    where.line          = 0;
  }

  std::vector<std::string_view>
  MeshText::fields(const char separator) const
  {
    std::vector<std::string_view> result;
    std::string_view              rest = current;
    while (!rest.empty())
      {
        const std::size_t end =
            std::min(separator == ' ' ? rest.find_first_of(" \t") : rest.find(separator), rest.size());
        result.push_back(trim(rest.substr(0, end)));
        rest = end < rest.size() ? trim(rest.substr(end + 1)) : std::string_view();
      }
    return result;
  }

  void
  MeshText::fail(const std::string &found, const std::string &allowed) const
  {
    throw InputError(where, found, allowed);
  }

  long
  MeshText::integer(const std::string_view field) const
  {
    long       value  = 0;
    const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
    if (result.ec != std::errc() || result.ptr != field.data() + field.size())
      fail("found '" + std::string(field.substr(0, 40)) + "'", "an integer");
    return value;
  }

  double
  MeshText::number(std::string_view field) const
  {
    if (!field.empty() && field.front() == '+')
      field.remove_prefix(1);
    double     value  = 0;
    const auto result = std::from_chars(field.data(), field.data() + field.size(), value);
    if (result.ec != std::errc() || result.ptr != field.data() + field.size() || !(std::abs(value) < 1e300))
      fail("found '" + std::string(field.substr(0, 40)) + "'", "a finite number");
    return value;
  }

  unsigned int
  FileMesh::node(const long id, const MeshText &text) const
  {
    const auto entry = node_numbers.find(id);
    if (entry == node_numbers.end())
      text.fail("there is no node " + std::to_string(id), "the number of a node of this file");
    return entry->second;
  }

  void
  FileMesh::add_node(const long id, const dealii::Point<3> &p, const MeshText &text)
  {
    if (!node_numbers.emplace(id, nodes.size()).second)
      text.fail("node " + std::to_string(id) + " is defined twice", "one line per node");
    nodes.push_back(p);
  }

  void
  FileMesh::add_middle_nodes(const Cell                                     &cell,
                             const std::vector<unsigned int>                &middle,
                             const std::vector<std::array<unsigned int, 2>> &edges,
                             const std::vector<std::array<unsigned int, 4>> &faces)
  {
    const auto of_corners = [&](auto corners) {
      for (unsigned int &corner : corners)
        corner = cell.nodes[corner];
      std::sort(corners.begin(), corners.end());
      return corners;
    };
    for (unsigned int k = 0; k < middle.size(); ++k)
      if (k < edges.size())
        edge_nodes[of_corners(edges[k])] = middle[k];
      else if (k < edges.size() + faces.size())
        face_nodes[of_corners(faces[k - edges.size()])] = middle[k];
  }

  void
  FileMesh::add_other(const std::string &kind, const int line)
  {
    if (n_others++ == 0)
      {
        other_cells = kind;
        other_line  = line;
      }
  }
} // namespace Amontons

// What the parsers of mesh files share: a text with line numbers, and a mesh as the file writes it.
#pragma once

#include <amontons/base/input_error.h>

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace Amontons
{
  // ".msh" of "a/b.MSH"
  std::string
  file_ending(const std::string &file);

  // A text file that is read line by line; errors carry the line.
  class MeshText
  {
  public:
    MeshText(std::string text, const SourceLocation &where);

    // The next line, without white space at its ends; false at the end of the text.
    bool
    next_line();
    // The same, but the end of the text is an error: the file ends within `what`.
    void
    need_line(const std::string &what);
    void
    unread_line(); // once
    void
    rewind();
    std::string_view
    line() const
    {
      return current;
    }
    int
    line_number() const
    {
      return where.line;
    }
    // Separated by white space, or by `separator` with white space around it; without empty ones at the end.
    std::vector<std::string_view>
    fields(const char separator = ' ') const;

    [[noreturn]] void
    fail(const std::string &found, const std::string &allowed = "") const;

    long
    integer(const std::string_view field) const;
    double
    number(const std::string_view field) const;

  private:
    const std::string text;
    std::size_t       position = 0;
    std::size_t       previous = 0;
    std::string_view  current;
    SourceLocation    where;
  };

  // Quadrilaterals and hexahedra by their corners in gmsh's (and Abaqus') order. Of quadratic ones, the nodes
  // in the middle of edges and faces are kept.
  struct FileMesh
  {
    struct Cell
    {
      std::array<unsigned int, 8> nodes;
      int                         line;
    };
    struct Face
    {
      std::array<unsigned int, 4> nodes; // the first two in 2D
      unsigned int                name;
    };

    // The position in `nodes` of the node that the file calls `id`.
    unsigned int
    node(const long id, const MeshText &text) const;
    void
    add_node(const long id, const dealii::Point<3> &p, const MeshText &text);

    std::vector<dealii::Point<3>>                       nodes;
    std::unordered_map<long, unsigned int>              node_numbers;
    std::vector<Cell>                                   cells;
    std::vector<std::string>                            names;
    std::vector<Face>                                   faces;
    std::map<std::array<unsigned int, 2>, unsigned int> edge_nodes; // by the ends in ascending order
    std::map<std::array<unsigned int, 4>, unsigned int> face_nodes; // of hexahedra, by the corners likewise
    std::set<std::string>                               parts;      // that have cells, whether read or not
    // Cells of another kind than quadrilaterals or hexahedra: what they are, the line of the first, and how
    // many.
    std::string  other_cells;
    int          other_line = 0;
    unsigned int n_others   = 0;

    void
    add_other(const std::string &kind, const int line);
    // `middle`: the other nodes of the cell (in the order of gmsh or Abaqus), of which the first lie on the
    // given edges and the next on the given faces of corners; what is left lies inside.
    void
    add_middle_nodes(const Cell                                     &cell,
                     const std::vector<unsigned int>                &middle,
                     const std::vector<std::array<unsigned int, 2>> &edges,
                     const std::vector<std::array<unsigned int, 4>> &faces);
  };

  // part: the cells that are read, those of a physical group; "": all.
  FileMesh
  parse_gmsh(MeshText &text, const unsigned int dim, const std::string &part = "");

  // part: an element set, a *PART or an *INSTANCE.
  FileMesh
  parse_abaqus(MeshText &text, const unsigned int dim, const std::string &part = "");
} // namespace Amontons

#include <amontons/geometry/mesh_file.h>

#include <map>

namespace Amontons
{
  namespace
  {
    struct ElementType
    {
      int          number;
      unsigned int dim, n_corners, n_nodes;
      const char  *kind; // other than point, line, quadrilateral, hexahedron
    };

    const std::vector<ElementType> gmsh_elements = {
        {15, 0, 1, 1, nullptr},       {1, 1, 2, 2, nullptr},        {8, 1, 2, 3, nullptr},
        {26, 1, 2, 4, nullptr},       {2, 2, 3, 3, "triangles"},    {9, 2, 3, 6, "triangles"},
        {21, 2, 3, 10, "triangles"},  {3, 2, 4, 4, nullptr},        {10, 2, 4, 9, nullptr},
        {16, 2, 4, 8, nullptr},       {36, 2, 4, 16, nullptr},      {4, 3, 4, 4, "tetrahedra"},
        {11, 3, 4, 10, "tetrahedra"}, {29, 3, 4, 20, "tetrahedra"}, {5, 3, 8, 8, nullptr},
        {12, 3, 8, 27, nullptr},      {17, 3, 8, 20, nullptr},      {92, 3, 8, 64, nullptr},
        {6, 3, 6, 6, "prisms"},       {13, 3, 6, 18, "prisms"},     {18, 3, 6, 15, "prisms"},
        {7, 3, 5, 5, "pyramids"},     {14, 3, 5, 14, "pyramids"},   {19, 3, 5, 13, "pyramids"}};

    // Of the nodes of second order, in gmsh's order: after those of the edges, 27-node hexahedra have those
    // of the faces.
    const std::vector<std::array<unsigned int, 2>> gmsh_quadrilateral_edges = {
        {{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
    const std::vector<std::array<unsigned int, 2>> gmsh_hexahedron_edges = {{{0, 1}},
                                                                            {{0, 3}},
                                                                            {{0, 4}},
                                                                            {{1, 2}},
                                                                            {{1, 5}},
                                                                            {{2, 3}},
                                                                            {{2, 6}},
                                                                            {{3, 7}},
                                                                            {{4, 5}},
                                                                            {{4, 7}},
                                                                            {{5, 6}},
                                                                            {{6, 7}}};
    const std::vector<std::array<unsigned int, 4>> gmsh_hexahedron_faces = {
        {{0, 3, 2, 1}}, {{0, 1, 5, 4}}, {{0, 4, 7, 3}}, {{1, 2, 6, 5}}, {{2, 3, 7, 6}}, {{4, 5, 6, 7}}};

    // Of the types with one node in the middle of each edge.
    bool
    is_of_second_order(const ElementType &t)
    {
      return t.n_nodes == (t.dim == 2 ? 8 : 20) || t.n_nodes == (t.dim == 2 ? 9 : 27);
    }

    bool
    is_of_third_order(const ElementType &t)
    {
      return t.n_nodes == (t.dim == 2 ? 16 : 64);
    }

    // Of the edges, then of the faces of a cell of third order, what its cubic polynomials have in the
    // middle: the weights of the nodes along an edge are there -1, 9, 9, -1 by 16, on a face their products.
    std::vector<dealii::Point<3>>
    middles_of_cubic(const std::vector<dealii::Tensor<1, 3>>        &nodes,
                     const unsigned int                              n_corners,
                     const std::vector<std::array<unsigned int, 2>> &edges,
                     const std::vector<std::array<unsigned int, 4>> &faces)
    {
      std::vector<dealii::Point<3>>                               result;
      auto                                                        inner = nodes.begin() + n_corners;
      std::map<std::array<unsigned int, 2>, dealii::Tensor<1, 3>> on_edge; // both inner nodes
      for (const auto &[i, j] : edges)
        {
          const auto sum = on_edge[{i, j}] = inner[0] + inner[1];
          result.emplace_back((9. * sum - nodes[i] - nodes[j]) / 16);
          inner += 2;
        }
      for (const auto &face : faces)
        {
          dealii::Tensor<1, 3> sum = 81. * (inner[0] + inner[1] + inner[2] + inner[3]);
          for (const unsigned int i : face)
            {
              sum += nodes[i];
              for (const unsigned int j : face)
                if (const auto edge = on_edge.find({i, j}); edge != on_edge.end())
                  sum -= 9. * edge->second;
            }
          result.emplace_back(sum / 256);
          inner += 4;
        }
      return result;
    }

    class GmshParser
    {
    public:
      GmshParser(MeshText &text, const unsigned int dim, const std::string &part)
          : text(text), dim(dim), part(part)
      {
      }

      FileMesh
      parse()
      {
        while (text.next_line())
          {
            const std::string section(text.line());
            if (section == "$MeshFormat")
              read_format();
            else if (section == "$PhysicalNames")
              read_names();
            else if (section == "$Entities")
              read_entities();
            else if (section == "$Nodes")
              version < 4 ? read_nodes_2() : read_nodes_4();
            else if (section == "$Elements")
              version < 4 ? read_elements_2() : read_elements_4();
            else if (section == "$PartitionedEntities")
              text.fail("the mesh is partitioned", "a mesh in one part: without -part in gmsh");
            else if (!section.empty() && section[0] == '$')
              skip(section);
            else if (version == 0)
              text.fail("this is no gmsh mesh", "a file that begins with $MeshFormat");
          }
        for (const char *const needed : {"$MeshFormat", "$Nodes", "$Elements"})
          if (sections.count(needed) == 0)
            text.fail("the file ends without " + std::string(needed), "a complete gmsh mesh");
        return mesh;
      }

    private:
      using Fields = std::vector<std::string_view>;

      Fields
      line(const std::string &section, const std::size_t n_fields)
      {
        text.need_line(section);
        Fields fields = text.fields();
        if (fields.size() < n_fields)
          text.fail("damaged " + section + ": " + std::to_string(fields.size()) + " fields in this line",
                    "at least " + std::to_string(n_fields));
        return fields;
      }

      // The line that closes a section whose count of entries has been read.
      void
      end(const std::string &section)
      {
        text.need_line(section);
        if (text.line() != "$End" + section.substr(1))
          text.fail("found '" + std::string(text.line().substr(0, 40)) + "' where " + section + " should end",
                    "$End" + section.substr(1) + " (the section's counts are wrong, or lines are missing)");
        ++sections[section];
      }

      void
      skip(const std::string &section)
      {
        do
          text.need_line(section);
        while (text.line() != "$End" + section.substr(1));
      }

      void
      read_format()
      {
        const Fields fields = line("$MeshFormat", 3);
        version             = text.number(fields[0]);
        if (version != 2.2 && version != 4.1)
          text.fail("version " + std::string(fields[0]) + " of gmsh's format",
                    "versions 2.2 and 4.1 (gmsh -format msh41)");
        if (fields[1] != "0")
          text.fail("a binary mesh", "an ASCII mesh (Mesh.Binary = 0 in gmsh)");
        end("$MeshFormat");
      }

      void
      read_names()
      {
        const long n = text.integer(line("$PhysicalNames", 1)[0]);
        for (long i = 0; i < n; ++i)
          {
            const Fields      fields = line("$PhysicalNames", 3);
            const std::string whole(text.line());
            const std::size_t first = whole.find('"'), last = whole.rfind('"');
            if (first == std::string::npos || last <= first)
              text.fail("damaged $PhysicalNames: no name in quotes", "dimension number \"name\"");
            if (const long d = text.integer(fields[0]); d == dim - 1 || d == dim)
              group_names[d == dim][text.integer(fields[1])] = whole.substr(first + 1, last - first - 1);
          }
        end("$PhysicalNames");
      }

      void
      read_entities()
      {
        const Fields counts = line("$Entities", 4);
        for (unsigned int d = 0; d < 4; ++d)
          for (long i = text.integer(counts[d]); i > 0; --i)
            {
              const std::size_t at     = d == 0 ? 4 : 7;
              const Fields      fields = line("$Entities", at + 1);
              const long        n      = text.integer(fields[at]);
              if (n < 0 || fields.size() - (at + 1) < std::size_t(n))
                text.fail("damaged $Entities: " + std::to_string(n) + " physical groups are announced",
                          "as many as the line names");
              for (long k = 1; (d == dim - 1 || d == dim) && k <= n; ++k)
                entity_groups[d == dim][text.integer(fields[0])].push_back(text.integer(fields[at + k]));
            }
        end("$Entities");
      }

      dealii::Point<3>
      point(const Fields &fields, const unsigned int first) const
      {
        return {text.number(fields[first]), text.number(fields[first + 1]), text.number(fields[first + 2])};
      }

      void
      read_nodes_2()
      {
        const long n = text.integer(line("$Nodes", 1)[0]);
        for (long i = 0; i < n; ++i)
          {
            const Fields fields = line("$Nodes", 4);
            mesh.add_node(text.integer(fields[0]), point(fields, 1), text);
          }
        end("$Nodes");
      }

      void
      read_nodes_4()
      {
        const long n_blocks = text.integer(line("$Nodes", 4)[0]);
        for (long b = 0; b < n_blocks; ++b)
          {
            const long        n = block_size("$Nodes");
            std::vector<long> ids;
            for (long i = 0; i < n; ++i)
              ids.push_back(text.integer(line("$Nodes", 1)[0]));
            for (const long id : ids)
              mesh.add_node(id, point(line("$Nodes", 3), 0), text);
          }
        end("$Nodes");
      }

      // The last of the four numbers that head a block.
      long
      block_size(const std::string &section)
      {
        const long n = text.integer(line(section, 4)[3]);
        if (n < 0)
          text.fail("damaged " + section + ": a block of " + std::to_string(n) + " entries");
        return n;
      }

      const ElementType &
      type(const long number) const
      {
        for (const ElementType &t : gmsh_elements)
          if (t.number == number)
            return t;
        text.fail("elements of gmsh's type " + std::to_string(number),
                  "quadrilaterals and hexahedra of order 1 to 3 (Mesh.ElementOrder = 1)");
      }

      // Its number, if it has no name. Elements may belong to a group with the minus sign of their direction.
      std::string
      group_name(const bool of_cells, const long group) const
      {
        const auto name = group_names[of_cells].find(std::abs(group));
        return name != group_names[of_cells].end() ? name->second : std::to_string(std::abs(group));
      }

      unsigned int
      group_index(const long group)
      {
        const auto [entry, is_new] = group_indices.emplace(std::abs(group), mesh.names.size());
        if (is_new)
          mesh.names.push_back(group_name(false, group));
        return entry->second;
      }

      bool
      is_of_part(const std::vector<long> &groups)
      {
        bool is_named = part.empty();
        for (const long group : groups)
          {
            const std::string name = group_name(true, group);
            is_named               = is_named || name == part;
            mesh.parts.insert(name);
          }
        return is_named;
      }

      // An element of these physical groups whose nodes are the fields from `first` on.
      void
      add_element(const ElementType       &t,
                  const std::vector<long> &groups,
                  const Fields            &fields,
                  const std::size_t        first)
      {
        if (fields.size() < first + t.n_nodes)
          text.fail("damaged $Elements: an element with " + std::to_string(fields.size() - first) + " nodes",
                    std::to_string(t.n_nodes) + " nodes for this type");
        if (t.dim > dim)
          text.fail("three-dimensional elements in a two-dimensional scene", "a plane mesh (gmsh -2)");
        if (t.dim == dim && !is_of_part(groups))
          return;
        if (t.dim == dim && t.kind != nullptr)
          mesh.add_other(t.kind, text.line_number());
        else if (t.dim == dim)
          {
            FileMesh::Cell cell{{}, text.line_number()};
            for (unsigned int v = 0; v < t.n_corners; ++v)
              cell.nodes[v] = mesh.node(text.integer(fields[first + v]), text);
            mesh.cells.push_back(cell);
            add_middle_nodes(t, cell, fields, first);
          }
        else if (t.dim == dim - 1 && t.kind == nullptr && !groups.empty())
          {
            FileMesh::Face face{{}, group_index(groups[0])};
            for (unsigned int v = 0; v < t.n_corners; ++v)
              face.nodes[v] = mesh.node(text.integer(fields[first + v]), text);
            mesh.faces.push_back(face);
          }
      }

      void
      add_middle_nodes(const ElementType    &t,
                       const FileMesh::Cell &cell,
                       const Fields         &fields,
                       const std::size_t     first)
      {
        const auto &edges = dim == 2 ? gmsh_quadrilateral_edges : gmsh_hexahedron_edges;
        const auto  faces = dim == 2 ? std::vector<std::array<unsigned int, 4>>() : gmsh_hexahedron_faces;
        std::vector<unsigned int> middle;
        if (is_of_second_order(t))
          for (unsigned int v = t.n_corners; v < t.n_nodes; ++v)
            middle.push_back(mesh.node(text.integer(fields[first + v]), text));
        else if (is_of_third_order(t))
          {
            std::vector<dealii::Tensor<1, 3>> nodes;
            for (unsigned int v = 0; v < t.n_nodes; ++v)
              nodes.push_back(mesh.nodes[mesh.node(text.integer(fields[first + v]), text)]);
            for (const auto &p : middles_of_cubic(nodes, t.n_corners, edges, faces))
              {
                middle.push_back(mesh.nodes.size());
                mesh.nodes.push_back(p);
              }
          }
        mesh.add_middle_nodes(cell, middle, edges, faces);
      }

      void
      read_elements_2()
      {
        const long n = text.integer(line("$Elements", 1)[0]);
        for (long i = 0; i < n; ++i)
          {
            const Fields      fields = line("$Elements", 4);
            const std::size_t n_tags = text.integer(fields[2]);
            if (n_tags > 100 || fields.size() < 3 + n_tags)
              text.fail("damaged $Elements: tags are missing");
            const long group = n_tags > 0 ? text.integer(fields[3]) : 0;
            add_element(type(text.integer(fields[1])),
                        group != 0 ? std::vector<long>{group} : std::vector<long>(),
                        fields,
                        3 + n_tags);
          }
        end("$Elements");
      }

      void
      read_elements_4()
      {
        const long n_blocks = text.integer(line("$Elements", 4)[0]);
        for (long b = 0; b < n_blocks; ++b)
          {
            const long         n      = block_size("$Elements");
            const Fields       head   = text.fields();
            const ElementType &t      = type(text.integer(head[2]));
            const long         entity = text.integer(head[1]);
            std::vector<long>  groups;
            if (t.dim == dim - 1 || t.dim == dim)
              if (const auto of = entity_groups[t.dim == dim].find(entity);
                  of != entity_groups[t.dim == dim].end())
                groups = of->second;
            for (long i = 0; i < n; ++i)
              add_element(t, groups, line("$Elements", 2), 1);
          }
        end("$Elements");
      }

      MeshText                  &text;
      const unsigned int         dim;
      const std::string          part;
      double                     version = 0;
      FileMesh                   mesh;
      std::map<std::string, int> sections; // complete ones
      // Of faces (dimension dim-1) and of cells.
      std::array<std::map<long, std::string>, 2>       group_names;
      std::array<std::map<long, std::vector<long>>, 2> entity_groups;
      std::map<long, unsigned int>                     group_indices; // of faces
    };
  } // namespace

  FileMesh
  parse_gmsh(MeshText &text, const unsigned int dim, const std::string &part)
  {
    return GmshParser(text, dim, part).parse();
  }
} // namespace Amontons

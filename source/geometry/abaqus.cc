#include <amontons/geometry/abaqus.h>

#include <deal.II/base/numbers.h>

#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <map>

namespace Amontons
{
  namespace
  {
    // Of the nodes of second order, in Abaqus' order. What comes after those of the edges (27-node hexahedra)
    // follows from these.
    const std::vector<std::array<unsigned int, 2>> abaqus_quadrilateral_edges = {
        {{0, 1}}, {{1, 2}}, {{2, 3}}, {{3, 0}}};
    const std::vector<std::array<unsigned int, 2>> abaqus_hexahedron_edges = {{{0, 1}},
                                                                              {{1, 2}},
                                                                              {{2, 3}},
                                                                              {{3, 0}},
                                                                              {{4, 5}},
                                                                              {{5, 6}},
                                                                              {{6, 7}},
                                                                              {{7, 4}},
                                                                              {{0, 4}},
                                                                              {{1, 5}},
                                                                              {{2, 6}},
                                                                              {{3, 7}}};

    class AbaqusParser
    {
    public:
      AbaqusParser(MeshText &text, const unsigned int dim, const std::string &part)
          : text(text), dim(dim), part(upper_case(part))
      {
      }

      FileMesh
      parse()
      {
        find_parts();
        if (!assembly.choose(part))
          {
            mesh.parts = assembly.names();
            return mesh;
          }
        while (text.next_line())
          if (is_keyword())
            {
              read_keyword();
              if (keyword == "*PART")
                inside = options["NAME"];
              else if (keyword == "*ENDPART")
                inside.clear();
              else if (keyword == "*INSTANCE")
                read_instance();
              else if (keyword == "*ENDINSTANCE")
                move_instance();
              else if (!assembly.is_of_another_part(inside) && !assembly.is_of_another_instance(in_instance))
                read_mesh();
            }
        if (!in_instance.empty())
          text.fail("the file ends within an instance", "*END INSTANCE");
        if (mesh.nodes.empty())
          text.fail("the file has no nodes", "*NODE and *ELEMENT");
        keep_cells();
        add_element_sets();
        add_node_sets();
        return mesh;
      }

    private:
      struct Element
      {
        unsigned int                dim;
        std::array<unsigned int, 8> nodes;
      };

      struct OtherElement
      {
        long        id;
        const char *kind;
        int         line;
      };

      void
      find_parts()
      {
        std::string name;
        while (text.next_line())
          if (is_keyword())
            {
              read_keyword();
              if (keyword == "*PART")
                name = need("NAME");
              else if (keyword == "*ENDPART" || keyword == "*ENDINSTANCE")
                name.clear();
              else if (keyword == "*ELEMENT" && !name.empty())
                assembly.parts.emplace(upper_case(name), name);
              else if (keyword == "*INSTANCE")
                {
                  name                                = values["PART"]; // its mesh may stand here
                  assembly.instances[options["NAME"]] = need("NAME");
                  assembly.part_of[options["NAME"]]   = options["PART"];
                }
            }
        text.rewind();
      }

      // "*INSTANCE, NAME=shaft-1, PART=shaft": first a shift, then a rotation about the axis through two
      // points, by an angle in degrees.
      void
      read_instance()
      {
        in_instance = options["NAME"];
        shift = turn = {};
        if (assembly.is_of_another_instance(in_instance) || !next_data_line())
          return;
        shift = numbers(2);
        if (next_data_line())
          turn = numbers(7);
        if (turn[6] != 0 && turn[0] == turn[3] && turn[1] == turn[4] && turn[2] == turn[5])
          text.fail("an axis without a direction", "two points of it, and an angle");
      }

      void
      move_instance()
      {
        if (!assembly.is_of_another_instance(in_instance))
          for (auto &p : mesh.nodes)
            {
              for (unsigned int d = 0; d < 3; ++d)
                p[d] += shift[d];
              if (turn[6] == 0)
                continue;
              const dealii::Point<3> from(turn[0], turn[1], turn[2]), to(turn[3], turn[4], turn[5]);
              const auto             axis = to - from;
              p = from + dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
                             dealii::Point<3>(axis / axis.norm()), turn[6] * dealii::numbers::PI / 180) *
                             (p - from);
            }
        in_instance.clear();
      }

      // Of the line; what is missing of seven is 0.
      std::array<double, 7>
      numbers(const unsigned int n_needed) const
      {
        const auto fields = text.fields(',');
        if (fields.size() < n_needed || fields.size() > 7)
          text.fail("an instance moved by " + std::to_string(fields.size()) + " numbers",
                    "x, y, z; then two points and an angle");
        std::array<double, 7> result{};
        for (unsigned int k = 0; k < fields.size(); ++k)
          result[k] = fields[k].empty() ? 0. : text.number(fields[k]);
        return result;
      }

      void
      read_mesh()
      {
        if (keyword == "*NODE")
          read_nodes();
        else if (keyword == "*ELEMENT")
          read_elements();
        else if (keyword == "*NSET")
          read_set(node_sets, need("NSET"));
        else if (keyword == "*ELSET")
          read_set(element_sets, need("ELSET"));
        else if (keyword == "*SURFACE" && (options.count("TYPE") == 0 || options["TYPE"] == "ELEMENT"))
          read_surface();
      }

      // Cells of other kinds than hexahedra, too. Of the whole file, or *PART, or of an element set.
      void
      keep_cells()
      {
        const bool           all = part.empty() || part == assembly.part || part == assembly.instance;
        std::set<long>       of_part;
        const std::set<long> ids(cell_ids.begin(), cell_ids.end());
        for (const AbaqusSet &s : element_sets.all)
          if (!all)
            {
              const auto members = element_sets.members(s.name, text);
              if (upper_case(s.name) == part)
                of_part.insert(members.begin(), members.end());
              if (std::any_of(
                      members.begin(), members.end(), [&](const long id) { return ids.count(id) > 0; }))
                mesh.parts.insert(s.name);
            }
        std::vector<FileMesh::Cell> cells;
        for (unsigned int c = 0; c < mesh.cells.size(); ++c)
          if (all || of_part.count(cell_ids[c]) > 0)
            cells.push_back(mesh.cells[c]);
        mesh.cells = cells;
        for (const OtherElement &other : others)
          if (all || of_part.count(other.id) > 0)
            mesh.add_other(other.kind, other.line);
      }

      bool
      is_keyword() const
      {
        return text.line().size() > 1 && text.line()[0] == '*' && text.line()[1] != '*';
      }

      // "*ELEMENT, TYPE=CPE4, ELSET=all": the keyword and its options; values keep their case in `values`.
      void
      read_keyword()
      {
        options.clear();
        values.clear();
        keyword.clear();
        for (bool more = true; more;)
          {
            more = text.line().back() == ',';
            for (const auto &field : text.fields(','))
              if (keyword.empty())
                {
                  keyword = upper_case(field);
                  keyword.erase(std::remove(keyword.begin(), keyword.end(), ' '), keyword.end());
                }
              else
                {
                  const std::size_t equals = std::min(field.find('='), field.size());
                  std::string       name   = upper_case(field.substr(0, equals));
                  std::string       value(equals < field.size() ? field.substr(equals + 1) : "");
                  name.erase(name.find_last_not_of(' ') + 1);
                  value.erase(0, value.find_first_not_of(" \""));
                  value.erase(value.find_last_not_of(" \"") + 1);
                  options[name] = upper_case(value);
                  values[name]  = value;
                }
            if (more && !text.next_line())
              more = false;
          }
      }

      std::string
      need(const std::string &option) const
      {
        const auto entry = values.find(option);
        if (entry == values.end() || entry->second.empty())
          text.fail(keyword + " without " + option, option + " = NAME");
        return entry->second;
      }

      // The next line of data before the next keyword.
      bool
      next_data_line()
      {
        while (text.next_line())
          if (is_keyword())
            {
              text.unread_line();
              return false;
            }
          else if (!text.line().empty() && text.line()[0] != '*')
            return true;
        return false;
      }

      void
      read_nodes()
      {
        const std::string in_set = values.count("NSET") ? values["NSET"] : "";
        while (next_data_line())
          {
            const auto fields = text.fields(',');
            if (fields.size() < 3)
              text.fail("a node with " + std::to_string(fields.size()) + " numbers", "number, x, y, z");
            const long id = text.integer(fields[0]);
            mesh.add_node(id,
                          {text.number(fields[1]),
                           text.number(fields[2]),
                           fields.size() > 3 && !fields[3].empty() ? text.number(fields[3]) : 0.},
                          text);
            if (!in_set.empty())
              node_sets.at(in_set).ids.push_back(id);
          }
      }

      void
      read_elements()
      {
        const AbaqusElementType &t      = abaqus_element_type(need("TYPE"), text);
        const std::string        in_set = values.count("ELSET") ? values["ELSET"] : "";
        while (next_data_line())
          {
            const int         line = text.line_number();
            std::vector<long> numbers;
            do
              for (const auto &field : text.fields(','))
                numbers.push_back(text.integer(field));
            while (numbers.size() < 1 + t.n_nodes && next_data_line());
            if (numbers.size() != 1 + t.n_nodes)
              text.fail("an element with " + std::to_string(numbers.size() - 1) + " nodes",
                        std::to_string(t.n_nodes) + " nodes for " + t.name);
            add_element(t, numbers, line);
            if (!in_set.empty())
              element_sets.at(in_set, true).ids.push_back(numbers[0]);
          }
      }

      void
      add_element(const AbaqusElementType &t, const std::vector<long> &numbers, const int line)
      {
        if (t.dim > dim)
          text.fail("three-dimensional elements in a two-dimensional scene", "CPE4, CPS4 or CAX4");
        Element element{t.dim, {}};
        for (unsigned int v = 0; v < t.n_corners; ++v)
          element.nodes[v] = mesh.node(numbers[1 + v], text);
        if (t.dim == 1) // the node in the middle of a line of three stands between the ends
          element.nodes[1] = mesh.node(numbers[t.n_nodes], text);
        if (t.kind != nullptr)
          {
            if (t.dim == dim)
              others.push_back({numbers[0], t.kind, line});
            return;
          }
        if (!elements.emplace(numbers[0], element).second)
          text.fail("element " + std::to_string(numbers[0]) + " is defined twice", "one line per element");
        if (t.dim != dim)
          return;
        mesh.cells.push_back({element.nodes, line});
        cell_ids.push_back(numbers[0]);
        std::vector<unsigned int> middle;
        for (unsigned int v = t.n_corners; v < t.n_nodes; ++v)
          middle.push_back(mesh.node(numbers[1 + v], text));
        mesh.add_middle_nodes(
            mesh.cells.back(), middle, dim == 2 ? abaqus_quadrilateral_edges : abaqus_hexahedron_edges, {});
      }

      // A name or a number; "PART-1-1.NAME" is NAME.
      std::string_view
      without_instance(const std::string_view field) const
      {
        const std::size_t dot = field.rfind('.');
        return dot == std::string_view::npos ? field : field.substr(dot + 1);
      }

      static bool
      is_number(const std::string_view field)
      {
        return !field.empty() &&
               std::all_of(field.begin(), field.end(), [](unsigned char c) { return std::isdigit(c); });
      }

      void
      read_set(AbaqusSets &sets, const std::string &name)
      {
        const bool generate = options.count("GENERATE") > 0;
        AbaqusSet &target   = sets.at(name);
        if (assembly.is_of_another_instance(options["INSTANCE"]))
          return; // a set without members here, which surfaces may name
        while (next_data_line())
          {
            const auto fields = text.fields(',');
            if (generate)
              {
                if (fields.size() < 2)
                  text.fail("a range of one number", "first, last, increment");
                const long last = text.integer(fields[1]);
                const long step = fields.size() > 2 ? text.integer(fields[2]) : 1;
                if (step <= 0 || last - text.integer(fields[0]) > 1000000000)
                  text.fail("a range without end", "first, last, increment > 0");
                for (long id = text.integer(fields[0]); id <= last; id += step)
                  target.ids.push_back(id);
              }
            else
              for (const auto &field : fields)
                if (assembly.is_of_another_instance(field.substr(0, field.rfind('.'))))
                  continue;
                else if (const auto entry = without_instance(field); is_number(entry))
                  target.ids.push_back(text.integer(entry));
                else if (!entry.empty())
                  target.sets.push_back(entry);
          }
      }

      unsigned int
      name_index(const std::string &name)
      {
        for (unsigned int i = 0; i < mesh.names.size(); ++i)
          if (upper_case(mesh.names[i]) == upper_case(name))
            return i;
        mesh.names.push_back(name);
        return mesh.names.size() - 1;
      }

      // Lines "SET or NUMBER, S1".
      void
      read_surface()
      {
        const unsigned int name  = name_index(need("NAME"));
        const auto        &faces = abaqus_faces(dim);
        while (next_data_line())
          {
            const auto fields = text.fields(',');
            const auto face   = fields.size() < 2 ? std::string() : upper_case(fields[1]);
            if (face.size() != 2 || face[0] != 'S' || face[1] < '1' || face[1] > char('0' + faces.size()))
              text.fail("a surface on face '" + face + "'", "S1 to S" + std::to_string(faces.size()));
            if (assembly.is_of_another_instance(fields[0].substr(0, fields[0].rfind('.'))))
              continue;
            const auto entry = without_instance(fields[0]);
            for (const long id : is_number(entry) ? std::vector<long>{text.integer(entry)}
                                                  : element_sets.members(entry, text))
              {
                const auto element = elements.find(id);
                if (element == elements.end() && !others.empty())
                  continue; // a triangle or tetrahedron, which is reported in the end
                if (element == elements.end() || element->second.dim != dim)
                  text.fail("there is no cell " + std::to_string(id), "surfaces of the elements above");
                FileMesh::Face f{{}, name};
                for (unsigned int v = 0; v < faces[face[1] - '1'].size(); ++v)
                  f.nodes[v] = element->second.nodes[faces[face[1] - '1'][v]];
                mesh.faces.push_back(f);
              }
          }
      }

      // Those of *ELSET before those of *ELEMENT: gmsh names the latter Line1, Surface1, ... by its entities.
      void
      add_element_sets()
      {
        for (const bool of_element : {false, true})
          for (const AbaqusSet &s : element_sets.all)
            if (s.of_element == of_element)
              for (const long id : element_sets.members(s.name, text))
                if (const auto element = elements.find(id);
                    element != elements.end() && element->second.dim == dim - 1)
                  {
                    FileMesh::Face face{{}, name_index(s.name)};
                    std::copy_n(element->second.nodes.begin(), 4, face.nodes.begin());
                    mesh.faces.push_back(face);
                  }
      }

      // Faces all of whose corners are in the set; a set of all nodes of cells is no boundary.
      void
      add_node_sets()
      {
        const auto &faces = abaqus_faces(dim);
        for (const AbaqusSet &s : node_sets.all)
          {
            std::vector<bool> inside(mesh.nodes.size(), false);
            for (const long id : node_sets.members(s.name, text))
              inside[mesh.node(id, text)] = true;
            if (std::all_of(mesh.cells.begin(), mesh.cells.end(), [&](const auto &cell) {
                  return std::all_of(cell.nodes.begin(), cell.nodes.begin() + (1 << dim), [&](const auto v) {
                    return inside[v];
                  });
                }))
              continue;
            for (const auto &cell : mesh.cells)
              for (const auto &corners : faces)
                if (std::all_of(corners.begin(), corners.end(), [&](const unsigned int v) {
                      return inside[cell.nodes[v]];
                    }))
                  {
                    FileMesh::Face face{{}, name_index(s.name)};
                    for (unsigned int v = 0; v < corners.size(); ++v)
                      face.nodes[v] = cell.nodes[corners[v]];
                    mesh.faces.push_back(face);
                  }
          }
      }

      MeshText                          &text;
      const unsigned int                 dim;
      FileMesh                           mesh;
      const std::string                  part; // in upper case, as are the names of parts and instances
      std::string                        inside, in_instance;
      std::array<double, 7>              shift = {}, turn = {};
      AbaqusAssembly                     assembly;
      std::unordered_map<long, Element>  elements;
      std::vector<long>                  cell_ids;
      std::vector<OtherElement>          others;
      AbaqusSets                         node_sets, element_sets;
      std::string                        keyword;
      std::map<std::string, std::string> options, values;
    };
  } // namespace

  FileMesh
  parse_abaqus(MeshText &text, const unsigned int dim, const std::string &part)
  {
    return AbaqusParser(text, dim, part).parse();
  }
} // namespace Amontons

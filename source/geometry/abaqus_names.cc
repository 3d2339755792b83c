#include <amontons/geometry/abaqus.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    const std::vector<AbaqusElementType> element_types = {
        {"CPE4", 2, 4, 4, nullptr},        {"CPS4", 2, 4, 4, nullptr},       {"CAX4", 2, 4, 4, nullptr},
        {"CGAX4", 2, 4, 4, nullptr},       {"S4", 2, 4, 4, nullptr},         {"M3D4", 2, 4, 4, nullptr},
        {"R3D4", 2, 4, 4, nullptr},        {"SFM3D4", 2, 4, 4, nullptr},     {"CPE8", 2, 4, 8, nullptr},
        {"CPS8", 2, 4, 8, nullptr},        {"CAX8", 2, 4, 8, nullptr},       {"CGAX8", 2, 4, 8, nullptr},
        {"S8", 2, 4, 8, nullptr},          {"M3D8", 2, 4, 8, nullptr},       {"M3D9", 2, 4, 9, nullptr},
        {"CPE3", 2, 3, 3, "triangles"},    {"CPS3", 2, 3, 3, "triangles"},   {"CAX3", 2, 3, 3, "triangles"},
        {"S3", 2, 3, 3, "triangles"},      {"STRI3", 2, 3, 3, "triangles"},  {"M3D3", 2, 3, 3, "triangles"},
        {"CPE6", 2, 3, 6, "triangles"},    {"CPS6", 2, 3, 6, "triangles"},   {"CAX6", 2, 3, 6, "triangles"},
        {"M3D6", 2, 3, 6, "triangles"},    {"STRI65", 2, 3, 6, "triangles"}, {"C3D8", 3, 8, 8, nullptr},
        {"C3D20", 3, 8, 20, nullptr},      {"C3D27", 3, 8, 27, nullptr},     {"C3D4", 3, 4, 4, "tetrahedra"},
        {"C3D10", 3, 4, 10, "tetrahedra"}, {"C3D6", 3, 6, 6, "prisms"},      {"C3D15", 3, 6, 15, "prisms"},
        {"T2D2", 1, 2, 2, nullptr},        {"T3D2", 1, 2, 2, nullptr},       {"T3D3", 1, 2, 3, nullptr},
        {"B21", 1, 2, 2, nullptr},         {"B31", 1, 2, 2, nullptr},        {"R2D2", 1, 2, 2, nullptr},
        {"RAX2", 1, 2, 2, nullptr},        {"SAX1", 1, 2, 2, nullptr},       {"MAX1", 1, 2, 2, nullptr},
        {"SFMAX1", 1, 2, 2, nullptr}};

    // The corners of face S1, S2, ... of quadrilaterals and hexahedra.
    const std::vector<std::vector<unsigned int>> quadrilateral_faces = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    const std::vector<std::vector<unsigned int>> hexahedron_faces    = {
           {0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  } // namespace

  std::string
  upper_case(const std::string_view s)
  {
    std::string result(s);
    for (char &c : result)
      c = std::toupper(static_cast<unsigned char>(c));
    return result;
  }

  const AbaqusElementType &
  abaqus_element_type(const std::string &type, const MeshText &text)
  {
    const std::string name = upper_case(type);
    for (const AbaqusElementType &t : element_types)
      {
        const std::size_t n = std::string(t.name).size();
        if (name.compare(0, n, t.name) == 0 && (name.size() == n || !std::isdigit(name[n])))
          return t;
      }
    text.fail("elements of type " + name,
              "CPE4, CPS4, CAX4, CPE8, CPS8, CAX8, C3D8, C3D20, C3D27 (or S4, T3D2, ... on boundaries)");
  }

  const std::vector<std::vector<unsigned int>> &
  abaqus_faces(const unsigned int dim)
  {
    return dim == 2 ? quadrilateral_faces : hexahedron_faces;
  }

  bool
  AbaqusAssembly::choose(const std::string &name)
  {
    if (instances.count(name) > 0)
      {
        instance = name;
        part     = part_of.at(name);
        return true;
      }
    if (parts.size() > 1 && parts.count(name) == 0)
      return false;
    if (!parts.empty())
      part = parts.size() == 1 ? parts.begin()->first : name;
    unsigned int n_instances = 0;
    for (const auto &[of, its_part] : part_of)
      if (its_part == part)
        {
          instance = of;
          ++n_instances;
        }
    return n_instances < 2;
  }

  bool
  AbaqusAssembly::is_of_another_part(const std::string &name) const
  {
    return !name.empty() && !part.empty() && name != part;
  }

  bool
  AbaqusAssembly::is_of_another_instance(const std::string_view name) const
  {
    const std::string upper = upper_case(name);
    return instances.count(upper) > 0 && upper != instance;
  }

  std::set<std::string>
  AbaqusAssembly::names() const
  {
    std::set<std::string> result;
    for (const auto &[part, written] : parts)
      {
        std::set<std::string> of_part;
        for (const auto &[of, its_part] : part_of)
          if (its_part == part)
            of_part.insert(instances.at(of));
        if (of_part.size() < 2)
          of_part = {written};
        result.insert(of_part.begin(), of_part.end());
      }
    return result;
  }

  AbaqusSet &
  AbaqusSets::at(const std::string &name, const bool of_element)
  {
    for (AbaqusSet &s : all)
      if (upper_case(s.name) == upper_case(name))
        return s;
    all.push_back({name, {}, {}, of_element});
    return all.back();
  }

  std::vector<long>
  AbaqusSets::members(const std::string_view name, const MeshText &text, const unsigned int depth) const
  {
    std::vector<std::string> names;
    for (const AbaqusSet &s : all)
      names.push_back(s.name);
    const auto same = std::find_if(
        names.begin(), names.end(), [&](const std::string &n) { return upper_case(n) == upper_case(name); });
    if (same == names.end() || depth > 10)
      text.fail("there is no set '" + std::string(name) + "'" + suggestion(std::string(name), names));

    const AbaqusSet  &s      = all[same - names.begin()];
    std::vector<long> result = s.ids;
    for (const auto &other : s.sets)
      {
        const auto more = members(other, text, depth + 1);
        result.insert(result.end(), more.begin(), more.end());
      }
    return result;
  }
} // namespace Amontons

#include <amontons/scene/scene_reader.h>
#include <amontons/scene/load_program.h>
#include <amontons/scene/scene_checks.h>
#include <amontons/scene/scene_declarations.h>
#include <amontons/scene/section_readers.h>

#include <tuple>

namespace Amontons
{
  namespace
  {
    void
    read_top_level(const SceneInput &input, Scene &scene)
    {
      const SectionInput top(input, "", ""), reference(input, "Reference", "");
      scene.title = top.text("Title");
      scene.file  = input.file;
      std::string allowed;
      const auto  units = read_units(top.text("Units"), allowed);
      if (!units)
        top.fail("Units", "found '" + top.text("Units") + "'", allowed);
      scene.units                  = *units;
      scene.kind                   = input.kind;
      const std::string kinematics = top.text("Kinematics");
      scene.kinematics             = kinematics == "small strain"    ? Kinematics::small_strain
                                     : kinematics == "finite strain" ? Kinematics::finite_strain
                                                                     : Kinematics::automatic;
      scene.full_model             = top.text("Model") == "full";
      for (const OutlineEntry &entry : input.outline.entries)
        if (entry.section != "Output")
          scene.entries.push_back(path_of(entry.section, entry.name) + " = " + entry.value);
      read_load_program(top, scene);
      if (reference.is_given("Solution"))
        scene.reference = ReferenceData{reference.field("Solution"), reference.text("Contact")};
      else
        reference.refuse({"Contact"}, "without Solution");
    }

    // A group reports "Entry name: found ...; allowed ..."; the entry's place is known here only.
    void
    check_groups(const ParameterGroups &groups, const SceneInput &input)
    {
      for (const ParameterGroup *const group : groups)
        try
          {
            group->check();
          }
        catch (const std::invalid_argument &failure)
          {
            const std::string text  = failure.what();
            const std::string entry = text.substr(0, text.find(": "));
            for (const OutlineEntry &candidate : input.outline.entries)
              if (candidate.name == entry && !input.is_named(candidate.section))
                throw InputError(candidate.where, text.substr(entry.size() + 2));
            throw InputError({input.file, 0, ""}, text);
          }
    }
  } // namespace

  Scene
  read_scene(const std::string              &file,
             const std::vector<std::string> &overrides,
             const ParameterGroups          &groups,
             const BoundaryFields           &fields)
  {
    const SceneInput input(file, overrides, groups);
    Scene            scene;
    scene.boundary_fields = fields;
    read_top_level(input, scene);
    for (const SectionInput &section : input.sections("Body"))
      scene.bodies.push_back(read_body(section));
    for (const SectionInput &section : input.sections("Obstacle"))
      scene.obstacles.push_back(read_obstacle(section));
    for (const SectionInput &section : input.sections("Boundary condition"))
      scene.conditions.push_back(read_condition(section));
    for (const SectionInput &section : input.sections("Contact"))
      scene.pairs.push_back(read_pair(section));
    for (const SectionInput &section : input.sections("Probe"))
      scene.probes.push_back(read_probe(section));
    find_corner_times(scene);
    scene.is_loaded_at_start = let_loads_grow_before_start(scene);
    check_scene(scene);
    check_groups(groups, input);
    return scene;
  }

  std::set<std::string>
  Scene::files() const
  {
    std::set<std::string> names;
    for (const auto &body : bodies)
      {
        names.insert(body.mesh_file);
        for (const auto &surface : body.true_geometry)
          names.insert(surface.second.file);
      }
    names.erase("");
    return names;
  }

  // A small valid scene: a block on a plane. Entries without a default have a value here.
  void
  print_parameters(std::ostream &out, const ParameterGroups &groups)
  {
    const std::vector<std::tuple<std::string, std::string, std::string>> values = {
        {"Body BODY", "Lower corner", "0, 0, 0"},
        {"Body BODY", "Upper corner", "1, 1, 1"},
        {"Body BODY", "Young modulus", "1"},
        {"Body BODY", "Poisson ratio", "0.3"},
        {"Boundary condition TOP", "Boundaries", "BODY/top"},
        {"Boundary condition TOP", "Value", "0; -0.01*t"},
        {"Contact PAIR", "First", "BODY/bottom"},
        {"Contact PAIR", "Second", "OBSTACLE"},
        {"Probe PROBE", "Body", "BODY"},
        {"Probe PROBE", "Point", "0.5, 0.5"}};
    const std::vector<std::string> names = {"BODY", "OBSTACLE", "TOP", "PAIR", "PROBE"};

    dealii::ParameterHandler prm;
    declare_top_level(prm);
    for (std::size_t i = 0; i < names.size(); ++i)
      {
        prm.enter_subsection(named_sections()[i].prefix + " " + names[i]);
        named_sections()[i].declare(prm);
        prm.leave_subsection();
      }
    for (ParameterGroup *const group : groups)
      group->declare(prm);
    for (const auto &[section, entry, value] : values)
      {
        prm.enter_subsection(section);
        prm.set(entry, value);
        prm.leave_subsection();
      }
    prm.print_parameters(out, dealii::ParameterHandler::PRM | dealii::ParameterHandler::KeepDeclarationOrder);
  }
} // namespace Amontons

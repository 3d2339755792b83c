#include <amontons/scene/scene_checks.h>

#include <algorithm>
#include <tuple>

namespace Amontons
{
  namespace
  {
    template <typename Data>
    std::vector<std::string>
    names_of(const std::vector<Data> &items)
    {
      std::vector<std::string> names;
      names.reserve(items.size());
      for (const Data &item : items)
        names.push_back(item.name);
      return names;
    }

    std::string
    list(const std::string &what, const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? what + " " : ", ") + name;
      return names.empty() ? "there is no " + what + " in this scene" : text;
    }

    const BodyData &
    find_body(const Scene &scene, const std::string &name, const SourceLocation &where)
    {
      for (const BodyData &body : scene.bodies)
        if (body.name == name)
          return body;
      const std::vector<std::string> names = names_of(scene.bodies);
      throw InputError(where,
                       name.empty() ? "the body is missing"
                                    : "unknown body '" + name + "'" + suggestion(name, names),
                       list("body", names));
    }

    // Motions are found by name later on.
    void
    check_motion_names(const Scene &scene)
    {
      std::vector<const MotionData *> motions;
      for (const BodyData &body : scene.bodies)
        if (body.rigid)
          motions.push_back(&*body.rigid);
      for (const ObstacleData &obstacle : scene.obstacles)
        motions.push_back(&obstacle.motion);
      for (const ConditionData &condition : scene.conditions)
        if (condition.motion)
          motions.push_back(&*condition.motion);
      for (std::size_t i = 0; i < motions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (motions[i]->name == motions[j]->name)
            throw InputError(
                motions[i]->where,
                "the name '" + motions[i]->name + "' is taken by " + motions[j]->where.entry +
                    (motions[j]->where.line > 0 ? ", line " + std::to_string(motions[j]->where.line) : ""),
                "different names for all rigid bodies, obstacles and platens");
    }

    // Two conditions that give the same boundary different displacements: the first would count.
    void
    check_displacements(const ConditionData &condition, const ConditionData &before)
    {
      using Type = ConditionData::Type;
      if (condition.type != Type::displacement || before.type != Type::displacement)
        return;
      for (const BoundaryName &boundary : condition.boundaries)
        for (const BoundaryName &other : before.boundaries)
          for (unsigned int c = 0; c < 3; ++c)
            if (const auto &now = condition.displacement[c], &first = before.displacement[c];
                boundary.body == other.body && boundary.boundary == other.boundary && now && first &&
                now->text() != first->text())
              throw InputError(
                  condition.where,
                  std::string(1, "xyz"[c]) + " of '" + boundary.body + "/" + boundary.boundary +
                      "' is moved by " + now->text() + ", and by " + first->text() + " in " +
                      before.where.entry +
                      (before.where.line > 0 ? ", line " + std::to_string(before.where.line) : ""),
                  "one displacement of each component of a boundary");
    }

    void
    check_conditions(const Scene &scene)
    {
      for (std::size_t i = 0; i < scene.conditions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          check_displacements(scene.conditions[i], scene.conditions[j]);
      for (const ConditionData &condition : scene.conditions)
        for (const BoundaryName &boundary : condition.boundaries)
          {
            if (find_body(scene, boundary.body, boundary.where).rigid)
              throw InputError(
                  boundary.where,
                  "the body '" + boundary.body + "' is rigid",
                  "deformable bodies; a rigid one has Displacement, Force, Rotation, Moment of its own");
            const auto same = [&](const BoundaryName &other) {
              return other.body == boundary.body && other.boundary == boundary.boundary;
            };
            if (std::count_if(condition.boundaries.begin(), condition.boundaries.end(), same) > 1)
              throw InputError(boundary.where,
                               "'" + boundary.body + "/" + boundary.boundary + "' stands here twice",
                               "each boundary once");
          }
    }

    void
    check_obstacle_pair(const Scene &scene, PairData &pair, const bool first_is_rigid)
    {
      const std::vector<std::string> names = names_of(scene.obstacles), bodies = names_of(scene.bodies);
      if (std::find(bodies.begin(), bodies.end(), pair.obstacle) != bodies.end() &&
          std::find(names.begin(), names.end(), pair.obstacle) == names.end())
        throw InputError(pair.where,
                         "Second names the body '" + pair.obstacle + "' without a boundary",
                         pair.obstacle + "/BOUNDARY");
      if (std::find(names.begin(), names.end(), pair.obstacle) == names.end())
        throw InputError(pair.where,
                         "unknown obstacle '" + pair.obstacle + "' as Second" +
                             suggestion(pair.obstacle, names),
                         list("obstacle", names) + "; or BODY/BOUNDARY");
      if (pair.slave == PairData::Slave::second)
        throw InputError(pair.where, "Slave = second, but Second is an obstacle", "automatic or first");
      if (first_is_rigid)
        throw InputError(pair.where,
                         "the body '" + pair.first.body + "' is rigid, as is the obstacle",
                         "at least one deformable side");
      pair.slave = PairData::Slave::first;
    }

    void
    check_body_pair(const Scene &scene, PairData &pair, const bool first_is_rigid)
    {
      using Slave                = PairData::Slave;
      const BoundaryName &second = *pair.second;
      const bool second_is_rigid = static_cast<bool>(find_body(scene, second.body, second.where).rigid);
      if (second.body == pair.first.body)
        throw InputError(second.where,
                         second.boundary == pair.first.boundary
                             ? "First and Second are the same boundary (slave = master)"
                             : "First and Second are boundaries of one body; self contact is not supported",
                         "boundaries of two bodies");
      if (first_is_rigid && second_is_rigid)
        throw InputError(pair.where, "both bodies are rigid", "at least one deformable side");
      const std::string rule = "a rigid body is always the master: leave Slave at automatic";
      if (first_is_rigid && pair.slave == Slave::first)
        throw InputError(pair.where, "Slave = first, but '" + pair.first.body + "' is rigid", rule);
      if (second_is_rigid && pair.slave == Slave::second)
        throw InputError(pair.where, "Slave = second, but '" + second.body + "' is rigid", rule);
      if (first_is_rigid)
        pair.slave = Slave::second;
      if (second_is_rigid)
        pair.slave = Slave::first;
    }

    // The same two surfaces twice would be pressed together twice.
    void
    check_repetition(const std::vector<PairData> &pairs)
    {
      const auto sides = [](const PairData &pair) {
        std::array<std::string, 2> names = {
            {pair.first.body + "/" + pair.first.boundary,
             pair.second ? pair.second->body + "/" + pair.second->boundary : pair.obstacle}};
        std::sort(names.begin(), names.end());
        return names;
      };
      for (std::size_t i = 0; i < pairs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (sides(pairs[i]) == sides(pairs[j]))
            throw InputError(pairs[i].where,
                             "the same two surfaces as in " + pairs[j].where.entry,
                             "each pair of surfaces once");
    }
    // Of a file a body takes all cells of its part.
    void
    check_mesh_files(const std::vector<BodyData> &bodies)
    {
      const auto place = [](const BodyData &body) {
        return std::make_tuple(body.mesh_file,
                               body.rotation_angle,
                               Point<3>(body.rotation_axis),
                               body.rotation_centre,
                               body.shift);
      };
      for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (bodies[i].shape == "file" && bodies[j].shape == "file" &&
              place(bodies[i]) == place(bodies[j]) &&
              (bodies[i].part == bodies[j].part || bodies[i].part.empty() || bodies[j].part.empty()))
            throw InputError(
                bodies[i].where,
                "the same mesh file in the same place as body '" + bodies[j].name + "'",
                "for each body a 'Part' of the file (a physical group, an element set) or a file "
                "of its own, or another place");
    }
  } // namespace

  void
  check_scene(Scene &scene)
  {
    if (scene.bodies.empty())
      throw InputError({scene.file, 0, ""}, "the scene has no body", "at least one section 'Body NAME'");
    check_mesh_files(scene.bodies);
    check_motion_names(scene);
    check_conditions(scene);
    for (PairData &pair : scene.pairs)
      {
        const bool first_is_rigid =
            static_cast<bool>(find_body(scene, pair.first.body, pair.first.where).rigid);
        if (pair.second)
          check_body_pair(scene, pair, first_is_rigid);
        else
          check_obstacle_pair(scene, pair, first_is_rigid);
      }
    check_repetition(scene.pairs);
    for (const ProbeData &probe : scene.probes)
      find_body(scene, probe.body, probe.where);
    if (scene.reference && !scene.reference->pair.empty())
      {
        const std::string              name  = scene.reference->pair;
        const std::vector<std::string> pairs = names_of(scene.pairs);
        if (std::find(pairs.begin(), pairs.end(), name) == pairs.end())
          throw InputError(scene.reference->solution.where,
                           "unknown contact '" + name + "'" + suggestion(name, pairs),
                           list("contact", pairs));
      }
  }
} // namespace Amontons

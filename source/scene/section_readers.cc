#include <amontons/scene/section_readers.h>
#include <amontons/scene/text.h>

#include <deal.II/base/utilities.h>

namespace Amontons
{
  BoundaryName
  read_boundary_name(const SectionInput &section, const std::string &entry, const std::string &text)
  {
    const auto   slash = text.find('/');
    BoundaryName name;
    name.where = section.where(entry);
    if (slash != std::string::npos)
      {
        name.body     = trim(text.substr(0, slash));
        name.boundary = trim(text.substr(slash + 1));
      }
    if (name.body.empty() || name.boundary.empty())
      section.fail(entry, "found '" + text + "'", "BODY/BOUNDARY");
    return name;
  }

  ObstacleData
  read_obstacle(const SectionInput &section)
  {
    using Type = ObstacleData::Type;
    ObstacleData obstacle;
    obstacle.name             = section.name;
    obstacle.where            = section.where();
    const std::string surface = section.text("Surface");
    obstacle.type             = surface == "plane"        ? Type::plane
                                : surface == "cylinder"   ? Type::cylinder
                                : surface == "paraboloid" ? Type::paraboloid
                                : surface == "cone"       ? Type::cone
                                                          : Type::sphere;
    const bool        round   = obstacle.type == Type::sphere || obstacle.type == Type::cylinder;
    const std::string context = "for Surface = " + surface;

    obstacle.centre = section.point("Centre");
    if (round)
      section.refuse({"Normal", "Half width"}, context);
    else
      {
        section.refuse({"Hollow"}, context);
        obstacle.normal = section.direction("Normal");
        obstacle.size   = section.number("Half width");
      }
    if (obstacle.type == Type::cylinder && section.dim() == 3)
      obstacle.axis = section.direction("Axis");
    else
      section.refuse({"Axis"}, obstacle.type == Type::cylinder ? "in 2D, where it is a circle" : context);
    if (round || obstacle.type == Type::paraboloid)
      {
        section.require({"Radius"}, context);
        obstacle.radius = section.positive_number("Radius");
      }
    else
      section.refuse({"Radius"}, context);
    if (obstacle.type == Type::cone)
      {
        section.require({"Flank angle"}, context);
        obstacle.flank = section.positive_number("Flank angle");
      }
    else
      section.refuse({"Flank angle"}, context);
    if (obstacle.type == Type::cone && obstacle.flank >= 90)
      section.fail("Flank angle", "found " + section.text("Flank angle"), "between 0 and 90 degrees");
    obstacle.hollow = section.flag("Hollow");
    obstacle.motion = read_motion(section);
    return obstacle;
  }

  // A contact surface: one boundary, or a list of boundaries of one body that continue each other.
  static BoundaryName
  read_surface(const SectionInput &section, const std::string &entry, const std::string &text)
  {
    BoundaryName surface;
    for (const auto &part : dealii::Utilities::split_string_list(text, ','))
      {
        const BoundaryName name = read_boundary_name(section, entry, part);
        if (surface.body.empty())
          surface = name;
        else if (name.body != surface.body)
          section.fail(entry, "boundaries of two bodies", "a list of boundaries of one body");
        else
          surface.more.push_back(name.boundary);
      }
    if (surface.body.empty())
      return read_boundary_name(section, entry, text);
    return surface;
  }

  // A bound of shear tractions; nothing if the entry is empty.
  static std::optional<Expression>
  read_bound(const SectionInput &section, const std::string &entry)
  {
    const std::string text = section.text(entry);
    if (text.empty())
      return {};
    const Expression bound = section.expression(entry, text, SectionInput::Of::place_time_and_pressure);
    if (bound.is_constant() && bound.value(Point<3>(), 0) < 0)
      section.fail(entry,
                   "found " + text + ", a negative bound",
                   "0, a positive number, or an expression of the place, t and p");
    return bound;
  }

  // A bound that is the constant zero leaves no friction at all.
  static void
  read_friction(const SectionInput &section, PairData &pair)
  {
    if (pair.tied)
      section.refuse({"Friction coefficient", "Tresca bound"}, "for Tied = true");
    pair.friction     = read_bound(section, "Friction coefficient");
    pair.tresca_bound = read_bound(section, "Tresca bound");
    if ((pair.friction && pair.friction->is_zero()) || (pair.tresca_bound && pair.tresca_bound->is_zero()))
      {
        pair.friction.reset();
        pair.tresca_bound.reset();
      }
  }

  PairData
  read_pair(const SectionInput &section)
  {
    PairData pair;
    pair.name                = section.name;
    pair.where               = section.where();
    pair.first               = read_surface(section, "First", section.text("First"));
    const std::string second = section.text("Second");
    if (second.empty())
      section.fail("Second", "found nothing", "BODY/BOUNDARY, or the name of an obstacle");
    if (second.find('/') == std::string::npos)
      pair.obstacle = second;
    else
      pair.second = read_surface(section, "Second", second);

    const std::string slave = section.text("Slave");
    pair.slave              = slave == "first"    ? PairData::Slave::first
                              : slave == "second" ? PairData::Slave::second
                                                  : PairData::Slave::automatic;
    pair.tied               = section.flag("Tied");
    if (pair.tied)
      section.refuse({"Initial gap"}, "for Tied = true: what is glued stays as far apart as the meshes are");
    if (!section.text("Initial gap").empty())
      pair.initial_gap = section.expression("Initial gap", section.text("Initial gap"));
    pair.adjust = section.number("Adjust");
    read_friction(section, pair);
    return pair;
  }

  ProbeData
  read_probe(const SectionInput &section)
  {
    ProbeData probe;
    probe.name  = section.name;
    probe.where = section.where();
    probe.body  = section.text("Body");
    if (section.is_given("Point"))
      {
        section.refuse({"From", "To", "Points"}, "beside Point");
        probe.from = probe.to = section.point("Point");
        return probe;
      }
    if (!section.is_given("From") || !section.is_given("To"))
      throw InputError(probe.where, "the probe has no place", "Point = x, y[, z], or From, To and Points");
    probe.from     = section.point("From");
    probe.to       = section.point("To");
    probe.n_points = static_cast<unsigned int>(section.number("Points"));
    return probe;
  }
} // namespace Amontons

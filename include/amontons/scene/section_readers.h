// From the texts of one section to its data; checks what concerns this section alone. All throw InputError.
#pragma once

#include <amontons/scene/scene_input.h>

namespace Amontons
{
  BodyData
  read_body(const SectionInput &section);
  ObstacleData
  read_obstacle(const SectionInput &section);
  ConditionData
  read_condition(const SectionInput &section);
  PairData
  read_pair(const SectionInput &section); // a name without '/' in `second` is left in `obstacle`
  ProbeData
  read_probe(const SectionInput &section);

  // The motion entries of a section, for the motion of its name.
  MotionData
  read_motion(const SectionInput &section);

  // "BODY/BOUNDARY" at `entry`.
  BoundaryName
  read_boundary_name(const SectionInput &section, const std::string &entry, const std::string &text);
} // namespace Amontons

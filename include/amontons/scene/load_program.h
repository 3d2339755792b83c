// The times of the load program: end, steps to start with, and times at which an increment must end.
#pragma once

#include <amontons/scene/scene_input.h>

namespace Amontons
{
  // End time, Increments, Minimum increment and Output times. Throws InputError.
  void
  read_load_program(const SectionInput &top, Scene &scene);

  // Times in (0, end_time) at which an expression of a load, a motion, a boundary value or a friction bound
  // has a corner: those of tables, and, with friction and automatic increments, where it turns, bends or
  // jumps (see path_corners.h). Increasing. A note where tables go on after the end.
  void
  find_corner_times(Scene &scene);

  // Loads, motions and boundary values may be applied before t = 0, from -end_time on; whether one of them is
  // there at t = 0.
  bool
  let_loads_grow_before_start(Scene &scene);
} // namespace Amontons

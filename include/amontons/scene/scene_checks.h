// What concerns several sections of a scene at once.
#pragma once

#include <amontons/scene/scene.h>

namespace Amontons
{
  // Names that refer to bodies, obstacles and pairs exist and are unique; contact pairs make sense. Settles
  // the slave of pairs with obstacles and rigid bodies, which are masters. Throws InputError.
  void
  check_scene(Scene &scene);
} // namespace Amontons

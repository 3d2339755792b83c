/// Errors against closed forms: the `Reference` (output/reference.h) that main.cc hands to ContactProblem.
#pragma once

#include <amontons/output/reference.h>

namespace Amontons
{
  // The closed form of scene.reference. Forces of models cut by symmetry planes through the contact are
  // compared as full ones. Throws InputError for one that there is not.
  template <int dim>
  std::unique_ptr<const Reference<dim>>
  make_reference(const Scene &scene);
} // namespace Amontons

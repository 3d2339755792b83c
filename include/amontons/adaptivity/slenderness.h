// How much stress may do to the stiffness of slender bodies, at most.
#pragma once

#include <amontons/elasticity/stress_recovery.h>

namespace Amontons
{
  // As in a cantilever under the load P, P over Euler's load: 48/pi^2 (sigma/E) ((L/h)^2 - 25), the largest
  // of all bodies; L is the size of all together. Where stress goes along free surfaces the body is thin:
  //   h = 2 int |s| dV / int (|s| - 2 |s n|)_+ dA
  // with the mean stress s of each cell; sigma/E is the root mean square of s/E, or of its largest
  // compression alone. Planes of symmetry are no surfaces: a half is as thick as the whole, and bends as half
  // of it does; nor is what glue covers: bodies that are tied together are one. 0: all is stout. Collective.
  struct Stiffening
  {
    double any = 0, by_compression = 0;
  };
  template <int dim>
  Stiffening
  most_stiffening(const Discretization<dim> &discretization, const StressRecovery<dim> &recovery);
} // namespace Amontons

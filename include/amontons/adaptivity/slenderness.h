// How much stress may do to the stiffness of slender bodies, at most.
#pragma once

#include <amontons/elasticity/stress_recovery.h>

namespace Amontons
{
  // As in a cantilever under the load P, P over Euler's load: 48/pi^2 (sigma/E) ((L/h)^2 - 25), the largest
  // of all bodies; L is the size of all together. Where stress goes along free surfaces the body is thin:
  //   h = 2 int |s| dV / int (|s| - 2 |s n|)_+ dA
  // with the mean stress s of each cell; sigma is its root mean square. Planes of symmetry are no surfaces: a
  // half is as thick as the whole, and bends as half of it does. 0: all is stout. Collective.
  template <int dim>
  double
  most_stiffening(const Discretization<dim> &discretization, const StressRecovery<dim> &recovery);
} // namespace Amontons

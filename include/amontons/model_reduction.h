/// No more model than the target needs: bodies that may be rigid, friction that cannot matter.
#pragma once

#include <amontons/run_control.h>
#include <amontons/run_parameters.h>
#include <amontons/scene/scene.h>

namespace Amontons
{
  /// A scene with less in it, and what was left out, with how much of the target it is worth; no notes: the
  /// scene as it is.
  struct ReducedScene
  {
    Scene                    scene;
    std::vector<std::string> notes;
  };

  /// The scene is solved on its first mesh, if there is something to look at. What would change the answer by
  /// less than a tenth of the target is left out:
  /// - A body that holds that part of the stored energy at most becomes rigid. It must be stiffer than
  ///   another one by 1/target, without curved boundaries, not slender (sides of 4:1), and its supports must
  ///   tell its motion: a platen, or displacements of all of it; on the first mesh it moves so, to that part
  ///   of the largest displacement.
  /// - Friction, if shear is nowhere more than that part of what the target looks at, 5 % of the pressure
  ///   (both in the mean square), and each pair that touches does so by as many nodes as it takes to see
  ///   that.
  /// Not in scenes with a reference, nor bodies with probes. Collective.
  template <int dim>
  ReducedScene
  reduce_model(const Scene &scene, const Parameters &parameters, RunControl &control);
} // namespace Amontons

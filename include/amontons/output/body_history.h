/// Pictures of the bodies of a 3D scene for the report: the last state, its contact, and the way there.
#pragma once

#include <amontons/output/body_surfaces.h>
#include <amontons/output/quantities.h>

namespace Amontons
{
  /// Keeps at most two states beside the last one. Nothing happens in 2D.
  template <int dim>
  class BodyHistory
  {
  public:
    /// The load program starts again: what was kept is dropped.
    void
    restart()
    {
      states.clear();
    }

    /// At the end of an increment in which bodies touch: kept are the first such state, and the first one
    /// half way from there to the end time. is_first: nothing has touched before. Collective.
    void
    add(const Answer<dim> &answer, const StressRecovery<dim> &recovery, const bool is_first);

    /// SVGs on rank 0: the bodies; where the contact is hidden, or small, a cut through it or an enlarged
    /// part; of a history the states from the first contact to this one. Collective.
    std::vector<std::string>
    pictures(const Answer<dim> &answer, const StressRecovery<dim> &recovery) const;

  private:
    struct State
    {
      double       t;
      bool         is_first;
      BodySurfaces surfaces; // on rank 0
    };
    std::vector<State> states;
  };
} // namespace Amontons

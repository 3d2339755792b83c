/// Names of the units of a scene, for labels alone: nothing is computed with them.
#pragma once

#include <optional>
#include <string>

namespace Amontons
{
  /// `Units = mm, N`. All names are empty where the scene has none.
  struct Units
  {
    std::string length, force;

    bool
    are_known() const
    {
      return !length.empty();
    }

    /// Of pressures and stresses: "MPa" (mm and N), "Pa", "psi", ..., or "N/cm^2".
    std::string
    pressure() const;
    /// Of forces: "N"; of plane scenes, per thickness: "N/mm".
    std::string
    force_of(const bool per_thickness) const;
    /// Of energies: "N mm"; of plane scenes, per thickness: "N".
    std::string
    work_of(const bool per_thickness) const;
  };

  /// "mm, N". Where that is no such text: nothing, and `allowed` says what is.
  std::optional<Units>
  read_units(const std::string &text, std::string &allowed);

  /// "pressure [MPa]"; without a unit the text alone.
  std::string
  with_unit(const std::string &text, const std::string &unit);
} // namespace Amontons

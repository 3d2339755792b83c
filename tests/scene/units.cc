// Names of units: of pressures, forces and work, and what is no pair of names.
#include "check.h"

#include <amontons/scene/units.h>

namespace test_units
{
using namespace Amontons;

void
expect(const std::string &text,
       const std::string &pressure,
       const std::string &force,
       const std::string &work,
       const bool         per_thickness = false)
{
  std::string allowed;
  const auto  units = read_units(text, allowed);
  check::is_true(units.has_value(), text + " is understood");
  if (!units)
    return;
  check::is_true(units->pressure() == pressure, text + ": pressure " + units->pressure());
  check::is_true(units->force_of(per_thickness) == force, text + ": force " + units->force_of(per_thickness));
  check::is_true(units->work_of(per_thickness) == work, text + ": work " + units->work_of(per_thickness));
}

int
main(int, char **)
{
  expect("mm, N", "MPa", "N", "N mm");
  expect(" mm ,N ", "MPa", "N/mm", "N", true);
  expect("m, N", "Pa", "N", "N m");
  expect("m, kN", "kPa", "kN", "kN m");
  expect("in, lbf", "psi", "lbf", "lbf in");
  expect("cm, N", "N/cm^2", "N", "N cm");
  expect("µm, mN", "mN/µm^2", "mN", "mN µm");
  expect("", "", "", "");
  expect("", "", "", "", true);
  for (const std::string text :
       {"mm", "mm, N, s", "mm N", "1, N", "mm, ", "N, mm", "kN, L", "L, mm", "m^2, N"})
    {
      std::string allowed;
      check::is_true(!read_units(text, allowed), text + " is refused");
      check::is_true(allowed.find("mm, N") != std::string::npos, text + ": " + allowed);
    }
  check::is_true(with_unit("pressure", "MPa") == "pressure [MPa]" && with_unit("pressure", "") == "pressure",
                 "labels");
  return check::result();
}
} // namespace test_units

#include <amontons/output/summary.h>

namespace Amontons
{
  std::string
  kind_name(const Kind kind)
  {
    switch (kind)
      {
        case Kind::plane_strain:
          return "plane strain";
        case Kind::plane_stress:
          return "plane stress";
        case Kind::axisymmetric:
          return "axisymmetric";
        default:
          return "3D";
      }
  }

  std::vector<std::string>
  stress_names(const Kind kind)
  {
    if (kind == Kind::axisymmetric)
      return {"rr", "zz", "tt", "rz"};
    if (kind == Kind::three_dimensional)
      return {"xx", "yy", "zz", "xy", "xz", "yz"};
    return {"xx", "yy", "zz", "xy"};
  }

  std::vector<std::string>
  axis_names(const Kind kind)
  {
    if (kind == Kind::axisymmetric)
      return {"r", "z"};
    if (kind == Kind::three_dimensional)
      return {"x", "y", "z"};
    return {"x", "y"};
  }
} // namespace Amontons

#include <amontons/output/summary.h>

namespace Amontons
{
  std::string
  kind_name(const ProblemType kind)
  {
    switch (kind)
      {
        case ProblemType::plane_strain:
          return "plane strain";
        case ProblemType::plane_stress:
          return "plane stress";
        case ProblemType::axisymmetric:
          return "axisymmetric";
        default:
          return "3D";
      }
  }

  std::vector<std::string>
  stress_names(const ProblemType kind)
  {
    if (kind == ProblemType::axisymmetric)
      return {"rr", "zz", "tt", "rz"};
    if (kind == ProblemType::three_dimensional)
      return {"xx", "yy", "zz", "xy", "xz", "yz"};
    return {"xx", "yy", "zz", "xy"};
  }

  std::vector<std::string>
  axis_names(const ProblemType kind)
  {
    if (kind == ProblemType::axisymmetric)
      return {"r", "z"};
    if (kind == ProblemType::three_dimensional)
      return {"x", "y", "z"};
    return {"x", "y"};
  }
} // namespace Amontons
